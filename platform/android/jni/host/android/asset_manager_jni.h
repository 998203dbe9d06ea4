/* As the NDK's, for machines that have no NDK. */
#pragma once

#include <android/asset_manager.h>
#include <jni.h>

#ifdef __cplusplus
extern "C"
#endif
    AAssetManager *
    AAssetManager_fromJava(JNIEnv *env, jobject asset_manager);
