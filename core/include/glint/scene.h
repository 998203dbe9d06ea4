/* Scenes in C: read from files, looked at, moved. How to make one in code: <glint/scene_builder.h>. */
#ifndef GLINT_SCENE_H
#define GLINT_SCENE_H

#include <stddef.h>
#include <stdint.h>

#include <glint/error.h>
#include <glint/export.h>

GLINT_C_BEGIN

/** A complete, valid scene, or why there is none. Nothing in it can change: any threads may use it at once. */
typedef struct glint_scene glint_scene;

/** No object, light, mesh or texture. */
#define GLINT_NONE UINT32_MAX

/** A pinhole: rays leave `eye` through a rectangle in space. Pixels divide it evenly, row 0 along its top edge.
    Coordinates are in the scene's units, right-handed, at most 1e12. */
typedef struct glint_camera {
    float eye[3];      /**< where it stands */
    float top_left[3]; /**< the rectangle's top left corner */
    float right[3];    /**< from the top left corner to the top right one */
    float down[3];     /**< from the top left corner to the bottom left one */
} glint_camera;

/** Where a moving object stands: p -> x p[0] + y p[1] + z p[2] + translation. The axes are a rotation's. */
typedef struct glint_pose {
    float x[3];           /**< where the object's x axis points in the world; unit length */
    float y[3];           /**< its y axis; at right angles to x */
    float z[3];           /**< its z axis: the cross product of x and y */
    float translation[3]; /**< where its origin stands, in the scene's units */
} glint_pose;

/** A camera at `eye` that looks towards `target`, with `up` upwards, through a window of that size at distance 1.
    Fails, writing nothing, with INVALID_ARGUMENT where a pointer is NULL or a number is not finite, the target is the
    eye, or `up` is along the line between them. Any thread. */
GLINT_API glint_error glint_camera_look_at(const float eye[3], const float target[3], const float up[3], float width,
                                           float height, glint_camera *camera);

/** A turn by `angle_rad` about an axis (of any length but 0) through `pivot`, counter-clockwise as seen from the axis'
    tip, and then a move. `pivot` and `moved_by` may be NULL: the origin, and no move.
    Fails, writing nothing, with INVALID_ARGUMENT where another pointer is NULL, the axis is 0, or a number is not
    finite. Any thread. */
GLINT_API glint_error glint_pose_turned(const float axis[3], double angle_rad, const float pivot[3],
                                        const float moved_by[3], glint_pose *pose);

/* ---- Where files come from ---- */

/** A file in memory. */
typedef struct glint_memory_file {
    const char *path;  /**< as the scene names it from where the scene lies: "floor.obj", "models/cat.obj" */
    const void *bytes; /**< may be NULL where there are none */
    size_t byte_count; /**< of them */
} glint_memory_file;

/** A file that a glint_file_source is asked for; valid within that call. */
typedef struct glint_file glint_file;

/** Files from an app's assets, an archive, a network. Called by the thread that reads a scene, while it does.
    Callbacks return only by returning: no exception, no longjmp. */
typedef struct glint_file_source {
    size_t size; /**< of this struct, set by the caller */
    void *user;  /**< given to the callbacks */
    /** Reads the whole file: takes memory for it with glint_file_allocate(), fills it and returns GLINT_OK; without a
        call of that the file is empty. Else GLINT_ERROR_NOT_FOUND, LIMIT_EXCEEDED, IO or OUT_OF_MEMORY; any other code
        counts as IO. `path` has '/' between folders and neither "." nor "..". Not NULL. */
    glint_error (*read)(void *user, const char *path, uint64_t max_bytes, glint_file *file);
    /** Whether there is such a file, as 0 or not 0. NULL: read() is asked, with max_bytes 0. */
    int32_t (*contains)(void *user, const char *path);
} glint_file_source;

/** Memory for so many bytes of the file, to be filled; freed by the library. A second call takes the place of the
    first. NULL where the file is NULL, there are more bytes than read()'s max_bytes, or memory is out. */
