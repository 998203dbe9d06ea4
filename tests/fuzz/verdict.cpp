// What every reader owes for every text.
#include "fuzz/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

#include "scene/triangle_area.hpp"

namespace glint::fuzz {

namespace {

/// What only the file as a whole can lack or be. All else has a place, and a message that is missing here is one that
/// lost it on the way: the scene builder's among them, which knows no places and must find nothing that readers missed.
constexpr std::array<std::string_view, 6> about_the_whole = {
    "there is no '", "the file has no face ('f')", "none of the mesh's triangles has an area",
    "the mesh has ", "this is not UTF-8 text",     "and ", // so many more problems
};

void require_finite(std::initializer_list<float> numbers, const char *what) {
    require(std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); }), what);
}

void require_within(float value, float lowest, float highest, const char *what) {
    require(value >= lowest && value <= highest, what); // false for NaN
}

void require_place(const Point &p, const char *what) {
    for (int axis = 0; axis < 3; ++axis) require_within(p[axis], -max_coordinate, max_coordinate, what);
}

void require_corners(const std::vector<Triangle> &corners, size_t triangles, size_t count, const char *what) {
    require(corners.empty() || corners.size() == triangles, what);
    for (const Triangle &t : corners) {
        if (t.a == no_corner) continue;
        require(t.a < count && t.b < count && t.c < count, what);
    }
}

void require_quadric(const Quadric &q) {
    require_finite({q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.j, q.k}, "a quadric's coefficient is not finite");
}

void require_shape(const std::shared_ptr<const Mesh> &mesh, const std::optional<Quadric> &quadric) {
    require(!mesh != !quadric, "a surface is a mesh or a quadric");
    if (mesh) require_valid(*mesh);
    if (quadric) require_quadric(*quadric);
}

void require_light(const Light &light) {
    for (int channel = 0; channel < 3; ++channel) {
        require_within(light.color[channel], 0.0f, max_intensity, "a light's colour is out of range");
    }
    require_within(light.intensity, 0.0f, max_intensity, "an intensity is out of range");
    if (light.position) require_place(*light.position, "a light is out of range");
    if (light.kind == Light::Kind::surface) return require_shape(light.mesh, light.quadric);
    require(light.kind == Light::Kind::directional || light.position.has_value(), "a light stands nowhere");
    require_place(light.direction, "a light's direction is out of range");
    require(light.direction != Vector(0.0f), "a light has no direction");
    require_within(light.inner_angle, 0.0f, light.outer_angle, "a spot's angle is out of range");
    require_within(light.outer_angle, 0.0f, 3.1415927f, "a spot's angle is out of range");
}

void require_camera(const Camera &camera) {
    for (const glm::vec3 &v : {camera.eye, camera.top_left, camera.right, camera.down}) {
        require_finite({v.x, v.y, v.z}, "the camera is not finite");
    }
}

} // namespace

void require(bool holds, const char *what) {
    if (holds) return;
    std::fprintf(stderr, "FAULT: %s\n", what);
    std::abort();
}

void require_valid(const Mesh &mesh) {
    require(!mesh.triangles.empty(), "a mesh has no triangle");
    for (const Point &p : mesh.positions) require_place(p, "a coordinate is out of range");
    const size_t count = mesh.positions.size();
    for (const Triangle &t : mesh.triangles) {
        require(t.a < count && t.b < count && t.c < count, "an index is out of range");
        require(has_area(mesh, t), "a triangle has no area");
    }
    for (const Vector &n : mesh.normals) require_finite({n.x, n.y, n.z}, "a normal is not finite");
    for (const glm::vec2 &t : mesh.texcoords) require_finite({t.x, t.y}, "a texture coordinate is not finite");
    require_corners(mesh.normal_corners, mesh.triangles.size(), mesh.normals.size(), "a normal's index is wrong");
    require_corners(mesh.texcoord_corners, mesh.triangles.size(), mesh.texcoords.size(),
                    "a texture coordinate's index is wrong");
}

