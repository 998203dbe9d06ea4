// The files in an app's assets, for readers.
#include "android/jni/asset_files.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

#include <android/asset_manager_jni.h>

namespace glint::android {

AssetFiles::AssetFiles(JNIEnv *env, jobject asset_manager)
    : java_(env, asset_manager), assets_(AAssetManager_fromJava(env, asset_manager)) {
    if (assets_ == nullptr) throw std::invalid_argument("this is no AssetManager");
}

Result<FileBytes> AssetFiles::read(const std::string &path, uint64_t max_bytes) const {
    const std::unique_ptr<AAsset, decltype(&AAsset_close)> asset(
        AAssetManager_open(assets_, path.c_str(), AASSET_MODE_STREAMING), &AAsset_close);
    if (!asset) return Error(ErrorCode::not_found, "the assets have no such file");
    const auto size = static_cast<uint64_t>(AAsset_getLength64(asset.get()));
    if (size > std::min<uint64_t>(max_bytes, std::numeric_limits<size_t>::max() / 2))
        return Error(ErrorCode::limit_exceeded, "the asset is larger than the limit");
    FileBytes file(static_cast<size_t>(size));
    size_t done = 0;
    while (done < file.size) {
        const int count = AAsset_read(asset.get(), file.bytes.get() + done, file.size - done);
        if (count <= 0) return Error(ErrorCode::io, "the asset cannot be read to its end");
        done += static_cast<size_t>(count);
    }
    return file;
}

} // namespace glint::android
