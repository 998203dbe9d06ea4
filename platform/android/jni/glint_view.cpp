// glint.android.GlintView
#include <memory>
#include <stdexcept>

#include "android/jni/barrier.hpp"
#include "android/jni/handles.hpp"
#include "android/jni/objects.hpp"
#include "android/session/view_session.hpp"

using namespace glint::android;
using glint::viewer::InputEvent;
using glint::viewer::Key;

namespace {

std::shared_ptr<ViewSession> session(jlong handle) {
    return Handles<ViewSession>::all().at(handle);
}

void press(jlong handle, Key key) {
    InputEvent event;
    event.key = key;
    for (const auto kind : {InputEvent::Kind::key_down, InputEvent::Kind::key_up}) {
        event.kind = kind;
        session(handle)->handle(event);
    }
}

} // namespace

extern "C" {

JNIEXPORT jlong JNICALL Java_glint_android_GlintView_nativeOpen(JNIEnv *env, jclass, jlong scene, jdouble target_fps,
                                                                jint depth, jint threads, jboolean is_srgb) {
    return guarded(env, [&] {
        if (threads < 0) throw std::invalid_argument("fewer threads than none");
        const auto from = Handles<SceneObject>::all().at(scene);
        ViewOptions options;
        options.target_fps = target_fps;
        if (depth >= 0) options.depth = static_cast<uint32_t>(depth);
        options.threads = static_cast<unsigned>(threads);
        options.transfer = is_srgb != JNI_FALSE ? glint::Transfer::srgb : glint::Transfer::linear;
        return Handles<ViewSession>::all().open(take(ViewSession::create(from->accel, from->scene, options)));
    });
}

JNIEXPORT void JNICALL Java_glint_android_GlintView_nativeContextCreated(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { session(handle)->context_created(); });
}

JNIEXPORT void JNICALL Java_glint_android_GlintView_nativeResize(JNIEnv *env, jclass, jlong handle, jint width_px,
                                                                 jint height_px) {
    guarded(env, [&] {
        if (width_px <= 0 || height_px <= 0) throw std::invalid_argument("a view has at least one pixel");
        session(handle)->resize(static_cast<uint32_t>(width_px), static_cast<uint32_t>(height_px));
    });
}

JNIEXPORT jdouble JNICALL Java_glint_android_GlintView_nativeDraw(JNIEnv *env, jclass, jlong handle) {
    return guarded(env, [&] { return take(session(handle)->draw()); });
}

// what: 0 down, 1 moved, 2 up
JNIEXPORT void JNICALL Java_glint_android_GlintView_nativeFinger(JNIEnv *env, jclass, jlong handle, jint what,
                                                                 jint finger, jfloat x_px, jfloat y_px) {
    guarded(env, [&] {
        constexpr InputEvent::Kind kinds[] = {InputEvent::Kind::finger_down, InputEvent::Kind::finger_move,
                                              InputEvent::Kind::finger_up};
        InputEvent event;
        event.kind = kinds[what];
        event.finger = static_cast<uint64_t>(finger);
        event.x = x_px;
        event.y = y_px;
        session(handle)->handle(event);
    });
}

JNIEXPORT void JNICALL Java_glint_android_GlintView_nativeResetCamera(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { press(handle, Key::r); });
}

JNIEXPORT void JNICALL Java_glint_android_GlintView_nativeFrameScene(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { press(handle, Key::f); });
}

JNIEXPORT void JNICALL Java_glint_android_GlintView_nativeTrim(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { session(handle)->trim(); });
}

// In the order of GlintFigures.
JNIEXPORT jdoubleArray JNICALL Java_glint_android_GlintView_nativeFigures(JNIEnv *env, jclass, jlong handle) {
    return guarded(env, [&] {
        const ViewFigures figures = session(handle)->figures();
        const jdouble values[] = {static_cast<jdouble>(figures.frames),
                                  figures.frames_a_second,
                                  figures.render_ms,
                                  static_cast<jdouble>(figures.width_px),
                                  static_cast<jdouble>(figures.height_px),
                                  static_cast<jdouble>(figures.depth),
                                  static_cast<jdouble>(figures.samples),
                                  figures.is_final ? 1.0 : 0.0,
                                  static_cast<jdouble>(figures.context_losses)};
        constexpr jsize count = sizeof values / sizeof values[0];
        const jdoubleArray array = env->NewDoubleArray(count);
        check(env);
        env->SetDoubleArrayRegion(array, 0, count, values);
        return array;
    });
}

JNIEXPORT void JNICALL Java_glint_android_GlintView_nativeClose(JNIEnv *env, jclass, jlong handle) {
    guarded(env, [&] { Handles<ViewSession>::all().close(handle); });
}
}
