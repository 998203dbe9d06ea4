/* Pictures in C: framebuffers, renderers, renders that go on while their caller does other things. */
#ifndef GLINT_RENDERER_H
#define GLINT_RENDERER_H

#include <stddef.h>
#include <stdint.h>

#include <glint/error.h>
#include <glint/export.h>
#include <glint/scene.h>

GLINT_C_BEGIN

/* ---- Framebuffers ---- */

/** A picture in memory, its own or the caller's. Pixel (0, 0) is top left; rows follow each other from the top. One
    thread at a time renders to it; any may look at its size and memory. */
typedef struct glint_framebuffer glint_framebuffer;

/** A picture in memory of its own: zeroes (transparent black), rows without gaps. `with_radiance` not 0: linear floats
    are kept besides the bytes, which costs four times the memory traffic.
    Leaves a handle in *framebuffer, to be released, also on failure; then it only says why. Fails with
    INVALID_ARGUMENT where `framebuffer` is NULL; BAD_INPUT where a side is 0; LIMIT_EXCEEDED where no memory could be
    large enough; OUT_OF_MEMORY. */
GLINT_API glint_error glint_framebuffer_create(uint32_t width_px, uint32_t height_px, int32_t with_radiance,
                                               glint_framebuffer **framebuffer);

/** A picture in the caller's memory, which stays as it is until rendered to. The memory must be there until the handle
    is released and the jobs that render to it are released or waited for.

    `rgba8` has 4 bytes a pixel; each row begins `stride_bytes` (at least 4 * width_px) behind the one above; what lies
    between is never written. `radiance` has 3 floats a pixel and a stride that is a multiple of 4; NULL: none are kept.
    A stride of 0: rows without gaps. The two must not overlap.

    Leaves a handle as glint_framebuffer_create() does. Fails with INVALID_ARGUMENT where `framebuffer` is NULL;
    BAD_INPUT where `rgba8` is NULL, a side is 0, a stride too small or the floats are not aligned; LIMIT_EXCEEDED where
    the rows could not be addressed; OUT_OF_MEMORY. */
GLINT_API glint_error glint_framebuffer_wrap(uint32_t width_px, uint32_t height_px, uint8_t *rgba8, size_t stride_bytes,
                                             float *radiance, size_t radiance_stride_bytes,
                                             glint_framebuffer **framebuffer);

/** Gives the handle up; a job that renders to it goes on. NULL does nothing. */
GLINT_API void glint_framebuffer_release(glint_framebuffer *framebuffer);

/** Where the picture is. */
typedef struct glint_pixels {
    size_t size;                  /**< of this struct, set by the caller */
    uint8_t *rgba8;               /**< red, green, blue, alpha; 255 alpha where rendered */
    float *radiance;              /**< linear red, green, blue, unclamped; NULL without */
    size_t stride_bytes;          /**< from a row of rgba8 to the next */
    size_t radiance_stride_bytes; /**< from a row of radiance to the next; 0 without */
    uint32_t width_px;            /**< pixels in a row */
    uint32_t height_px;           /**< rows */
} glint_pixels;

/** Fills *pixels, as much of it as pixels->size says; the memory stays until the framebuffer is released. It may be
    read while a job renders to it, by who does not mind tiles that are half written.
    Fails, writing nothing, with INVALID_ARGUMENT where a pointer is NULL, the size is wrong, or the framebuffer was not
    made. */
GLINT_API glint_error glint_framebuffer_get_pixels(const glint_framebuffer *framebuffer, glint_pixels *pixels);

/** XXH3-64 of the bytes, top row first, without what lies between rows: equal pictures have equal hashes on every
    machine. 0 where the framebuffer is NULL or was not made. */
GLINT_API uint64_t glint_framebuffer_pixel_hash(const glint_framebuffer *framebuffer);

/* ---- Renderers ---- */

/** Traces pictures of one scene, with threads of its own or the host's. The pixels depend on the scene and the
    glint_render_options alone. One thread at a time uses it; renderers do not know of each other. */
typedef struct glint_renderer glint_renderer;

/** Instruction sets. All of them make the same picture. */
enum {
    GLINT_ISA_BEST = -1,  /**< the fastest one here */
    GLINT_ISA_SCALAR = 0, /**< one ray at a time: the definition of the picture */
    GLINT_ISA_SSE4 = 1,
    GLINT_ISA_AVX2 = 2,
    GLINT_ISA_AVX512 = 3,
    GLINT_ISA_NEON = 4,
    GLINT_ISA_WASM = 5
};

