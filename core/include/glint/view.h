/* For C programs that show pictures while a person moves: frame rate, camera, and the picture at rest. */
#ifndef GLINT_VIEW_H
#define GLINT_VIEW_H

#include <stddef.h>
#include <stdint.h>

#include <glint/error.h>
#include <glint/export.h>
#include <glint/renderer.h>
#include <glint/scene.h>

GLINT_C_BEGIN

/* ---- The governor ---- */

/** Holds a frame rate: the picture gets coarser, then shallower, before frames come late. One thread at a time. */
typedef struct glint_governor glint_governor;

/** What to hold. */
typedef struct glint_governor_options {
    size_t size;             /**< of this struct; glint_governor_options_init() sets it */
    double target_fps;       /**< frames a second, above 0 to 1000; default 60 */
    float least_scale;       /**< of the window's width and height, above 0 to 1; default 0.25 */
    uint32_t least_depth;    /**< recursive rays in a row; default 0 */
    uint32_t greatest_depth; /**< at least least_depth; default 1 */
    uint32_t reserved;       /**< 0 */
} glint_governor_options;

/** Sets all defaults. `size` is sizeof *options. */
GLINT_API glint_error glint_governor_options_init(glint_governor_options *options, size_t size);

/** How a frame is to be rendered. */
typedef struct glint_frame_quality {
    float scale;    /**< of the picture to the window; glint_scaled_size() makes a size of it */
    uint32_t depth; /**< glint_render_options.max_depth */
} glint_frame_quality;

/** What one frame took, by the clock on the wall, in seconds. */
typedef struct glint_frame_times {
    double render_s;  /**< of rendering: what shrinks with the scale */
    double present_s; /**< of presenting beside the next frame's tracing; 0 where they take turns */
    double frame_s;   /**< from the end of the frame before to the end of this one */
    double wait_s;    /**< what of it the loop waited on purpose, for its turn or for the display */
} glint_frame_times;

/** Makes a governor that begins with scale 1 and the greatest depth; `options` may be NULL: defaults. Leaves a handle
    in *governor, to be released, also on failure; then it only says why. Fails with INVALID_ARGUMENT; BAD_INPUT where a
    number is out of range; OUT_OF_MEMORY. */
GLINT_API glint_error glint_governor_create(const glint_governor_options *options, glint_governor **governor);
/** Gives it up. NULL does nothing. */
GLINT_API void glint_governor_release(glint_governor *governor);

/** The quality of the next frame. Fails, writing nothing, with INVALID_ARGUMENT where a pointer is NULL or the governor
    was not made. */
GLINT_API glint_error glint_governor_get_quality(const glint_governor *governor, glint_frame_quality *quality);
/** Tells what a frame took and with which quality it was rendered. Times that are negative or no numbers are ignored.
    Fails with INVALID_ARGUMENT likewise. */
GLINT_API glint_error glint_governor_measured(glint_governor *governor, const glint_frame_quality *quality,
                                              const glint_frame_times *times);
/** Another greatest depth, and the depth from now on; not below the least. Fails with INVALID_ARGUMENT likewise. */
GLINT_API glint_error glint_governor_set_greatest_depth(glint_governor *governor, uint32_t depth);

/** The size of a picture of a scale, above 0 to 1, for a window of a size, each at least 1: of the same shape, and
    of a width that is a multiple of a few pixels. Any thread.
    Fails, writing nothing, with INVALID_ARGUMENT where a number is out of range or a pointer NULL. */
GLINT_API glint_error glint_scaled_size(uint32_t width_px, uint32_t height_px, float scale, uint32_t *scaled_width_px,
                                        uint32_t *scaled_height_px);

/* ---- The camera's control ---- */

/** Turns what a person does with mouse, fingers and keys into cameras. Places in the window are fractions of it: (0, 0)
    is top left, (1, 1) lower right. A move that would lead beyond 1e12, or whose numbers are not finite, is not made.
    One thread at a time uses it.

    All functions but the first two fail with INVALID_ARGUMENT, changing and writing nothing, where a pointer is NULL or
    the control was not made. */
typedef struct glint_camera_control glint_camera_control;

