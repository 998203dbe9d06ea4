// What a scene has that peers do not know.
#include "bench/unsupported_feature.hpp"

namespace glint::bench {
namespace {

std::string of(const char *what, const char *kind, const std::string &name) {
    return std::string(what) + " (" + kind + " '" + name + "')";
}

/// What of an object's surface a peer cannot shade, or nullptr.
const char *unsupported_material(const Object &object) {
    const Material &m = object.material;
    if (m.transmission > 0.0f && m.ior != 1.0f) return "refraction";
    if (m.adds_to_local && m.reflection + m.transmission > 0.0f) return "reflection that adds to the local colour";
    if (m.texture) return "textures";
    if (m.highlight_color != Color(1.0f)) return "coloured highlights";
    if (object.mesh && !object.mesh->normal_corners.empty()) return "smooth normals";
    return nullptr;
}

const char *unsupported_light(const Light &light) {
    if (light.kind != Light::Kind::surface) return "lights without a mesh";
    if (light.has_falloff) return "light that fades with distance";
    if (light.shadow_rays > 1 || light.grid_width > 0) return "soft shadows";
    return nullptr;
}

} // namespace

std::optional<std::string> unsupported_shape(const Scene &scene) {
    for (const Object &object : scene.objects()) {
        if (object.quadric) return of("quadrics", "object", object.name);
    }
    for (const Light &light : scene.lights()) {
        if (light.quadric) return of("quadrics", "light", light.name);
    }
    return std::nullopt;
}

std::optional<std::string> unsupported_feature(const Scene &scene) {
    if (auto shape = unsupported_shape(scene)) return shape;
    for (const Object &object : scene.objects()) {
        if (const char *what = unsupported_material(object)) return of(what, "object", object.name);
    }
    for (const Light &light : scene.lights()) {
        if (const char *what = unsupported_light(light)) return of(what, "light", light.name);
    }
    const PictureSettings &picture = scene.picture();
    if (picture.samples_per_pixel > 1) return "several samples a pixel";
    if (picture.pattern != SamplePattern::centre) return "samples at random places";
    if (picture.tone_scale > 0.0f) return "a tone curve";
    if (scene.optics().shadows_through_glass) return "shadows through glass";
    return std::nullopt;
}

} // namespace glint::bench
