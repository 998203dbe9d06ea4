/* Which Glint this is, for C. */
#ifndef GLINT_VERSION_H
#define GLINT_VERSION_H

#include <stddef.h>
#include <stdint.h>

#include <glint/error.h>
#include <glint/export.h>

/** The version of these headers; glint_get_version() tells that of the library. */
#define GLINT_VERSION_MAJOR 0
#define GLINT_VERSION_MINOR 1
#define GLINT_VERSION_PATCH 0

GLINT_C_BEGIN

/** The library's version, and what it does on this machine. Strings live as long as the library. */
typedef struct glint_version {
    size_t size;          /**< of this struct, set by the caller */
    const char *text;     /**< "0.1.0" */
    const char *compiler; /**< name and version of the compiler that built the library */
    const char *isa;      /**< name of the instruction set in use where nobody chooses, "avx2" */
    uint32_t major;       /**< the 0 of 0.1.2 */
    uint32_t minor;       /**< its 1 */
    uint32_t patch;       /**< its 2 */
    uint32_t reserved;    /**< 0 */
} glint_version;

/** Fills `version`, as much of it as version->size says. Any thread.
    Fails with GLINT_ERROR_INVALID_ARGUMENT where `version` is NULL or its size is not one of this struct's. */
GLINT_API glint_error glint_get_version(glint_version *version);

GLINT_C_END

#endif
