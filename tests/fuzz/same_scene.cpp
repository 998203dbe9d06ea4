// Whether two scenes are the same in everything that can be seen of them.
#include "fuzz/same_scene.hpp"

#include "fuzz/verdict.hpp"

namespace glint::fuzz {

namespace {

void require_same(const std::shared_ptr<const Mesh> &one, const std::shared_ptr<const Mesh> &other) {
    require(!one == !other, "a mesh came or went");
    if (!one) return;
    require(one->positions == other->positions && one->triangles == other->triangles, "a mesh became another");
    require(one->normals == other->normals && one->normal_corners == other->normal_corners, "normals became others");
    require(one->texcoords == other->texcoords && one->texcoord_corners == other->texcoord_corners,
            "texture coordinates became others");
}

void require_same(const Material &one, const Material &other) {
    require(one.color == other.color && one.highlight_color == other.highlight_color, "a colour became another");
    require(one.ambient == other.ambient && one.diffuse == other.diffuse && one.specular == other.specular &&
                one.specular_exponent == other.specular_exponent,
            "a material became another");
    require(one.reflection == other.reflection && one.transmission == other.transmission && one.ior == other.ior,
            "glass became another");
    require(one.adds_to_local == other.adds_to_local, "mirrors became others");
    require(!one.texture == !other.texture, "a texture came or went");
}

void require_same(const Light &one, const Light &other) {
    require(one.kind == other.kind, "a light's kind became another");
    require_same(one.mesh, other.mesh);
    require(one.quadric == other.quadric, "a light's quadric became another");
    require(one.color == other.color && one.intensity == other.intensity, "a light's colour became another");
    require(one.position == other.position && one.direction == other.direction, "a light moved");
    require(one.inner_angle == other.inner_angle && one.outer_angle == other.outer_angle, "a cone became another");
    require(one.has_falloff == other.has_falloff, "a light's falloff became another");
    require(one.shadow_rays == other.shadow_rays && one.grid_width == other.grid_width &&
                one.grid_height == other.grid_height,
            "shadow rays became others");
}

void require_same(const PictureSettings &one, const PictureSettings &other) {
    require(one.width_px == other.width_px && one.height_px == other.height_px, "the size became another");
    require(one.max_depth == other.max_depth, "the depth became another");
    require(one.samples_per_pixel == other.samples_per_pixel && one.pattern == other.pattern && one.seed == other.seed,
            "samples became others");
    require(one.tone_scale == other.tone_scale, "the tone curve became another");
    require(one.paths_per_pixel == other.paths_per_pixel, "the paths became others");
}

} // namespace

void require_same(const Scene &one, const Scene &other) {
    require(one.objects().size() == other.objects().size(), "objects came or went");
    for (size_t i = 0; i < one.objects().size(); ++i) {
        require_same(one.objects()[i].mesh, other.objects()[i].mesh);
        require(one.objects()[i].quadric == other.objects()[i].quadric, "a quadric became another");
        require_same(one.objects()[i].material, other.objects()[i].material);
    }
    require(one.lights().size() == other.lights().size(), "lights came or went");
    for (size_t i = 0; i < one.lights().size(); ++i) require_same(one.lights()[i], other.lights()[i]);
    const Camera &a = one.camera(), &b = other.camera();
    require(a.eye == b.eye && a.top_left == b.top_left && a.right == b.right && a.down == b.down, "the camera moved");
    require_same(one.picture(), other.picture());
    require(one.background() == other.background(), "the background became another");
    require(one.ambient() == other.ambient(), "the ambient light became another");
    require(one.optics().fresnel == other.optics().fresnel &&
                one.optics().shadows_through_glass == other.optics().shadows_through_glass,
            "the optics became others");
}

} // namespace glint::fuzz
