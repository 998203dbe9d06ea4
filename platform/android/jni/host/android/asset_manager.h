/* What the NDK declares of assets, as far as Glint calls it, for machines that have no NDK. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct AAssetManager AAssetManager;
typedef struct AAsset AAsset;

enum { AASSET_MODE_STREAMING = 2 };

AAsset *AAssetManager_open(AAssetManager *assets, const char *path, int mode);
int64_t AAsset_getLength64(AAsset *asset);
int AAsset_read(AAsset *asset, void *to, size_t count);
void AAsset_close(AAsset *asset);

#ifdef __cplusplus
}
#endif