/** What rays find triangles by. Decides about speed alone. */
enum {
    GLINT_ACCEL_AUTOMATIC = 0, /**< one of the next two, by the number of triangles */
    GLINT_ACCEL_KDTREE = 1,    /**< kd-tree: for few, large triangles */
    GLINT_ACCEL_BVH = 2,       /**< bounding volume hierarchy: for many small ones */
    GLINT_ACCEL_BRUTE = 3      /**< none: every ray tests every triangle */
};

/** Work for a thread of the host's. */
typedef struct glint_task glint_task;

/** Does the task's work, if it is not too late for it, and gives the task up. Any thread; NULL does nothing. */
GLINT_API void glint_task_run(glint_task *task);
/** Gives up a task that is not to run. Any thread; NULL does nothing. */
GLINT_API void glint_task_release(glint_task *task);

/** Takes a task over. The host calls glint_task_run() or glint_task_release() once: on any thread, at once or later,
    also within this very call, also after the render is over. No order of running tasks can come to a deadlock; where
    none is run, the thread that renders or waits does all the work. Called by whichever thread brings work, by several
    at once where several do; returns only by returning, with no exception or longjmp. */
typedef void (*glint_submit_function)(void *user, glint_task *task);

/** How to make a renderer. */
typedef struct glint_renderer_options {
    size_t size; /**< of this struct; glint_renderer_options_init() sets it */
    /** Lends the host's threads, threads - 1 of them a render: then the library starts none. It is called until the
        renderer, its jobs and all that was made from it are released. NULL, the default: threads of its own. */
    glint_submit_function submit;
    void *submit_user; /**< given to submit */
    uint32_t threads;  /**< that trace, the caller's included, at most 1024; 0, the default: one a processor */
    int32_t isa;       /**< GLINT_ISA_...; default GLINT_ISA_BEST */
    int32_t accel;     /**< GLINT_ACCEL_...; default GLINT_ACCEL_AUTOMATIC */
    uint32_t reserved; /**< 0 */
} glint_renderer_options;

/** Sets all defaults. `size` is sizeof *options. */
GLINT_API glint_error glint_renderer_options_init(glint_renderer_options *options, size_t size);

/** Makes a renderer of a scene: builds the tree that rays find triangles by (a million take a second or less) and
    starts the threads. `options` may be NULL: defaults. The scene's handle may be released at once.
    Leaves a handle in *renderer, to be released, also on failure; then it only says why. Fails with INVALID_ARGUMENT
    where a pointer is NULL, the scene was not made, or there is no such option; UNSUPPORTED where this machine or build
    lacks the instruction set; OUT_OF_MEMORY. */
GLINT_API glint_error glint_renderer_create(const glint_scene *scene, const glint_renderer_options *options,
                                            glint_renderer **renderer);

/** Gives the handle up; its jobs go on, and the last of them ends the threads. NULL does nothing. */
GLINT_API void glint_renderer_release(glint_renderer *renderer);

/** Goes on with another scene: in microseconds an object where it comes from the last one by glint_scene_move() or
    glint_scene_at(), else the tree is built anew. Waits for a render in progress.
    Fails, and keeps the scene it had, with INVALID_ARGUMENT where a handle is NULL or was not made; OUT_OF_MEMORY. */
GLINT_API glint_error glint_renderer_set_scene(glint_renderer *renderer, const glint_scene *scene);

/** Threads that trace, the caller's included; 0 where the renderer is NULL or was not made. */
GLINT_API uint32_t glint_renderer_threads(const glint_renderer *renderer);
/** Which GLINT_ISA_... traces; GLINT_ISA_BEST where the renderer is NULL or was not made. */
GLINT_API int32_t glint_renderer_isa(const glint_renderer *renderer);
/** "scalar", "sse4", ...; "" for other numbers. Any thread; lives for ever. */
GLINT_API const char *glint_isa_name(int32_t isa);

/* ---- Rendering ---- */

/** Of max_depth, samples_per_pixel and pattern: as the scene asks for. */
#define GLINT_AS_SCENE (-1)

/** How colours become bytes. */
enum {
    GLINT_TRANSFER_LINEAR = 0, /**< round(255 c) */
    GLINT_TRANSFER_SRGB = 1    /**< by sRGB's transfer curve, as displays expect */
};

