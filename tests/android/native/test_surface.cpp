// glint.test.Native: a context without a window for Java, and what the C++ renderer makes of a scene.
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <jni.h>

#include <glint/egl/surface.hpp>
#include <glint/framebuffer.hpp>
#include <glint/read.hpp>
#include <glint/refiner.hpp>
#include <glint/renderer.hpp>

namespace {

std::unique_ptr<glint::gles::Surface> surface;

template <typename T> T take(glint::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().text());
    return std::move(result).value();
}

template <typename Body> auto guarded(JNIEnv *env, Body body) -> decltype(body()) {
    try {
        return body();
    } catch (const std::exception &error) {
        env->ThrowNew(env->FindClass("java/lang/RuntimeException"), error.what());
    }
    return decltype(body())();
}

std::string text(JNIEnv *env, jstring string) {
    const char *chars = env->GetStringUTFChars(string, nullptr);
    std::string copy = chars;
    env->ReleaseStringUTFChars(string, chars);
    return copy;
}

jlong hash_of(const void *rgba8, uint32_t width_px, uint32_t height_px) {
    auto picture = take(glint::Framebuffer::create(width_px, height_px, false));
    const auto *bytes = static_cast<const uint8_t *>(rgba8);
    std::copy(bytes, bytes + picture.rgba8_stride_bytes() * height_px, picture.rgba8());
    return static_cast<jlong>(picture.pixel_hash());
}

} // namespace

extern "C" {

// A new surfaceless context, current in this thread; the one before is gone.
JNIEXPORT void JNICALL Java_glint_test_Native_openSurface(JNIEnv *env, jclass, jint width_px, jint height_px) {
    guarded(env, [&] {
        surface.reset();
        surface =
            take(glint::egl::create_surfaceless(static_cast<uint32_t>(width_px), static_cast<uint32_t>(height_px)));
    });
}

JNIEXPORT void JNICALL Java_glint_test_Native_closeSurface(JNIEnv *env, jclass) {
    guarded(env, [&] { surface.reset(); });
}

// Of what is on the surface.
JNIEXPORT jlong JNICALL Java_glint_test_Native_surfaceHash(JNIEnv *env, jclass) {
    return guarded(env, [&] {
        const std::vector<uint8_t> pixels = take(surface->read_back());
        return hash_of(pixels.data(), surface->width_px(), surface->height_px());
    });
}

// Of pixels in a direct buffer, without gaps.
JNIEXPORT jlong JNICALL Java_glint_test_Native_hash(JNIEnv *env, jclass, jobject buffer, jint width_px,
                                                    jint height_px) {
    return guarded(env, [&] {
        return hash_of(env->GetDirectBufferAddress(buffer), static_cast<uint32_t>(width_px),
                       static_cast<uint32_t>(height_px));
    });
}

// Of the picture that the C++ renderer makes; with samples = 0 of the one that refinement ends with.
JNIEXPORT jlong JNICALL Java_glint_test_Native_renderHash(JNIEnv *env, jclass, jstring scene, jint width_px,
                                                          jint height_px, jint depth, jint samples) {
    return guarded(env, [&] {
        const auto file = take(glint::read_scene(text(env, scene)));
        glint::Renderer renderer(glint::Accel::build(file.scene));
        auto picture =
            take(glint::Framebuffer::create(static_cast<uint32_t>(width_px), static_cast<uint32_t>(height_px), false));
        glint::RenderOptions options;
        options.max_depth = static_cast<uint32_t>(depth);
        if (samples > 0) {
            options.samples_per_pixel = static_cast<uint32_t>(samples);
            take(renderer.render(picture, options));
        } else {
            glint::Refiner refiner(options);
            while (!refiner.done()) take(refiner.next(renderer, picture));
        }
        return static_cast<jlong>(picture.pixel_hash());
    });
}
}
