// glint.android.GlintRenderer
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <glint/isa.hpp>
#include <glint/renderer.hpp>

#include "android/jni/barrier.hpp"
#include "android/jni/handles.hpp"
#include "android/jni/objects.hpp"

using namespace glint::android;

namespace {

/// What Java's GlintRenderOptions say; below 0: as the scene asks.
glint::RenderOptions render_options(jint depth, jint samples, jboolean is_srgb) {
    glint::RenderOptions options;
    if (depth >= 0) options.max_depth = static_cast<uint32_t>(depth);
    if (samples >= 0) options.samples_per_pixel = static_cast<uint32_t>(samples);
    options.transfer = is_srgb != JNI_FALSE ? glint::Transfer::srgb : glint::Transfer::linear;
    return options;
}

/// A picture in the memory of a direct ByteBuffer, from its first byte on.
glint::Framebuffer wrap(JNIEnv *env, jobject buffer, jint width_px, jint height_px, jint stride_bytes) {
    if (width_px <= 0 || height_px <= 0) throw std::invalid_argument("a picture has at least one pixel");
    if (stride_bytes < 0 || stride_bytes / 4 < width_px) throw std::invalid_argument("the stride is less than a row");
    void *const memory = buffer != nullptr ? env->GetDirectBufferAddress(buffer) : nullptr;
    if (memory == nullptr) throw std::invalid_argument("the buffer is not direct (ByteBuffer.allocateDirect)");
    const jlong needed = jlong{stride_bytes} * (height_px - 1) + jlong{width_px} * 4;
    if (env->GetDirectBufferCapacity(buffer) < needed) {
        throw std::invalid_argument("the buffer is too small: the picture takes " + std::to_string(needed) + " bytes");
    }
    return take(glint::Framebuffer::wrap(static_cast<uint32_t>(width_px), static_cast<uint32_t>(height_px),
                                         static_cast<uint8_t *>(memory), static_cast<size_t>(stride_bytes)));
}

} // namespace

extern "C" {

JNIEXPORT jlong JNICALL Java_glint_android_GlintRenderer_nativeOpen(JNIEnv *env, jclass, jlong scene, jint threads,
                                                                    jstring isa) {
    return guarded(env, [&] {
        if (threads < 0) throw std::invalid_argument("fewer threads than none");
        glint::RendererOptions options;
        options.threads = static_cast<unsigned>(threads);
        if (isa != nullptr) options.isa = take(glint::find_isa(to_utf8(env, isa)));
        const auto from = Handles<SceneObject>::all().at(scene);
        return Handles<RendererObject>::all().open(std::make_shared<RendererObject>(from->accel, options));
    });
}

JNIEXPORT jlong JNICALL Java_glint_android_GlintRenderer_nativeStart(JNIEnv *env, jclass, jlong handle, jobject buffer,
                                                                     jint width_px, jint height_px, jint stride_bytes,
                                                                     jint depth, jint samples, jboolean is_srgb) {
    return guarded(env, [&] {
        const auto renderer = Handles<RendererObject>::all().at(handle);
        const auto job =
            std::make_shared<JobObject>(renderer, env, buffer, wrap(env, buffer, width_px, height_px, stride_bytes));
        job->job = take(renderer->renderer.start(job->target, render_options(depth, samples, is_srgb)));
        return Handles<JobObject>::all().open(job);
    });
}

JNIEXPORT jint JNICALL Java_glint_android_GlintRenderer_nativeThreads(JNIEnv *env, jclass, jlong handle) {
    return guarded(env,
                   [&] { return static_cast<jint>(Handles<RendererObject>::all().at(handle)->renderer.threads()); });
}

JNIEXPORT jstring JNICALL Java_glint_android_GlintRenderer_nativeInstructionSet(JNIEnv *env, jclass, jlong handle) {
    return guarded(
        env, [&] { return to_java(env, glint::isa_name(Handles<RendererObject>::all().at(handle)->renderer.isa())); });
}

JNIEXPORT void JNICALL Java_glint_android_GlintRenderer_nativeClose(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { Handles<RendererObject>::all().close(handle); });
}
}