GLINT_API void *glint_file_allocate(glint_file *file, size_t byte_count);

/* ---- Reading ---- */

/** What a reader may do and how much it will take. */
typedef struct glint_read_options {
    size_t size; /**< of this struct; glint_read_options_init() sets it */
    /** Folder that no path of the scene may leave; NULL, the default, is the scene file's own. What a scene names is
        looked for in its own folder, then in each above it up to this one. */
    const char *scene_root;
    const char *dialect; /**< to read the file as, "mobile2013"; NULL, the default: what the file's directives show */
    const glint_file_source *files;        /**< NULL, the default: the system's files */
    const glint_memory_file *memory_files; /**< instead of `files`: these and no others; NULL, the default */
    size_t memory_file_count;              /**< 0 where memory_files is NULL */
    uint64_t max_file_bytes;               /**< of each file; default 4 GiB */
    uint64_t max_pixels;                   /**< width * height that a scene may ask for; default 2^26 */
    uint64_t max_triangles;                /**< default 2^27 */
    uint32_t max_depth;                    /**< recursive rays in a row that a scene may ask for; default 1000 */
    int32_t flat;                          /**< not 0: normals are left aside, every triangle is flat; default 0 */
    int32_t allow_outside_root;            /**< not 0: paths may be absolute or leave the scene root; default 0 */
    uint32_t reserved;                     /**< 0 */
} glint_read_options;

/** Sets all defaults. `size` is sizeof *options; see "Structs that grow" in <glint/glint.h>. */
GLINT_API glint_error glint_read_options_init(glint_read_options *options, size_t size);

/** Reads an SDL file and every mesh it names. Textures of materials are left aside, with a warning. `file` is a path as
    the system has them (UTF-8 on phones and Linux), or one in the options' source. `options` may be NULL: defaults.
    The calling thread reads; any number of threads may read at once.

    Leaves a handle in *scene, to be released, also on failure: then it only answers glint_last_error_message(),
    which has every problem that could be found in one run, and glint_scene_get_diagnostic(), which has them in parts.

    Fails with INVALID_ARGUMENT, BAD_INPUT, NOT_FOUND, LIMIT_EXCEEDED, IO, OUT_OF_MEMORY. */
GLINT_API glint_error glint_scene_read(const char *file, const glint_read_options *options, glint_scene **scene);

/** The same of a text in memory, `byte_count` bytes of it. `file` is where it would lie, "room.sdl": messages call it
    so, and what it names is looked for from there. `text` may be NULL where byte_count is 0. */
GLINT_API glint_error glint_scene_read_text(const char *text, size_t byte_count, const char *file,
                                            const glint_read_options *options, glint_scene **scene);

/** Gives the handle up. What was made from it lives on. NULL does nothing. */
GLINT_API void glint_scene_release(glint_scene *scene);

/* ---- Looking at it ---- */

/** What is in a scene. Strings live as long as the handle. */
typedef struct glint_scene_info {
    size_t size;                /**< of this struct, set by the caller */
    const char *dialect;        /**< that the file was read as; "" for a scene that was not read */
    const char *dialect_reason; /**< the directive, and its line, that decided; "" likewise */
    const char *output_file;    /**< the `output` directive, as written; "" without one */
    uint32_t objects;           /**< that are lit */
    uint32_t lights;            /**< glowing surfaces and others */
    uint32_t triangles;         /**< of all objects and lights */
    uint32_t quadrics;          /**< likewise */
    uint32_t skipped_triangles; /**< that had no area and were left out */
    uint32_t warnings;          /**< what glint_scene_get_diagnostic() has */
    uint32_t width_px;          /**< of the picture that the scene asks for */
    uint32_t height_px;         /**< likewise */
    uint32_t max_depth;         /**< likewise: recursive rays in a row after the primary ray */
    uint32_t samples_per_pixel; /**< likewise */
    int32_t is_animated;        /**< 1 where glint_scene_at() has something to move, else 0 */
    uint32_t reserved;          /**< 0 */
} glint_scene_info;