void require_valid(const Material &material) {
    for (int channel = 0; channel < 3; ++channel) {
        require_within(material.color[channel], 0.0f, 1.0f, "a colour is out of range");
        require_within(material.highlight_color[channel], 0.0f, 1.0f, "a highlight's colour is out of range");
    }
    for (const float share :
         {material.ambient, material.diffuse, material.specular, material.reflection, material.transmission}) {
        require_within(share, 0.0f, 1.0f, "a share of light is out of range");
    }
    require_within(material.reflection + material.transmission, 0.0f, 1.00001f, "kr + kt is more than 1");
    require_within(material.specular_exponent, 0.0f, max_intensity, "an exponent is out of range");
    require_within(material.ior, least_ior, greatest_ior, "an index of refraction is out of range");
    if (!material.texture) return;
    const Texture &texture = *material.texture;
    require(texture.texels.size() == size_t{texture.width_px} * texture.height_px && !texture.texels.empty(),
            "a texture's size is wrong");
}

void require_valid(const Scene &scene) {
    require(!scene.objects().empty(), "a scene has no object");
    require(!scene.lights().empty(), "a scene that was read has no light");
    uint64_t triangles = 0;
    for (const Object &object : scene.objects()) {
        require_shape(object.mesh, object.quadric);
        require_valid(object.material);
        if (object.mesh) triangles += object.mesh->triangles.size();
    }
    for (const Light &light : scene.lights()) {
        require_light(light);
        if (light.mesh) triangles += light.mesh->triangles.size();
    }
    require(triangles == scene.triangle_count(), "triangles are counted wrongly");
    require(scene.light_positions().size() == scene.lights().size(), "lights and their positions differ in number");
    for (const Point &p : scene.light_positions()) require_finite({p.x, p.y, p.z}, "a light's position is not finite");
    require_camera(scene.camera());
    const PictureSettings &picture = scene.picture();
    require(picture.width_px > 0 && picture.height_px > 0, "the picture is empty");
    require(picture.samples_per_pixel > 0 && picture.samples_per_pixel <= max_samples, "samples are out of range");
    require_within(picture.tone_scale, 0.0f, max_coordinate, "the tone curve is out of range");
    require_within(scene.ambient(), 0.0f, max_intensity, "the ambient light is out of range");
    for (int channel = 0; channel < 3; ++channel) {
        require_within(scene.background()[channel], 0.0f, max_intensity, "the background is out of range");
    }
}

void require_reasons(const Error &error) {
    require(!error.diagnostics.empty(), "a refusal has no reason");
    require(!error.text().empty(), "a refusal cannot be shown");
    for (const Diagnostic &diagnostic : error.diagnostics) {
        require(diagnostic.severity == Diagnostic::Severity::error, "a refusal's reason is a warning");
        require(!diagnostic.message.empty(), "a refusal has no words");
        require(!diagnostic.file.empty(), "a refusal names no file");
        if (diagnostic.line > 0) {
            require(diagnostic.column > 0, "a place has a line and no column");
            const size_t length = diagnostic.source_line.size();
            require(length == 0 || diagnostic.column <= length + 1, "a place lies behind its line");
            continue;
        }
        const bool is_known = std::any_of(about_the_whole.begin(), about_the_whole.end(), [&](std::string_view words) {
            return diagnostic.message.starts_with(words);
        });
        if (!is_known) std::fprintf(stderr, "%s\n", diagnostic.text().c_str());
        require(is_known, "a refusal has no position");
    }
}

void require_words(const std::vector<Diagnostic> &warnings) {
    for (const Diagnostic &diagnostic : warnings) {
        require(diagnostic.severity == Diagnostic::Severity::warning, "a warning is an error");
        require(!diagnostic.message.empty(), "a warning has no words");
    }
}

} // namespace glint::fuzz
