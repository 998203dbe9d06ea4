// Java's values as C++ has them.
#include "android/jni/java.hpp"

#include <stdexcept>

namespace glint::android {

void check(JNIEnv *env) {
    if (env->ExceptionCheck()) throw JavaException();
}

GlobalRef::GlobalRef(JNIEnv *env, jobject object) : object_(env->NewGlobalRef(object)) {
    env->GetJavaVM(&vm_);
    if (object_ == nullptr) throw std::bad_alloc();
}

GlobalRef::~GlobalRef() {
    void *env = nullptr;
    if (vm_->GetEnv(&env, JNI_VERSION_1_6) == JNI_OK) static_cast<JNIEnv *>(env)->DeleteGlobalRef(object_);
}

std::string to_bytes(JNIEnv *env, jbyteArray bytes) {
    if (bytes == nullptr) throw std::invalid_argument("bytes are null");
    std::string copy(static_cast<size_t>(env->GetArrayLength(bytes)), '\0');
    env->GetByteArrayRegion(bytes, 0, static_cast<jsize>(copy.size()), reinterpret_cast<jbyte *>(copy.data()));
    return copy;
}

std::string to_utf8(JNIEnv *env, jstring text) {
    if (text == nullptr) throw std::invalid_argument("a string is null");
    const jmethodID get_bytes = env->GetMethodID(env->GetObjectClass(text), "getBytes", "(Ljava/lang/String;)[B");
    check(env);
    const jobject bytes = env->CallObjectMethod(text, get_bytes, env->NewStringUTF("UTF-8"));
    check(env);
    return to_bytes(env, static_cast<jbyteArray>(bytes));
}

jstring to_java(JNIEnv *env, std::string_view utf8) {
    const auto size = static_cast<jsize>(utf8.size());
    const jbyteArray bytes = env->NewByteArray(size);
    check(env);
    env->SetByteArrayRegion(bytes, 0, size, reinterpret_cast<const jbyte *>(utf8.data()));
    const jclass string = env->FindClass("java/lang/String");
    check(env);
    const jmethodID create = env->GetMethodID(string, "<init>", "([BLjava/lang/String;)V");
    check(env);
    const jobject text = env->NewObject(string, create, bytes, env->NewStringUTF("UTF-8"));
    check(env);
    return static_cast<jstring>(text);
}

} // namespace glint::android
