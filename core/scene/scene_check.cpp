// What the parts of a scene must fulfil.
#include "scene/scene_check.hpp"

#include <algorithm>
#include <cmath>

#include "scene/quadric_shape.hpp"
#include "scene/rigid_check.hpp"
#include "scene/triangle_area.hpp"

namespace glint {

namespace {

constexpr float pi = 3.14159274f;

bool is_zero(const glm::vec3 &v) {
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

} // namespace

bool is_place(const glm::vec3 &p) {
    // Written so that NaN fails.
    return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate && std::abs(p.z) <= max_coordinate;
}

std::string surface_name(const char *kind, size_t index, const std::string &name) {
    std::string text = std::string(kind) + ' ' + std::to_string(index);
    if (!name.empty()) text += " '" + name + '\'';
    return text;
}

void SceneChecker::complain(std::string message) {
    Diagnostic diagnostic;
    diagnostic.message = std::move(message);
    diagnostics_.push_back(std::move(diagnostic));
}

void SceneChecker::number(float value, float lowest, float highest, const std::string &what) {
    if (!(value >= lowest && value <= highest)) { // so that NaN fails
        complain(what + " is " + std::to_string(value) + ", expected a number from " + std::to_string(lowest) + " to " +
                 std::to_string(highest));
    }
}

void SceneChecker::color(const Color &value, float highest, const std::string &what) {
    for (int channel = 0; channel < 3; ++channel) number(value[channel], 0.0f, highest, what);
}

void SceneChecker::material(const Material &m, const std::string &owner) {
    color(m.color, 1.0f, owner + ": colour");
    number(m.ambient, 0.0f, 1.0f, owner + ": ka");
    number(m.diffuse, 0.0f, 1.0f, owner + ": kd");
    number(m.specular, 0.0f, 1.0f, owner + ": ks");
    number(m.specular_exponent, 0.0f, max_intensity, owner + ": ke");
    number(m.reflection, 0.0f, 1.0f, owner + ": kr");
    number(m.transmission, 0.0f, 1.0f, owner + ": kt");
    number(m.ior, least_ior, greatest_ior, owner + ": index of refraction");
    color(m.highlight_color, 1.0f, owner + ": highlight colour");
    // 0.8 + 0.2 is a rounding above 1 in some pairs; the weight of the local colour is clamped when shading.
    if (m.reflection + m.transmission > 1.0f + 1e-6f) {
        complain(owner + ": kr + kt is " + std::to_string(m.reflection + m.transmission) + ", expected at most 1");
    }
    if (m.texture) texture(*m.texture, owner);
}

void SceneChecker::texture(const Texture &texture, const std::string &owner) {
    const uint64_t texels = uint64_t{texture.width_px} * texture.height_px;
    constexpr uint32_t longest_side = 1u << 20;
    if (texels == 0 || texture.width_px > longest_side || texture.height_px > longest_side ||
        texels != texture.texels.size()) {
        return complain(owner + ": its texture is " + std::to_string(texture.width_px) + " x " +
                        std::to_string(texture.height_px) + " pixels and has " + std::to_string(texture.texels.size()));
    }
    for (const Color &texel : texture.texels) {
        for (int channel = 0; channel < 3; ++channel) {
            if (!(texel[channel] >= 0.0f && texel[channel] <= 1.0f)) {
                return complain(owner + ": its texture has a channel outside [0, 1]");
            }
        }
    }
}

void SceneChecker::object(Object &object, const std::string &owner) {
    material(object.material, owner);
    if (object.pose) {
        if (const auto problem = straighten(*object.pose)) complain(owner + ": " + *problem);
    }
    if (!object.quadric) {
        object.mesh = mesh(object.mesh, owner);
        return;
    }
    if (object.mesh) complain(owner + ": is both a mesh and a quadric");
    if (const auto problem = quadric_problem(*object.quadric)) complain(owner + ": " + *problem);
}

void SceneChecker::light(Light &light, const std::string &owner) {
    color(light.color, max_intensity, owner + ": colour");
    number(light.intensity, 0.0f, max_intensity, owner + ": intensity");
    const bool is_surface = light.kind == Light::Kind::surface;
    const bool has_place = light.kind == Light::Kind::point || light.kind == Light::Kind::spot;
    if (light.position ? !is_place(*light.position) : has_place) {
        complain(owner + ": its position is not a finite place within 1e12 of the origin");
    }
    if (light.kind == Light::Kind::directional || light.kind == Light::Kind::spot) {
        if (!is_place(light.direction) || is_zero(light.direction)) {
            complain(owner + ": its direction is zero or not finite");
        }
    }
    if (light.kind == Light::Kind::spot) {
        number(light.outer_angle, 0.0f, pi, owner + ": outer angle");
        number(light.inner_angle, 0.0f, light.outer_angle, owner + ": inner angle");
    }
    const uint64_t cells = uint64_t{light.grid_width} * light.grid_height;
    if (light.shadow_rays < 1 || light.shadow_rays > max_samples || cells > max_samples ||
        (cells == 0 && light.grid_width + light.grid_height > 0)) {
        complain(owner + ": expected 1 to " + std::to_string(max_samples) + " shadow rays");
    }
    if (!is_surface) {
        if (light.mesh || light.quadric) complain(owner + ": has a shape, but is not a glowing surface");
        return;
    }
    if (!light.quadric) {
        light.mesh = mesh(light.mesh, owner);
        return;
    }
    if (light.mesh) complain(owner + ": is both a mesh and a quadric");
    if (const auto problem = quadric_problem(*light.quadric)) {
        complain(owner + ": " + *problem);
    } else if (!quadric_shape(*light.quadric).is_bounded && !light.position) {
        complain(owner + ": a quadric without bounds has no centre that light could come from");
    }
}

void SceneChecker::picture(const PictureSettings &picture) {
    if (picture.width_px == 0 || picture.height_px == 0) {
        complain("the picture is " + std::to_string(picture.width_px) + " x " + std::to_string(picture.height_px) +
                 " pixels, expected at least 1 x 1");
    }
    if (picture.samples_per_pixel < 1 || picture.samples_per_pixel > max_samples) {
        complain("the picture has " + std::to_string(picture.samples_per_pixel) + " samples a pixel, expected 1 to " +
                 std::to_string(max_samples));
    }
    number(picture.tone_scale, 0.0f, max_intensity, "the scale of the tone curve");
}

std::shared_ptr<const Mesh> SceneChecker::mesh(const std::shared_ptr<const Mesh> &mesh, const std::string &owner) {
    if (!mesh) return complain(owner + ": has no mesh"), nullptr;
    if (const auto seen = checked_.find(mesh.get()); seen != checked_.end()) {
        skipped_ += seen->second.skipped;
        return seen->second.mesh;
    }
    return (checked_[mesh.get()] = check_mesh(mesh, owner)).mesh;
}

SceneChecker::CheckedMesh SceneChecker::check_mesh(const std::shared_ptr<const Mesh> &mesh, const std::string &owner) {
    if (mesh->triangles.empty()) return complain(owner + ": its mesh has no triangles"), CheckedMesh{};
    for (const Point &p : mesh->positions) {
        if (is_place(p)) continue;
        return complain(owner + ": vertex " + std::to_string(&p - mesh->positions.data()) +
                        " is not a finite place within 1e12 of the origin"),
               CheckedMesh{};
    }
    const size_t count = mesh->positions.size();
    uint64_t skipped = 0;
    for (const Triangle &t : mesh->triangles) {
        if (t.a >= count || t.b >= count || t.c >= count) {
            return complain(owner + ": triangle " + std::to_string(&t - mesh->triangles.data()) + " uses vertex " +
                            std::to_string(std::max({t.a, t.b, t.c})) + " of " + std::to_string(count)),
                   CheckedMesh{};
        }
        if (!has_area(*mesh, t)) ++skipped;
    }
    if (!corners_are_valid(*mesh, owner)) return {};
    if (skipped == 0) return {mesh, 0};
    if (skipped == mesh->triangles.size()) {
        return complain(owner + ": none of its mesh's triangles has an area"), CheckedMesh{};
    }
    skipped_ += skipped;
    auto kept = std::make_shared<Mesh>(*mesh);
    erase_triangles_without_area(*kept);
    return {std::move(kept), skipped};
}

bool SceneChecker::corners_are_valid(const Mesh &mesh, const std::string &owner) {
    const auto check = [&](const std::vector<Triangle> &corners, size_t count, const std::string &what) {
        if (!corners.empty() && corners.size() != mesh.triangles.size()) {
            return complain(owner + ": has " + what + " for " + std::to_string(corners.size()) + " of " +
                            std::to_string(mesh.triangles.size()) + " triangles"),
                   false;
        }
        for (const Triangle &t : corners) {
            if (t.a == no_corner || (t.a < count && t.b < count && t.c < count)) continue;
            return complain(owner + ": triangle " + std::to_string(&t - corners.data()) + " uses one of its " + what +
                            " that is not there"),
                   false;
        }
        return true;
    };
    for (const Vector &n : mesh.normals) {
        if (is_place(n) && !is_zero(n)) continue;
        return complain(owner + ": normal " + std::to_string(&n - mesh.normals.data()) + " is zero or not finite"),
               false;
    }
    for (const glm::vec2 &t : mesh.texcoords) {
        if (std::abs(t.x) <= max_coordinate && std::abs(t.y) <= max_coordinate) continue;
        return complain(owner + ": texture coordinate " + std::to_string(&t - mesh.texcoords.data()) +
                        " is not finite"),
               false;
    }
    return check(mesh.normal_corners, mesh.normals.size(), "normals") &&
           check(mesh.texcoord_corners, mesh.texcoords.size(), "texture coordinates");
}

} // namespace glint
