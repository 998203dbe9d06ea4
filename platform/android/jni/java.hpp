// Java's values as C++ has them. JNI's own strings are no UTF-8, and end a program that hands over bytes that are none.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include <jni.h>

namespace glint::android {

/// A Java exception is pending: the barrier lets it through.
struct JavaException {};

/// Throws JavaException where a call of Java's has thrown.
void check(JNIEnv *env);

/// A Java object that lives as long as this does, in whatever thread. Destroyed in a thread that Java knows.
class GlobalRef {
public:
    GlobalRef(JNIEnv *env, jobject object);
    ~GlobalRef();
    GlobalRef(const GlobalRef &) = delete;
    GlobalRef &operator=(const GlobalRef &) = delete;

private:
    JavaVM *vm_ = nullptr;
    jobject object_;
};

/// UTF-8, whatever the string holds. Throws std::invalid_argument where it is null.
[[nodiscard]] std::string to_utf8(JNIEnv *env, jstring text);
/// A Java string of UTF-8; bytes that are none become the replacement character.
[[nodiscard]] jstring to_java(JNIEnv *env, std::string_view utf8);
/// Of a byte[] that is not null.
[[nodiscard]] std::string to_bytes(JNIEnv *env, jbyteArray bytes);

} // namespace glint::android
