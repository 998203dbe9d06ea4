// The files in an app's assets, for readers.
#pragma once

#include <string>

#include <android/asset_manager.h>
#include <jni.h>

#include <glint/file_source.hpp>

#include "android/jni/java.hpp"

namespace glint::android {

/// Reads from an android.content.res.AssetManager; paths are those that AssetManager.open() takes. Any thread may use
/// it.
class AssetFiles final : public FileSource {
public:
    AssetFiles(JNIEnv *env, jobject asset_manager);

    [[nodiscard]] Result<FileBytes> read(const std::string &path, uint64_t max_bytes) const override;

private:
    GlobalRef java_; // the assets live as long as it does
    AAssetManager *assets_;
};

} // namespace glint::android
