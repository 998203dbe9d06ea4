// The last wall: whatever becomes a Scene has been checked here.
#include <glint/scene.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "scene/camera_check.hpp"
#include "scene/triangle_area.hpp"

namespace glint {

namespace {

/// Checks a scene's parts one by one and keeps every complaint.
class Checker {
public:
    void complain(std::string message) {
        Diagnostic diagnostic;
        diagnostic.message = std::move(message);
        diagnostics_.push_back(std::move(diagnostic));
    }

    /// Comparisons are written so that NaN fails them.
    void number(float value, float lowest, float highest, const std::string &what) {
        if (!(value >= lowest && value <= highest)) {
            complain(what + " is " + std::to_string(value) + ", expected a number from " + std::to_string(lowest) +
                     " to " + std::to_string(highest));
        }
    }

    void color(const Color &value, float highest, const std::string &what) {
        for (int channel = 0; channel < 3; ++channel) number(value[channel], 0.0f, highest, what);
    }

    void material(const Material &m, const std::string &owner) {
        color(m.color, 1.0f, owner + ": colour");
        number(m.ambient, 0.0f, 1.0f, owner + ": ka");
        number(m.diffuse, 0.0f, 1.0f, owner + ": kd");
        number(m.specular, 0.0f, 1.0f, owner + ": ks");
        number(m.specular_exponent, 0.0f, max_intensity, owner + ": ke");
        number(m.reflection, 0.0f, 1.0f, owner + ": kr");
        number(m.transmission, 0.0f, 1.0f, owner + ": kt");
        // 0.8 + 0.2 is a rounding above 1 in some pairs; the weight of the local colour is clamped when shading.
        if (m.reflection + m.transmission > 1.0f + 1e-6f) {
            complain(owner + ": kr + kt is " + std::to_string(m.reflection + m.transmission) + ", expected at most 1");
        }
    }

    /// The mesh without triangles that have no area: the same mesh where there are none, nullptr where it is not valid.
    std::shared_ptr<const Mesh> mesh(const std::shared_ptr<const Mesh> &mesh, const std::string &owner) {
        if (!mesh) return complain(owner + ": has no mesh"), nullptr;
        if (const auto seen = checked_.find(mesh.get()); seen != checked_.end()) {
            skipped_ += seen->second.skipped;
            return seen->second.mesh;
        }
        return (checked_[mesh.get()] = check_mesh(mesh, owner)).mesh;
    }

    [[nodiscard]] uint64_t skipped_triangles() const { return skipped_; }
    [[nodiscard]] std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }
    [[nodiscard]] bool ok() const { return diagnostics_.empty(); }

private:
    struct CheckedMesh {
        std::shared_ptr<const Mesh> mesh;
        uint64_t skipped = 0;
    };

