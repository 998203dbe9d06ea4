// glint.android.GlintScene
#include <memory>
#include <stdexcept>
#include <utility>

#include <glint/read.hpp>

#include "android/jni/asset_files.hpp"
#include "android/jni/barrier.hpp"
#include "android/jni/handles.hpp"
#include "android/jni/objects.hpp"

using namespace glint::android;

namespace {

jlong open(glint::SceneFile file) {
    auto scene = std::make_shared<SceneObject>();
    scene->accel = glint::Accel::build(file.scene);
    scene->scene = std::move(file.scene);
    for (const glint::Diagnostic &warning : file.warnings) scene->warnings.push_back(warning.text());
    return Handles<SceneObject>::all().open(std::move(scene));
}

} // namespace

extern "C" {

JNIEXPORT jlong JNICALL Java_glint_android_GlintScene_nativeFromAssets(JNIEnv *env, jclass, jobject assets,
                                                                       jstring path) {
    return guarded(env, [&] {
        glint::ReadOptions options;
        options.files = std::make_shared<AssetFiles>(env, assets);
        return open(take(glint::read_scene(to_utf8(env, path), options)));
    });
}

JNIEXPORT jlong JNICALL Java_glint_android_GlintScene_nativeFromFile(JNIEnv *env, jclass, jstring path) {
    return guarded(env, [&] { return open(take(glint::read_scene(to_utf8(env, path)))); });
}

// The first file is the scene.
JNIEXPORT jlong JNICALL Java_glint_android_GlintScene_nativeFromBytes(JNIEnv *env, jclass, jobjectArray names,
                                                                      jobjectArray contents) {
    return guarded(env, [&] {
        const auto files = std::make_shared<glint::MemoryFiles>();
        std::string scene;
        for (jsize i = 0; i < env->GetArrayLength(names); ++i) {
            const auto name = static_cast<jstring>(env->GetObjectArrayElement(names, i));
            const auto bytes = static_cast<jbyteArray>(env->GetObjectArrayElement(contents, i));
            check(env);
            const std::string path = to_utf8(env, name);
            files->add(path, to_bytes(env, bytes));
            if (i == 0) scene = path;
            env->DeleteLocalRef(name);
            env->DeleteLocalRef(bytes);
        }
        glint::ReadOptions options;
        options.files = files;
        return open(take(glint::read_scene(scene, options)));
    });
}

// width, height, depth, triangles
JNIEXPORT jintArray JNICALL Java_glint_android_GlintScene_nativeFacts(JNIEnv *env, jclass, jlong handle) {
    return guarded(env, [&] {
        const glint::Scene &scene = *Handles<SceneObject>::all().at(handle)->scene;
        const glint::PictureSettings &picture = scene.picture();
        const jint facts[] = {static_cast<jint>(picture.width_px), static_cast<jint>(picture.height_px),
                              static_cast<jint>(picture.max_depth), static_cast<jint>(scene.triangle_count())};
        const jintArray array = env->NewIntArray(4);
        check(env);
        env->SetIntArrayRegion(array, 0, 4, facts);
        return array;
    });
}

JNIEXPORT jobjectArray JNICALL Java_glint_android_GlintScene_nativeWarnings(JNIEnv *env, jclass, jlong handle) {
    return guarded(env, [&] {
        const auto scene = Handles<SceneObject>::all().at(handle);
        const jclass string = env->FindClass("java/lang/String");
        check(env);
        const jobjectArray array = env->NewObjectArray(static_cast<jsize>(scene->warnings.size()), string, nullptr);
        check(env);
        for (size_t i = 0; i < scene->warnings.size(); ++i) {
            const jstring text = to_java(env, scene->warnings[i]);
            env->SetObjectArrayElement(array, static_cast<jsize>(i), text);
            env->DeleteLocalRef(text);
        }
        return array;
    });
}

JNIEXPORT void JNICALL Java_glint_android_GlintScene_nativeClose(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { Handles<SceneObject>::all().close(handle); });
}
}
