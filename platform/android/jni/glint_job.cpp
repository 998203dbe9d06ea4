// glint.android.GlintJob
#include <mutex>

#include "android/jni/barrier.hpp"
#include "android/jni/handles.hpp"
#include "android/jni/objects.hpp"

using namespace glint::android;

extern "C" {

JNIEXPORT jdouble JNICALL Java_glint_android_GlintJob_nativeProgress(JNIEnv *env, jclass, jlong handle) {
    return guarded(env, [&] { return Handles<JobObject>::all().at(handle)->job->progress(); });
}

JNIEXPORT jboolean JNICALL Java_glint_android_GlintJob_nativeIsDone(JNIEnv *env, jclass, jlong handle) {
    return guarded(env, [&] { return static_cast<jboolean>(Handles<JobObject>::all().at(handle)->job->is_done()); });
}

JNIEXPORT void JNICALL Java_glint_android_GlintJob_nativeCancel(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { Handles<JobObject>::all().at(handle)->job->cancel(); });
}

// seconds, primary, shadow and secondary rays
JNIEXPORT jdoubleArray JNICALL Java_glint_android_GlintJob_nativeAwait(JNIEnv *env, jclass, jlong handle) {
    return guarded(env, [&] {
        const auto job = Handles<JobObject>::all().at(handle);
        const std::lock_guard lock(job->waiting);
        const glint::RenderStatistics done = take(job->job->wait());
        const jdouble values[] = {done.seconds, static_cast<jdouble>(done.primary_rays),
                                  static_cast<jdouble>(done.shadow_rays), static_cast<jdouble>(done.secondary_rays)};
        const jdoubleArray array = env->NewDoubleArray(4);
        check(env);
        env->SetDoubleArrayRegion(array, 0, 4, values);
        return array;
    });
}

JNIEXPORT void JNICALL Java_glint_android_GlintJob_nativeClose(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] {
        // Whoever waits for the job is let go.
        if (const auto job = Handles<JobObject>::all().close(handle)) job->job->cancel();
    });
}
}
