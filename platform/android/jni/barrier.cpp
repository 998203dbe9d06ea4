// The barrier that no C++ exception crosses.
#include "android/jni/barrier.hpp"

#include <exception>
#include <new>
#include <stdexcept>

#include "android/jni/handles.hpp"
#include "android/jni/java.hpp"

namespace glint::android {

namespace {

void throw_new(JNIEnv *env, const char *class_name, const char *message) {
    if (const jclass type = env->FindClass(class_name)) env->ThrowNew(type, message);
}

/// GlintException(int code, String message); the code is the place in ErrorCode and in GlintException.Code.
void throw_failure(JNIEnv *env, const Error &error) {
    const jclass type = env->FindClass("glint/android/GlintException");
    check(env);
    const jmethodID create = env->GetMethodID(type, "<init>", "(ILjava/lang/String;)V");
    check(env);
    const jobject exception = env->NewObject(type, create, static_cast<jint>(error.code), to_java(env, error.text()));
    check(env);
    env->Throw(static_cast<jthrowable>(exception));
}

} // namespace

void throw_to_java(JNIEnv *env) noexcept {
    try {
        throw;
    } catch (const JavaException &) {
        // It is pending already.
    } catch (const Failure &failure) {
        try {
            throw_failure(env, failure.error);
        } catch (...) {
            if (!env->ExceptionCheck()) throw_new(env, "java/lang/OutOfMemoryError", "no memory for an error's words");
        }
    } catch (const ClosedHandle &) {
        throw_new(env, "java/lang/IllegalStateException", "the object is closed");
    } catch (const std::invalid_argument &error) {
        throw_new(env, "java/lang/IllegalArgumentException", error.what());
    } catch (const std::bad_alloc &) {
        throw_new(env, "java/lang/OutOfMemoryError", "out of native memory");
    } catch (const std::exception &error) {
        throw_new(env, "java/lang/RuntimeException", error.what());
    } catch (...) {
        throw_new(env, "java/lang/RuntimeException", "an unknown native failure");
    }
}

} // namespace glint::android
