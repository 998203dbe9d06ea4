// glint.android.GlintLibrary
#include <glint/version.hpp>

#include "android/jni/barrier.hpp"
#include "android/jni/handles.hpp"
#include "android/jni/java.hpp"

using namespace glint::android;

extern "C" {

JNIEXPORT jstring JNICALL Java_glint_android_GlintLibrary_nativeVersion(JNIEnv *env, jclass) {
    return guarded(env, [&] { return to_java(env, glint::build_info().version); });
}

JNIEXPORT jstring JNICALL Java_glint_android_GlintLibrary_nativeInstructionSets(JNIEnv *env, jclass) {
    return guarded(env, [&] {
        std::string names;
        for (const std::string_view isa : glint::build_info().isas) {
            if (!names.empty()) names += ' ';
            names += isa;
        }
        return to_java(env, names);
    });
}

JNIEXPORT jint JNICALL Java_glint_android_GlintLibrary_nativeOpenHandles(JNIEnv *, jclass) {
    return open_handles().load();
}
}
