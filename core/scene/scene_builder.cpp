// The last wall: whatever becomes a Scene has been checked here.
#include <glint/scene.hpp>

#include <algorithm>
#include <new>

#include "scene/animation_check.hpp"
#include "scene/camera_check.hpp"
#include "scene/quadric_shape.hpp"
#include "scene/scene_check.hpp"
#include "scene/triangle_area.hpp"

namespace glint {

namespace {

/// Where a single shadow ray to the light aims.
Point position_of(const Light &light) {
    if (light.position) return *light.position;
    if (light.mesh) return area_weighted_centroid(*light.mesh);
    return light.quadric ? quadric_shape(*light.quadric).centre : Point(0.0f);
}

} // namespace

SceneBuilder &SceneBuilder::add_object(Object object) {
    return objects_.push_back(std::move(object)), *this;
}
SceneBuilder &SceneBuilder::add_light(Light light) {
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
SceneBuilder &SceneBuilder::set_optics(const OpticsSettings &optics) {
    return optics_ = optics, *this;
}
SceneBuilder &SceneBuilder::set_animation(std::shared_ptr<const Animation> animation) {
    return animation_ = std::move(animation), *this;
}

Result<std::shared_ptr<const Scene>> SceneBuilder::build() try {
    std::shared_ptr<Scene> scene(new Scene);
    scene->objects_ = std::move(objects_);
    scene->lights_ = std::move(lights_);
    scene->camera_ = camera_;
    scene->picture_ = picture_;
    scene->background_ = background_;
    scene->ambient_ = ambient_;
    scene->optics_ = optics_;
    scene->animation_ = std::move(animation_);
    *this = SceneBuilder(limits_);

    SceneChecker check;
    if (scene->objects_.empty()) check.complain("the scene has no object");
    for (size_t i = 0; i < scene->objects_.size(); ++i) {
        check.object(scene->objects_[i], surface_name("object", i, scene->objects_[i].name));
    }
    for (size_t i = 0; i < scene->lights_.size(); ++i) {
        check.light(scene->lights_[i], surface_name("light", i, scene->lights_[i].name));
    }
    check.color(scene->background_, max_intensity, "background");
    check.number(scene->ambient_, 0.0f, max_intensity, "ambient");
    if (const auto problem = camera_problem(scene->camera_)) check.complain(*problem);
    if (scene->animation_) check_animation(*scene->animation_, scene->objects_, check);
    const PictureSettings &picture = scene->picture_;
    check.picture(picture);
    if (!check.ok()) return Error(ErrorCode::bad_input, check.take_diagnostics());

    const auto limited = [&](uint64_t value, uint64_t limit, const char *what) {
        if (value > limit) {
            check.complain(std::string("the scene has ") + std::to_string(value) + ' ' + what + ", the limit is " +
                           std::to_string(limit));
        }
    };
    uint64_t triangles = 0;
    for (uint32_t s = 0; s < scene->surface_count(); ++s) {
        if (const Mesh *mesh = scene->surface_mesh(s)) triangles += mesh->triangles.size();
        if (scene->surface_quadric(s)) scene->quadric_surfaces_.push_back(s);
    }
    limited(uint64_t{picture.width_px} * picture.height_px, limits_.max_pixels, "pixels");
    limited(picture.max_depth, limits_.max_depth, "recursive rays in a row");
    limited(triangles, std::min(limits_.max_triangles, uint64_t{1} << 30), "triangles");
    limited(scene->quadric_surfaces_.size(), limits_.max_triangles, "quadrics");
    if (!check.ok()) return Error(ErrorCode::limit_exceeded, check.take_diagnostics());

    for (const Light &light : scene->lights_) scene->light_positions_.push_back(position_of(light));
    scene->origin_ = std::make_shared<char>();
    scene->triangle_count_ = static_cast<uint32_t>(triangles);
    scene->skipped_triangles_ = static_cast<uint32_t>(std::min<uint64_t>(check.skipped_triangles(), UINT32_MAX));
    return std::shared_ptr<const Scene>(std::move(scene));
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

} // namespace glint
