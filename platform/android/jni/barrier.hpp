// The barrier that no C++ exception crosses: every entry from Java is one call of guarded().
#pragma once

#include <utility>

#include <jni.h>

#include <glint/result.hpp>

namespace glint::android {

/// An Error on its way to Java, where it becomes a GlintException.
struct Failure {
    Error error;
};

/// The value; throws a Failure where there is none.
template <typename T> T take(Result<T> result) {
    if (!result) throw Failure{std::move(result).error()};
    return std::move(result).value();
}

/// Makes a Java exception of the C++ exception that is being caught, unless Java threw it. Only for guarded().
void throw_to_java(JNIEnv *env) noexcept;

/// What `body` returns; where it throws, nothing, and Java finds an exception:
/// Failure - GlintException with the diagnostics' text; ClosedHandle - IllegalStateException; std::invalid_argument -
/// IllegalArgumentException; std::bad_alloc - OutOfMemoryError; anything else - RuntimeException.
template <typename Body> auto guarded(JNIEnv *env, Body body) noexcept -> decltype(body()) {
    try {
        return body();
    } catch (...) {
        throw_to_java(env);
    }
    return decltype(body())();
}

} // namespace glint::android
