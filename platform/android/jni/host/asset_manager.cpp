// What the NDK does with assets, done through Java's AssetManager: for tests on machines that have no NDK.
#include <android/asset_manager_jni.h>

#include <algorithm>
#include <cstring>
#include <string>

// The NDK's manager belongs to Java's; here both are one object, and every asset is read when it is opened.
struct AAsset {
    std::string bytes;
    size_t read = 0;
};

namespace {

struct Manager {
    JavaVM *vm;
    jobject java; // never deleted: tests make few
};

/// All of a java.io.InputStream; false where it throws.
bool read_all(JNIEnv *env, jobject stream, std::string &bytes) {
    const jclass type = env->GetObjectClass(stream);
    const auto all =
        static_cast<jbyteArray>(env->CallObjectMethod(stream, env->GetMethodID(type, "readAllBytes", "()[B")));
    if (env->ExceptionCheck()) return false;
    bytes.resize(static_cast<size_t>(env->GetArrayLength(all)));
    env->GetByteArrayRegion(all, 0, static_cast<jsize>(bytes.size()), reinterpret_cast<jbyte *>(bytes.data()));
    env->CallVoidMethod(stream, env->GetMethodID(type, "close", "()V"));
    return !env->ExceptionCheck();
}

} // namespace

AAssetManager *AAssetManager_fromJava(JNIEnv *env, jobject asset_manager) {
    if (asset_manager == nullptr) return nullptr;
    auto *manager = new Manager{nullptr, env->NewGlobalRef(asset_manager)};
    env->GetJavaVM(&manager->vm);
    return reinterpret_cast<AAssetManager *>(manager);
}

AAsset *AAssetManager_open(AAssetManager *assets, const char *path, int) {
    const auto *manager = reinterpret_cast<const Manager *>(assets);
    void *got = nullptr;
    if (manager->vm->GetEnv(&got, JNI_VERSION_1_6) != JNI_OK) return nullptr;
    auto *env = static_cast<JNIEnv *>(got);
    if (env->PushLocalFrame(16) != JNI_OK) return nullptr;
    const jmethodID open =
        env->GetMethodID(env->GetObjectClass(manager->java), "open", "(Ljava/lang/String;)Ljava/io/InputStream;");
    const jobject stream = env->CallObjectMethod(manager->java, open, env->NewStringUTF(path));
    auto *asset = new AAsset;
    if (env->ExceptionCheck() || stream == nullptr || !read_all(env, stream, asset->bytes)) {
        env->ExceptionClear();
        delete asset;
        asset = nullptr;
    }
    env->PopLocalFrame(nullptr);
    return asset;
}

int64_t AAsset_getLength64(AAsset *asset) {
    return static_cast<int64_t>(asset->bytes.size());
}

int AAsset_read(AAsset *asset, void *to, size_t count) {
    // Small pieces, as the NDK may give them.
    constexpr size_t most = 100;
    count = std::min({count, most, asset->bytes.size() - asset->read});
    std::memcpy(to, asset->bytes.data() + asset->read, count);
    asset->read += count;
    return static_cast<int>(count);
}

void AAsset_close(AAsset *asset) {
    delete asset;
}
