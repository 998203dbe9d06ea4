/* Scenes made in code, in C: meshes from the caller's arrays, quadrics, materials, lights, a camera. */
#ifndef GLINT_SCENE_BUILDER_H
#define GLINT_SCENE_BUILDER_H

#include <stddef.h>
#include <stdint.h>

#include <glint/error.h>
#include <glint/export.h>
#include <glint/scene.h>

GLINT_C_BEGIN

/** Collects the parts of a scene, then checks them once. One thread at a time uses it. What is added is copied, so that
    arrays and strings may go as soon as the call is over. */
typedef struct glint_scene_builder glint_scene_builder;

/** Leaves an empty builder in *builder. Fails with INVALID_ARGUMENT where `builder` is NULL, else with OUT_OF_MEMORY,
    and then leaves NULL. */
GLINT_API glint_error glint_scene_builder_create(glint_scene_builder **builder);

/** Gives the builder up. NULL does nothing. */
GLINT_API void glint_scene_builder_release(glint_scene_builder *builder);

/** Triangles. Lengths of arrays are in elements of the struct, not in floats. */
typedef struct glint_mesh {
    size_t size;               /**< of this struct; glint_mesh_init() sets it */
    const float *positions;    /**< x, y, z of each, in the scene's units, at most 1e12 */
    const uint32_t *triangles; /**< three positions of each; either way round */
    const float *normals;      /**< x, y, z of each, of any length but 0; NULL, the default: flat triangles */
    /** Three normals of each triangle, or GLINT_NONE as the first of a flat one. NULL, the default: normals are
        numbered as positions are. */
    const uint32_t *normal_corners;
    /** u from left to right and v from bottom to top of each, repeating from 1 on; NULL, the default: none. */
    const float *texcoords;
    const uint32_t *texcoord_corners; /**< as normal_corners */
    size_t position_count;            /**< default 0, as of the next three */
    size_t triangle_count;            /**< also of normal_corners and texcoord_corners, where those are given */
    size_t normal_count;              /**< 0 where normals is NULL */
    size_t texcoord_count;            /**< 0 where texcoords is NULL */
} glint_mesh;

/** Sets all defaults: an empty mesh. `size` is sizeof *mesh. */
GLINT_API glint_error glint_mesh_init(glint_mesh *mesh, size_t size);

/** Copies a mesh and leaves its number in *index, for any number of objects and lights. `index` may be NULL: the first
    mesh is 0, and each has one more than the one before.
    Fails, changing nothing, with INVALID_ARGUMENT where a pointer is NULL or the size is wrong; with OUT_OF_MEMORY.
    What the mesh is like is checked by glint_scene_builder_build(). */
GLINT_API glint_error glint_scene_builder_add_mesh(glint_scene_builder *builder, const glint_mesh *mesh,
                                                   uint32_t *index);

/** Copies a picture that materials may have, width_px * height_px texels of red, green and blue in [0, 1], the top row
    first; leaves its number in *index, which may be NULL, as glint_scene_builder_add_mesh() does.
    Fails likewise, and where width_px or height_px are 0 or the texels could not be addressed. */
GLINT_API glint_error glint_scene_builder_add_texture(glint_scene_builder *builder, uint32_t width_px,
                                                      uint32_t height_px, const float *texels, uint32_t *index);

/** How a surface answers light: Whitted's model with Phong's highlights. Fractions and colours are in [0, 1]. */
typedef struct glint_material {
    size_t size;              /**< of this struct; glint_material_init() sets it */
    float color[3];           /**< linear red, green, blue; default 1, 1, 1 */
    float ambient;            /**< default 0 */
    float diffuse;            /**< default 1 */
    float specular;           /**< of the highlight; default 0 */
    float specular_exponent;  /**< 0 to 1e6; default 0 */
    float reflection;         /**< share of the colour that comes along the mirror ray; default 0 */
    float transmission;       /**< share that comes through the surface; with reflection at most 1; default 0 */
    float ior;                /**< index of refraction of what is inside, 0.01 to 100; default 1 */
    float highlight_color[3]; /**< default 1, 1, 1 */
    int32_t adds_to_local;    /**< 0, the default: mirrored light takes the place of local; not 0: is added to it */
    uint32_t texture;         /**< multiplies the colour; GLINT_NONE, the default: there is none */
    uint32_t reserved;        /**< 0 */
} glint_material;

