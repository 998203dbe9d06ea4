/* The door between Glint and its image module: plain C, so that no exception, allocator or C++ library crosses it. */
#ifndef GLINT_IMAGEIO_MODULE_ABI_H
#define GLINT_IMAGEIO_MODULE_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Changes with every change of this file; a module that answers otherwise is not used. */
#define GLINT_IMAGEIO_ABI 2

/* A picture, top row first. */
struct glint_imageio_picture {
    const char *format;  /* the library's own name of the file format */
    uint32_t width_px;   /* at least 1 */
    uint32_t height_px;  /* at least 1 */
    uint32_t channels;   /* to be written: 3 = R G B, 4 = R G B A */
    uint32_t is_float;   /* 0: samples are uint8_t, 1: samples are float */
    const void *samples; /* the first pixel's R */
    size_t pixel_stride_bytes;
    size_t row_stride_bytes;
    int (*stop)(void *context); /* asked now and then; not 0 = give up. May be NULL */
    void *stop_context;
};

/* A whole file's bytes. `owner` is NULL when there are none. */
struct glint_imageio_bytes {
    const uint8_t *data;
    size_t count;
    void *owner;
};

/* Where a decoded picture goes. */
struct glint_imageio_room {
    /* Asked once, when the picture's size is known (each side at least 1): room for 3 * width_px * height_px floats, R G B
       for each pixel, top row first. NULL = the picture is not wanted. */
    float *(*ask)(void *context, uint32_t width_px, uint32_t height_px);
    void *context;
};

enum glint_imageio_outcome { GLINT_IMAGEIO_OK = 0, GLINT_IMAGEIO_FAILED = 1, GLINT_IMAGEIO_STOPPED = 2 };

/* GLINT_IMAGEIO_ABI of the module. */
typedef uint32_t glint_imageio_abi_fn(void);

/* Name and version of the library behind the module; lives as long as the process. */
typedef const char *glint_imageio_library_fn(void);

/* Encodes the picture into memory: `file` is to be released by the caller. On failure `message` (message_bytes > 0)
   gets a sentence, cut to fit, and `file` is empty. Returns a glint_imageio_outcome. */
typedef int glint_imageio_encode_fn(const struct glint_imageio_picture *picture, struct glint_imageio_bytes *file,
                                    char *message, size_t message_bytes);

typedef void glint_imageio_release_fn(struct glint_imageio_bytes *file);

/* Decodes the first picture of the file, in any format the library knows, into the room that it asks for. Whole numbers
   become fractions of their largest one, grey becomes R = G = B, alpha is left aside; nothing else is done to the
   values. On failure `message` (message_bytes > 0) gets a sentence, cut to fit. Returns a glint_imageio_outcome: stopped
   where there was no room. */
typedef int glint_imageio_decode_fn(const char *file, const struct glint_imageio_room *room, char *message,
                                    size_t message_bytes);

/* The names under which a module shows the functions above. */
#define GLINT_IMAGEIO_ABI_NAME "glint_imageio_abi"
#define GLINT_IMAGEIO_LIBRARY_NAME "glint_imageio_library"
#define GLINT_IMAGEIO_ENCODE_NAME "glint_imageio_encode"
#define GLINT_IMAGEIO_RELEASE_NAME "glint_imageio_release"
#define GLINT_IMAGEIO_DECODE_NAME "glint_imageio_decode"

#ifdef __cplusplus
}
#endif

#endif