/** Fills *info, as much of it as info->size says.
    Fails, writing nothing, with INVALID_ARGUMENT: a pointer is NULL, the size is wrong, or the scene was not made. */
GLINT_API glint_error glint_scene_get_info(const glint_scene *scene, glint_scene_info *info);

/** The box around all objects where their meshes say, without lamps and without what goes on for ever: x, y and z of
    its corners. Of no such object, lower is infinite and upper minus infinite. Looks at every triangle. Fails, writing
    nothing, with INVALID_ARGUMENT: a pointer is NULL, or the scene was not made; OUT_OF_MEMORY. */
GLINT_API glint_error glint_scene_get_bounds(const glint_scene *scene, float lower[3], float upper[3]);

/** A problem with a file, or a warning about it. Strings live as long as the scene's handle and are never NULL. */
typedef struct glint_diagnostic {
    size_t size;             /**< of this struct, set by the caller */
    const char *file;        /**< as the caller named it; "" where there is none */
    const char *message;     /**< what was found and what was expected: one sentence */
    const char *hint;        /**< how to go on; "" where nobody knows */
    const char *source_line; /**< the line's text; may be "" */
    uint32_t line;           /**< from 1; 0 = the file as a whole */
    uint32_t column;         /**< from 1, in bytes; 0 = no particular column */
    int32_t is_error;        /**< 1; 0 for a warning */
    uint32_t reserved;       /**< 0 */
} glint_diagnostic;

/** The diagnostic `index`, from 0 on: the warnings of a scene that was read, or everything that kept it from being
    made. Fails, writing nothing, with INVALID_ARGUMENT where there are not so many, a pointer is NULL, or the size is
    wrong. */
GLINT_API glint_error glint_scene_get_diagnostic(const glint_scene *scene, uint32_t index,
                                                 glint_diagnostic *diagnostic);

/** One object of a scene. */
typedef struct glint_object_info {
    size_t size;        /**< of this struct, set by the caller */
    const char *name;   /**< lives as long as the scene's handle */
    uint32_t triangles; /**< 0 of a quadric */
    int32_t can_move;   /**< 1 where it has a pose, else 0 */
    glint_pose pose;    /**< where it stands; no turn and no move where it cannot move */
} glint_object_info;

/** The object `index`, from 0 to objects - 1. Fails as glint_scene_get_diagnostic() does. */
GLINT_API glint_error glint_scene_get_object(const glint_scene *scene, uint32_t index, glint_object_info *info);

/** The scene's own camera. Fails, writing nothing, with INVALID_ARGUMENT: NULL, or the scene was not made. */
GLINT_API glint_error glint_scene_get_camera(const glint_scene *scene, glint_camera *camera);

/* ---- Moving ---- */

/** A new place for a moving object. */
typedef struct glint_object_pose {
    uint32_t object; /**< of those that have a pose */
    glint_pose pose; /**< where it is to stand */
} glint_object_pose;

/** Another scene in which `count` objects stand elsewhere; the others stay, and meshes are shared. Made in microseconds
    an object; glint_renderer_set_scene() goes on from there as quickly. `poses` may be NULL where count is 0.

    Leaves a handle in *moved as glint_scene_read() does. Fails with INVALID_ARGUMENT; with BAD_INPUT where an object is
    not there or cannot move, or a pose is not finite, more than 1e12 away, or no rotation to within 1e-4; with
    OUT_OF_MEMORY. */
GLINT_API glint_error glint_scene_move(const glint_scene *scene, const glint_object_pose *poses, size_t count,
                                       glint_scene **moved);

/** Another scene: this one at a time of its animation, in seconds. Of a scene without animation it is the same. Leaves
    a handle, and fails, as glint_scene_move() does. */
GLINT_API glint_error glint_scene_at(const glint_scene *scene, double time_s, glint_scene **moved);

GLINT_C_END

#endif