/** Sets all defaults: white and matt. `size` is sizeof *material. */
GLINT_API glint_error glint_material_init(glint_material *material, size_t size);

/** The points where a x^2 + b y^2 + c z^2 + 2 d xy + 2 e yz + 2 f xz + 2 g x + 2 h y + 2 j z + k = 0: a sphere, a
    cylinder, a cone, ... Its inside, for refraction, is where the sum is negative. */
typedef struct glint_quadric {
    float a; /**< of x^2 */
    float b; /**< of y^2 */
    float c; /**< of z^2 */
    float d; /**< of 2 xy */
    float e; /**< of 2 yz */
    float f; /**< of 2 xz */
    float g; /**< of 2 x */
    float h; /**< of 2 y */
    float j; /**< of 2 z */
    float k; /**< the constant */
} glint_quadric;

/** A sphere; `centre` may be NULL: the origin. Fails, writing nothing, with INVALID_ARGUMENT where `quadric` is NULL or
    the radius is not above 0. Any thread. */
GLINT_API glint_error glint_quadric_sphere(const float centre[3], float radius, glint_quadric *quadric);

/** Something that is lit: a shape, which is a mesh or a quadric, and its material. */
typedef struct glint_object {
    size_t size;                    /**< of this struct; glint_object_init() sets it */
    const char *name;               /**< NULL, the default, is "" */
    const glint_material *material; /**< NULL, the default: the default one */
    const glint_quadric *quadric;   /**< instead of a mesh; NULL, the default */
    const glint_pose *pose;         /**< of an object that may move, a mesh; NULL, the default: it never does */
    uint32_t mesh;                  /**< GLINT_NONE, the default, for a quadric */
    uint32_t reserved;              /**< 0 */
} glint_object;

/** Sets all defaults: nothing, with the default material. `size` is sizeof *object. */
GLINT_API glint_error glint_object_init(glint_object *object, size_t size);

/** Adds an object. Objects are numbered from 0 on in the order they were added.
    Fails, changing nothing, with INVALID_ARGUMENT where a pointer is NULL, a size is wrong, or there is no mesh or
    texture of that number; with OUT_OF_MEMORY. */
GLINT_API glint_error glint_scene_builder_add_object(glint_scene_builder *builder, const glint_object *object);

/** Kinds of lights. */
enum {
    GLINT_LIGHT_SURFACE = 0,     /**< a glowing mesh or ellipsoid, which is seen */
    GLINT_LIGHT_POINT = 1,       /**< shines from its position; not seen */
    GLINT_LIGHT_DIRECTIONAL = 2, /**< shines along its direction, from infinitely far away */
    GLINT_LIGHT_SPOT = 3         /**< a point that shines into a cone */
};