/** Begins with the scene's camera. The size in pixels, each at least 1, is that of a picture which this camera fills
    without widening; 0 and 0: the size that the scene asks for. The scene's handle may be released at once.
    Leaves a handle in *control, to be released, also on failure; then it only says why. Fails with INVALID_ARGUMENT
    where the scene is NULL or was not made, or one side is 0; OUT_OF_MEMORY. */
GLINT_API glint_error glint_camera_control_create(const glint_scene *scene, uint32_t width_px, uint32_t height_px,
                                                  glint_camera_control **control);
/** Gives it up. NULL does nothing. */
GLINT_API void glint_camera_control_release(glint_camera_control *control);

/** For glint_render_options.camera: the scene's own to the bit until something moves it. */
GLINT_API glint_error glint_camera_control_get_camera(const glint_camera_control *control, glint_camera *camera);
/** Around the pivot by a drag: the window's whole width is a turn, its whole height half a turn. Stops short of the
    poles. */
GLINT_API glint_error glint_camera_control_orbit(glint_camera_control *control, double drag_x, double drag_y);
/** Along the picture, so that what is under `from` comes to lie under `to`. It is `distance` from the eye, in the
    scene's units, as glint_renderer_pick() tells; 0, or infinite: as deep as the pivot. */
GLINT_API glint_error glint_camera_control_pan(glint_camera_control *control, double from_x, double from_y, double to_x,
                                               double to_y, double distance);
/** Brings what is under the cursor nearer, to `factor` (above 0) of its distance; it stays under the cursor. `distance`
    as in glint_camera_control_pan(). */
GLINT_API glint_error glint_camera_control_zoom(glint_camera_control *control, double x, double y, double factor,
                                                double distance);
/** Flies for some seconds: velocities to the right, upwards and ahead, in radii of the scene a second. */
GLINT_API glint_error glint_camera_control_fly(glint_camera_control *control, double right, double up, double ahead,
                                               double seconds);
/** Back to the scene's camera. */
GLINT_API glint_error glint_camera_control_reset(glint_camera_control *control);
/** Moves, without turning, so that all objects are in the picture, and turns about their middle from now on. */
GLINT_API glint_error glint_camera_control_frame(glint_camera_control *control);
/** The window has another shape: what is seen from top to bottom stays. Fails where a side is 0, too. */
GLINT_API glint_error glint_camera_control_resize(glint_camera_control *control, uint32_t width_px, uint32_t height_px);

/* ---- The refiner ---- */

/** Renders the picture of a camera at rest in 17 passes, each of which gives a whole picture to show: one sample in
    every pixel's centre, then the average of 1 to 16 samples of a grid. One thread at a time uses it; any may call
    glint_refiner_cancel(). */
typedef struct glint_refiner glint_refiner;

/** Begins with pictures of these options, whose samples_per_pixel and pattern count for nothing; `options` may be NULL.
    Leaves a handle in *refiner, to be released, also on failure; then it only says why. Fails with INVALID_ARGUMENT and
    OUT_OF_MEMORY. */
GLINT_API glint_error glint_refiner_create(const glint_render_options *options, glint_refiner **refiner);
/** Gives it up. NULL does nothing. */
GLINT_API void glint_refiner_release(glint_refiner *refiner);

/** Forgets all passes, as when the camera has moved; keeps the memory. `options` may be NULL. Fails with
    INVALID_ARGUMENT. */
GLINT_API glint_error glint_refiner_restart(glint_refiner *refiner, const glint_render_options *options);
/** Renders the next pass and fills the framebuffer with the picture. One of another size begins anew; once
    glint_refiner_is_done() it is only filled again. `statistics` may be NULL.
    Fails with CANCELLED, within one tile's work: the pixels are then of several pictures, but no pass is lost; fails as
    glint_renderer_render() does. */
GLINT_API glint_error glint_refiner_next(glint_refiner *refiner, glint_renderer *renderer,
                                         glint_framebuffer *framebuffer, glint_render_statistics *statistics);
/** Stops the pass in progress or, where there is none, the next one. Any thread, while the handle is there. NULL does
    nothing. */
GLINT_API void glint_refiner_cancel(glint_refiner *refiner);
/** 1 when the last pass is done, else 0, also of NULL. */
GLINT_API int32_t glint_refiner_is_done(const glint_refiner *refiner);
/** Samples of the grid that the picture shows, 0 to 16. */
GLINT_API uint32_t glint_refiner_samples_done(const glint_refiner *refiner);

GLINT_C_END

#endif