    CheckedMesh check_mesh(const std::shared_ptr<const Mesh> &mesh, const std::string &owner) {
        if (mesh->triangles.empty()) return complain(owner + ": its mesh has no triangles"), CheckedMesh{};
        for (const Point &p : mesh->positions) {
            for (int axis = 0; axis < 3; ++axis) {
                if (!(std::abs(p[axis]) <= max_coordinate)) {
                    return complain(owner + ": vertex " + std::to_string(&p - mesh->positions.data()) +
                                    " is not a finite place within 1e12 of the origin"),
                           CheckedMesh{};
                }
            }
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
        if (skipped == 0) return {mesh, 0};
        if (skipped == mesh->triangles.size()) {
            return complain(owner + ": none of its mesh's triangles has an area"), CheckedMesh{};
        }
        auto kept = std::make_shared<Mesh>(*mesh);
        std::erase_if(kept->triangles, [&](const Triangle &t) { return !has_area(*mesh, t); });
        skipped_ += skipped;
        return {std::move(kept), skipped};
    }

    std::unordered_map<const Mesh *, CheckedMesh> checked_;
    std::vector<Diagnostic> diagnostics_;
    uint64_t skipped_ = 0;
};

/// "object 3 'floor'": how a complaint names a surface.
std::string named(const char *kind, size_t index, const std::string &name) {
    std::string text = std::string(kind) + ' ' + std::to_string(index);
    if (!name.empty()) text += " '" + name + '\'';
    return text;
}

} // namespace

SceneBuilder &SceneBuilder::add_object(Object object) {
    return objects_.push_back(std::move(object)), *this;
}
SceneBuilder &SceneBuilder::add_light(MeshLight light) {
    return lights_.push_back(std::move(light)), *this;
}
SceneBuilder &SceneBuilder::set_camera(const Camera &camera) {
    return camera_ = camera, *this;
}
SceneBuilder &SceneBuilder::set_picture(const PictureSettings &picture) {
    return picture_ = picture, *this;
}
SceneBuilder &SceneBuilder::set_background(Color background) {
    return background_ = background, *this;
}
SceneBuilder &SceneBuilder::set_ambient(float ambient) {
    return ambient_ = ambient, *this;
}

Result<std::shared_ptr<const Scene>> SceneBuilder::build() {
    std::shared_ptr<Scene> scene(new Scene);
    scene->objects_ = std::move(objects_);
    scene->lights_ = std::move(lights_);
    scene->camera_ = camera_;
    scene->picture_ = picture_;
    scene->background_ = background_;
    scene->ambient_ = ambient_;
    *this = SceneBuilder(limits_);

    Checker check;
    uint64_t triangles = 0;
    if (scene->objects_.empty()) check.complain("the scene has no object");
    for (size_t i = 0; i < scene->objects_.size(); ++i) {
        Object &object = scene->objects_[i];
        const std::string owner = named("object", i, object.name);
        check.material(object.material, owner);
        object.mesh = check.mesh(object.mesh, owner);
        if (object.mesh) triangles += object.mesh->triangles.size();
    }
    for (size_t i = 0; i < scene->lights_.size(); ++i) {
        MeshLight &light = scene->lights_[i];
        const std::string owner = named("light", i, light.name);
        check.color(light.color, max_intensity, owner + ": colour");
        check.number(light.intensity, 0.0f, max_intensity, owner + ": intensity");
        light.mesh = check.mesh(light.mesh, owner);
        if (light.mesh) triangles += light.mesh->triangles.size();
    }
    check.color(scene->background_, max_intensity, "background");
    check.number(scene->ambient_, 0.0f, max_intensity, "ambient");
    if (const auto problem = camera_problem(scene->camera_)) check.complain(*problem);

    const PictureSettings &picture = scene->picture_;
    if (picture.width_px == 0 || picture.height_px == 0) {
        check.complain("the picture is " + std::to_string(picture.width_px) + " x " +
                       std::to_string(picture.height_px) + " pixels, expected at least 1 x 1");
    }
    if (!check.ok()) return Error(ErrorCode::bad_input, check.take_diagnostics());

    const auto limited = [&](uint64_t value, uint64_t limit, const char *what) {
        if (value > limit) {
            check.complain(std::string("the scene has ") + std::to_string(value) + ' ' + what + ", the limit is " +
                           std::to_string(limit));
        }
    };
    limited(uint64_t{picture.width_px} * picture.height_px, limits_.max_pixels, "pixels");
    limited(picture.max_depth, limits_.max_depth, "recursive rays in a row");
    limited(triangles, std::min(limits_.max_triangles, uint64_t{1} << 30), "triangles");
    if (!check.ok()) return Error(ErrorCode::limit_exceeded, check.take_diagnostics());

    for (const MeshLight &light : scene->lights_) {
        scene->light_centroids_.push_back(area_weighted_centroid(*light.mesh));
    }
    scene->triangle_count_ = static_cast<uint32_t>(triangles);
    scene->skipped_triangles_ = static_cast<uint32_t>(std::min<uint64_t>(check.skipped_triangles(), UINT32_MAX));
    return std::shared_ptr<const Scene>(std::move(scene));
}

} // namespace glint