/** Something that gives light. */
typedef struct glint_light {
    size_t size;                  /**< of this struct; glint_light_init() sets it */
    const char *name;             /**< NULL, the default, is "" */
    const glint_quadric *quadric; /**< of a surface without a mesh, an ellipsoid; NULL, the default */
    /** x, y, z, where a point or spot stands; of a surface where shadow rays aim, instead of its centre. NULL, the
        default: none. */
    const float *position;
    uint32_t mesh;        /**< of a surface; GLINT_NONE, the default */
    int32_t kind;         /**< GLINT_LIGHT_...; default GLINT_LIGHT_SURFACE */
    float color[3];       /**< default 1, 1, 1 */
    float intensity;      /**< 0 to 1e6; default 1 */
    float direction[3];   /**< of a directional or spot light, of any length but 0; default 0, -1, 0 */
    float inner_angle;    /**< of a spot, radians: full light within it; default 0 */
    float outer_angle;    /**< of a spot, radians, inner_angle to pi: none beyond it; default 0 */
    int32_t has_falloff;  /**< not 0: fades with the square of the distance; default 0 */
    uint32_t shadow_rays; /**< to random places of a surface, 1 to 4096: soft shadows; default 1 */
    uint32_t grid_width;  /**< instead: so many shadow rays in a row of a grid over the surface; default 0: no grid */
    uint32_t grid_height; /**< so many rows of them */
    uint32_t reserved;    /**< 0 */
} glint_light;

/** Sets all defaults. `size` is sizeof *light. */
GLINT_API glint_error glint_light_init(glint_light *light, size_t size);

/** Adds a light. Fails as glint_scene_builder_add_object() does, and where there is no such kind. */
GLINT_API glint_error glint_scene_builder_add_light(glint_scene_builder *builder, const glint_light *light);

/** Sets the camera; without, it stands at (0, 0, 5.7) and looks through the square from (-1, -1, 0) to (1, 1, 0).
    Fails with INVALID_ARGUMENT where a pointer is NULL. */
GLINT_API glint_error glint_scene_builder_set_camera(glint_scene_builder *builder, const glint_camera *camera);

/** Where in a pixel its samples lie. */
enum {
    GLINT_PATTERN_CENTRE = 0,     /**< in the middles of a grid of cells */
    GLINT_PATTERN_STRATIFIED = 1, /**< at random in the cells of that grid */
    GLINT_PATTERN_JITTERED = 2    /**< at random in the pixel */
};

/** How the scene is meant to be rendered, and how light behaves in it. */
typedef struct glint_scene_settings {
    size_t size;                   /**< of this struct; glint_scene_settings_init() sets it */
    float background[3];           /**< linear, 0 to 1e6; default black */
    float ambient;                 /**< 0 to 1e6; default 0 */
    uint32_t width_px;             /**< default 256 */
    uint32_t height_px;            /**< default 256 */
    uint32_t max_depth;            /**< recursive rays in a row after the primary ray; default 1 */
    uint32_t samples_per_pixel;    /**< 1 to 4096; default 1 */
    int32_t pattern;               /**< GLINT_PATTERN_...; default GLINT_PATTERN_CENTRE */
    uint32_t seed;                 /**< of everything that is random; default 0 */
    float tone_scale;              /**< t of the tone curve c / (c + t); 0, the default: no curve */
    int32_t fresnel;               /**< not 0: surfaces that refract mirror more at grazing angles; default 0 */
    int32_t shadows_through_glass; /**< not 0: shadow rays go through surfaces that let light through; default 0 */
    uint32_t reserved;             /**< 0 */
} glint_scene_settings;

/** Sets all defaults. `size` is sizeof *settings. */
GLINT_API glint_error glint_scene_settings_init(glint_scene_settings *settings, size_t size);

/** Sets them all at once. Fails with INVALID_ARGUMENT where a pointer is NULL, the size is wrong, or there is no such
    pattern. */
GLINT_API glint_error glint_scene_builder_set_settings(glint_scene_builder *builder,
                                                       const glint_scene_settings *settings);

/** Checks everything and makes a scene of it; the builder is empty afterwards. Leaves a handle in *scene, to be
    released, also on failure, as glint_scene_read() does.
    Fails with INVALID_ARGUMENT; with BAD_INPUT, naming every problem, where there is no object, a shape is missing or
    empty, a corner is out of range, or a number is; with LIMIT_EXCEEDED and OUT_OF_MEMORY. */
GLINT_API glint_error glint_scene_builder_build(glint_scene_builder *builder, glint_scene **scene);

GLINT_C_END

#endif
