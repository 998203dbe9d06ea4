/* What C functions return, and how to ask what went wrong. */
#ifndef GLINT_ERROR_H
#define GLINT_ERROR_H

#include <stddef.h>
#include <stdint.h>

#include <glint/export.h>

GLINT_C_BEGIN

/** A result: GLINT_OK, or what kind of failure. Not an enum, whose size is the compiler's business. */
typedef int32_t glint_error;

/** Values of glint_error. */
enum {
    GLINT_OK = 0,
    GLINT_ERROR_INVALID_ARGUMENT = 1, /**< the call is wrong: NULL, a number out of range, a handle of another kind */
    GLINT_ERROR_BAD_INPUT = 2,        /**< a file's contents, or a scene handed to a builder, are not valid */
    GLINT_ERROR_NOT_FOUND = 3,        /**< a file is missing, is a folder, or may not be read */
    GLINT_ERROR_LIMIT_EXCEEDED = 4,   /**< valid, but larger than a limit in the options */
    GLINT_ERROR_IO = 5,               /**< the system refused to read */
    GLINT_ERROR_UNSUPPORTED = 6,      /**< this machine or this build cannot do it */
    GLINT_ERROR_CANCELLED = 7,        /**< the caller asked to stop */
    GLINT_ERROR_OUT_OF_MEMORY = 8,    /**< no memory was to be had; what was there before is as it was */
    GLINT_ERROR_INTERNAL = 9          /**< a mistake of Glint's own; please report it */
};

/** The code's name without its prefix, "BAD_INPUT"; "UNKNOWN" for other numbers. Any thread; lives for ever. */
GLINT_API const char *glint_error_name(glint_error code);

/** What the last failure of a call on this handle was, for people: one or several lines, UTF-8, without a newline at
    the end; never NULL. A call that succeeds leaves it as it is; "" before the first failure.

    `handle` is any of Glint's, also one that a creating function left behind when it failed: there it says why. Of NULL
    it is "there is no handle", since a creating function leaves NULL only where even a handle could not be had: out of
    memory.

    Valid until the next call that fails on the handle, or its release. The thread that uses the handle calls it; of a
    scene, whose message never changes, any thread; of a job the one that waited for it. */
GLINT_API const char *glint_last_error_message(const void *handle);

GLINT_C_END

#endif
