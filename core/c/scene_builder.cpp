// Making scenes in code, for C.
#include <glint/scene_builder.h>

#include "c/scene_handle.hpp"
#include "c/sized.hpp"

struct glint_scene_builder : glint::HandleOf<glint::HandleKind::scene_builder> {
    [[nodiscard]] bool is_made() const { return true; }

    glint::SceneBuilder builder;
    // Meshes and textures, by their numbers.
    std::vector<std::shared_ptr<const void>> meshes, textures;
};

using namespace glint;

namespace {

constexpr const char *no_struct = "a pointer is NULL, or it leads to no valid struct: see its size";

constexpr const char *no_mesh = "there is no mesh of this number";

/// Most elements of an array, so that no size of it overflows.
constexpr size_t most_elements = size_t{1} << (sizeof(size_t) > 4 ? 32 : 26);

/// Copies an array of C's into one of a type that is made of the same numbers. False where there is none.
template <typename From, typename To> bool copy(const From *from, size_t count, std::vector<To> &to) {
    static_assert(sizeof(To) % sizeof(From) == 0 && alignof(To) == alignof(From));
    if (count > most_elements || (!from && count > 0)) return false;
    const To *const first = reinterpret_cast<const To *>(from);
    to = std::vector<To>(first, first + count);
    return true;
}

/// The corners of all triangles: their own or, where they have none, those of their positions.
std::vector<Triangle> corners_of(const uint32_t *corners, const Mesh &mesh) {
    std::vector<Triangle> own;
    if (corners && copy(corners, mesh.triangles.size(), own)) return own;
    return mesh.triangles;
}

/// Adds to a list and tells the number.
glint_error add_numbered(std::vector<std::shared_ptr<const void>> &list, std::shared_ptr<const void> item,
                         uint32_t *index) {
    list.push_back(std::move(item));
    if (index) *index = static_cast<uint32_t>(list.size() - 1);
    return GLINT_OK;
}

/// Whether there is an item of that number, or none is asked for.
bool has(const std::vector<std::shared_ptr<const void>> &list, uint32_t index) {
    return index == GLINT_NONE || index < list.size();
}

template <typename T>
std::shared_ptr<const T> find(const std::vector<std::shared_ptr<const void>> &list, uint32_t index) {
    return index == GLINT_NONE ? nullptr : std::static_pointer_cast<const T>(list[index]);
}

glint_material default_material() {
    glint_material material = {};
    const Material from;
    material.size = sizeof material;
    store(from.color, material.color);
    material.diffuse = from.diffuse;
    material.ior = from.ior;
    store(from.highlight_color, material.highlight_color);
    material.texture = GLINT_NONE;
    return material;
}

glint_object default_object() {
    glint_object object = {};
    object.size = sizeof object;
    object.mesh = GLINT_NONE;
    return object;
}

glint_light default_light() {
    glint_light light = {};
    const Light from;
    light.size = sizeof light;
    light.mesh = GLINT_NONE;
    store(from.color, light.color);
    light.intensity = from.intensity;
    store(from.direction, light.direction);
    light.shadow_rays = from.shadow_rays;
    return light;
}

glint_scene_settings default_settings() {
    glint_scene_settings settings = {};
    const PictureSettings from;
    settings.size = sizeof settings;
    settings.width_px = from.width_px;
    settings.height_px = from.height_px;
    settings.max_depth = from.max_depth;
    settings.samples_per_pixel = from.samples_per_pixel;
    return settings;
}

std::optional<Quadric> quadric_of(const glint_quadric *q) {
    if (!q) return std::nullopt;
    return Quadric{q->a, q->b, q->c, q->d, q->e, q->f, q->g, q->h, q->j, q->k};
}

std::string text_of(const char *text) {
    return text ? text : "";
}

Object object_of(const glint_scene_builder &builder, const glint_object &given, const glint_material &look) {
    Object made;
    made.name = text_of(given.name);
    made.mesh = find<Mesh>(builder.meshes, given.mesh);
    made.quadric = quadric_of(given.quadric);
    if (given.pose) made.pose = glint::pose_of(*given.pose);
    Material &material = made.material;
    material.color = vec3_of(look.color);
    material.ambient = look.ambient;
    material.diffuse = look.diffuse;
    material.specular = look.specular;
    material.specular_exponent = look.specular_exponent;
    material.reflection = look.reflection;
    material.transmission = look.transmission;
    material.ior = look.ior;
    material.highlight_color = vec3_of(look.highlight_color);
    material.adds_to_local = look.adds_to_local != 0;
    material.texture = find<Texture>(builder.textures, look.texture);
    return made;
}

Light light_of(const glint_scene_builder &builder, const glint_light &given) {
    Light made;
    made.name = text_of(given.name);
    made.mesh = find<Mesh>(builder.meshes, given.mesh);
    made.color = vec3_of(given.color);
    made.intensity = given.intensity;
    made.kind = static_cast<Light::Kind>(given.kind);
    made.quadric = quadric_of(given.quadric);
    if (given.position) made.position = Point(given.position[0], given.position[1], given.position[2]);
    made.direction = vec3_of(given.direction);
    made.inner_angle = given.inner_angle;
    made.outer_angle = given.outer_angle;
    made.has_falloff = given.has_falloff != 0;
    made.shadow_rays = given.shadow_rays;
    made.grid_width = given.grid_width;
    made.grid_height = given.grid_height;
    return made;
}

} // namespace