/** What a picture is to be like. */
typedef struct glint_render_options {
    size_t size;                /**< of this struct; glint_render_options_init() sets it */
    const glint_camera *camera; /**< NULL, the default: the scene's own */
    int32_t max_depth;          /**< recursive rays in a row after the primary ray, 0 to 1000; default GLINT_AS_SCENE */
    int32_t samples_per_pixel;  /**< 1 to 4096; default GLINT_AS_SCENE */
    int32_t pattern;            /**< GLINT_PATTERN_...; default GLINT_AS_SCENE */
    int32_t transfer;           /**< GLINT_TRANSFER_...; default GLINT_TRANSFER_LINEAR */
} glint_render_options;

/** Sets all defaults. `size` is sizeof *options. */
GLINT_API glint_error glint_render_options_init(glint_render_options *options, size_t size);

/** What a render did. */
typedef struct glint_render_statistics {
    size_t size;             /**< of this struct, set by the caller */
    double seconds;          /**< by the clock on the wall */
    uint64_t primary_rays;   /**< from the eye */
    uint64_t shadow_rays;    /**< to lights */
    uint64_t secondary_rays; /**< mirrored and transmitted */
} glint_render_statistics;

/** Renders a whole picture, of the framebuffer's size, and returns when it is there. The calling thread helps; a job of
    this renderer's that is not over goes first. `options` and `statistics` may be NULL.
    Fails, with the statistics not written, with INVALID_ARGUMENT where a handle is NULL or was not made, a size is
    wrong, or there is no such option; BAD_INPUT where the camera or the samples are not valid; OUT_OF_MEMORY. The
    pixels are then as they were. */
GLINT_API glint_error glint_renderer_render(glint_renderer *renderer, glint_framebuffer *framebuffer,
                                            const glint_render_options *options, glint_render_statistics *statistics);

/** What rays from an eye meet. */
typedef struct glint_pick {
    size_t size;       /**< of this struct, set by the caller */
    double distance;   /**< from the eye, in the scene's units; infinite where nothing is hit */
    float position[3]; /**< of what is hit; 0 where nothing is */
    uint32_t object;   /**< that is hit, or GLINT_NONE */
    uint32_t light;    /**< that is hit, or GLINT_NONE */
    uint32_t reserved; /**< 0 */
} glint_pick;

/** What is seen at a place of the window, (0, 0) its top left corner and (1, 1) its lower right one. `camera` may be
    NULL: the scene's. On the calling thread, in microseconds. Fails, writing nothing, with INVALID_ARGUMENT where
    another pointer is NULL, the size is wrong, a number is not finite, or the renderer was not made; OUT_OF_MEMORY. */
GLINT_API glint_error glint_renderer_pick(glint_renderer *renderer, const glint_camera *camera, double x, double y,
                                          glint_pick *pick);

/* ---- Jobs ---- */

/** One picture on its way. Any thread may watch and cancel it; one at a time waits; releasing it is the last thing that
    is done with it. */
typedef struct glint_job glint_job;

/** Told that a job is over, by whichever thread came to the end. It may start the next render; it must not wait for
    this job or release it, and returns only by returning. */
typedef void (*glint_done_function)(void *user);

/** Begins a picture and returns at once. `options` may be NULL. `on_done` is called once, when the picture is there or
    was given up, unless this call fails; it may be NULL. The handles of the renderer and the framebuffer may be
    released before the job is over, but nobody else may write to the picture. A job of this renderer's that is not over
    goes first.
    Leaves a handle in *job, to be released, also on failure; then it only says why. Fails as glint_renderer_render()
    does. */
GLINT_API glint_error glint_renderer_start(glint_renderer *renderer, glint_framebuffer *framebuffer,
                                           const glint_render_options *options, glint_done_function on_done, void *user,
                                           glint_job **job);

/** Finished share of the picture, in [0, 1]; 0 where the job is NULL or was not made. */
GLINT_API double glint_job_progress(const glint_job *job);
/** 1 where glint_job_wait() would return at once, else 0. With a host that runs no task, 0 until somebody waits. */
GLINT_API int32_t glint_job_is_done(const glint_job *job);
/** Stops the render within one tile's work, without waiting for that. Nothing happens where it is over, or NULL. */
GLINT_API void glint_job_cancel(glint_job *job);
/** Helps, and returns when the picture is there and on_done has returned; `statistics` may be NULL. Every further call
    returns the same.
    Fails, writing no statistics, with CANCELLED: whole tiles are there, the rest is as it was; INVALID_ARGUMENT where
    the job is NULL or was not made, or the size is wrong; OUT_OF_MEMORY. */
GLINT_API glint_error glint_job_wait(glint_job *job, glint_render_statistics *statistics);
/** Cancels the job where it is not over, waits until nothing of it works any more, gives it up. NULL does nothing. */
GLINT_API void glint_job_release(glint_job *job);

GLINT_C_END

#endif