glint_error glint_scene_builder_create(glint_scene_builder **builder) {
    return create(builder, [](glint_scene_builder &) -> glint_error { return GLINT_OK; });
}

void glint_scene_builder_release(glint_scene_builder *builder) {
    release(builder);
}

glint_error glint_mesh_init(glint_mesh *mesh, size_t size) {
    glint_mesh defaults = {};
    defaults.size = sizeof defaults;
    return init(mesh, size, defaults);
}
glint_error glint_material_init(glint_material *material, size_t size) {
    return init(material, size, default_material());
}
glint_error glint_object_init(glint_object *object, size_t size) {
    return init(object, size, default_object());
}
glint_error glint_light_init(glint_light *light, size_t size) {
    return init(light, size, default_light());
}
glint_error glint_scene_settings_init(glint_scene_settings *settings, size_t size) {
    return init(settings, size, default_settings());
}

glint_error glint_scene_builder_add_mesh(glint_scene_builder *builder, const glint_mesh *mesh, uint32_t *index) {
    return call(builder, [&](glint_scene_builder &handle) -> glint_error {
        glint_mesh given = {};
        if (!mesh || !take(mesh, given)) return handle.refuse(no_struct);
        const auto made = std::make_shared<Mesh>();
        if (!copy(given.positions, given.position_count, made->positions) ||
            !copy(given.triangles, given.triangle_count, made->triangles) ||
            !copy(given.normals, given.normal_count, made->normals) ||
            !copy(given.texcoords, given.texcoord_count, made->texcoords)) {
            return handle.refuse("the mesh says that it has more elements than there are");
        }
        if (!made->normals.empty()) made->normal_corners = corners_of(given.normal_corners, *made);
        if (!made->texcoords.empty()) made->texcoord_corners = corners_of(given.texcoord_corners, *made);
        return add_numbered(handle.meshes, made, index);
    });
}

glint_error glint_scene_builder_add_texture(glint_scene_builder *builder, uint32_t width_px, uint32_t height_px,
                                            const float *texels, uint32_t *index) {
    return call(builder, [&](glint_scene_builder &handle) -> glint_error {
        const auto made = std::make_shared<Texture>();
        made->width_px = width_px;
        made->height_px = height_px;
        const uint64_t count = uint64_t{width_px} * height_px;
        if (count == 0 || count > most_elements || !copy(texels, static_cast<size_t>(count), made->texels)) {
            return handle.refuse("the texture has no texels, or too many");
        }
        return add_numbered(handle.textures, made, index);
    });
}

glint_error glint_scene_builder_add_object(glint_scene_builder *builder, const glint_object *object) {
    return call(builder, [&](glint_scene_builder &handle) -> glint_error {
        glint_object given = default_object();
        glint_material look = default_material();
        if (!object || !take(object, given) || !take(given.material, look)) return handle.refuse(no_struct);
        if (!has(handle.meshes, given.mesh)) return handle.refuse(no_mesh);
        if (!has(handle.textures, look.texture)) return handle.refuse("there is no texture of this number");
        handle.builder.add_object(object_of(handle, given, look));
        return GLINT_OK;
    });
}

glint_error glint_scene_builder_add_light(glint_scene_builder *builder, const glint_light *light) {
    return call(builder, [&](glint_scene_builder &handle) -> glint_error {
        glint_light given = default_light();
        if (!light || !take(light, given)) return handle.refuse(no_struct);
        if (given.kind < GLINT_LIGHT_SURFACE || given.kind > GLINT_LIGHT_SPOT) {
            return handle.refuse("there is no such kind of light");
        }
        if (!has(handle.meshes, given.mesh)) return handle.refuse(no_mesh);
        handle.builder.add_light(light_of(handle, given));
        return GLINT_OK;
    });
}

glint_error glint_scene_builder_set_camera(glint_scene_builder *builder, const glint_camera *camera) {
    return call(builder, [&](glint_scene_builder &handle) -> glint_error {
        if (!camera) return handle.refuse("the camera is NULL");
        handle.builder.set_camera(camera_of(*camera));
        return GLINT_OK;
    });
}

glint_error glint_scene_builder_set_settings(glint_scene_builder *builder, const glint_scene_settings *settings) {
    return call(builder, [&](glint_scene_builder &handle) -> glint_error {
        glint_scene_settings given = default_settings();
        if (!settings || !take(settings, given)) return handle.refuse(no_struct);
        if (given.pattern < GLINT_PATTERN_CENTRE || given.pattern > GLINT_PATTERN_JITTERED) {
            return handle.refuse("there is no such pattern of samples");
        }
        PictureSettings picture;
        picture.width_px = given.width_px;
        picture.height_px = given.height_px;
        picture.max_depth = given.max_depth;
        picture.samples_per_pixel = given.samples_per_pixel;
        picture.pattern = static_cast<SamplePattern>(given.pattern);
        picture.seed = given.seed;
        picture.tone_scale = given.tone_scale;
        handle.builder.set_background(vec3_of(given.background))
            .set_ambient(given.ambient)
            .set_picture(picture)
            .set_optics({given.fresnel != 0, given.shadows_through_glass != 0});
        return GLINT_OK;
    });
}

glint_error glint_scene_builder_build(glint_scene_builder *builder, glint_scene **scene) {
    return create(scene, [&](glint_scene &handle) -> glint_error {
        if (!is_handle(builder)) return handle.refuse("there is no builder");
        builder->meshes.clear();
        builder->textures.clear();
        return handle.take(builder->builder.build());
    });
}
