// Scenes for C: what is in them, and moving it.
#include <glint/scene.h>

#include <glint/animation.hpp>
#include <glint/motion.hpp>

#include "c/scene_handle.hpp"
#include "c/sized.hpp"
#include "view/scene_bounds.hpp"

using namespace glint;

glint_error glint_scene::take(Result<std::shared_ptr<const Scene>> made) {
    if (!made) return fail_with(std::move(made).error());
    scene = std::move(made).value();
    return GLINT_OK;
}

glint_error glint_scene::fail_with(Error error) {
    const glint_error code = fail(error);
    diagnostics = std::move(error.diagnostics);
    return code;
}

void glint_scene_release(glint_scene *scene) {
    release(scene);
}

glint_error glint_scene_get_info(const glint_scene *handle, glint_scene_info *place) {
    if (!is_made(handle)) return GLINT_ERROR_INVALID_ARGUMENT;
    const Scene &scene = *handle->scene;
    glint_scene_info info = {};
    info.size = sizeof info;
    info.dialect = handle->dialect.c_str();
    info.dialect_reason = handle->dialect_reason.c_str();
    info.output_file = handle->output_file.c_str();
    info.objects = static_cast<uint32_t>(scene.objects().size());
    info.lights = static_cast<uint32_t>(scene.lights().size());
    info.triangles = scene.triangle_count();
    info.quadrics = static_cast<uint32_t>(scene.quadric_surfaces().size());
    info.skipped_triangles = scene.skipped_triangles();
    info.warnings = static_cast<uint32_t>(handle->diagnostics.size());
    const PictureSettings &picture = scene.picture();
    info.width_px = picture.width_px;
    info.height_px = picture.height_px;
    info.max_depth = picture.max_depth;
    info.samples_per_pixel = picture.samples_per_pixel;
    info.is_animated = scene.animation() != nullptr;
    return give(place, info);
}

glint_error glint_scene_get_bounds(const glint_scene *scene, float *lower, float *upper) {
    if (!is_made(scene) || !lower || !upper) return GLINT_ERROR_INVALID_ARGUMENT;
    try {
        const Box bounds = bounds_of_objects(*scene->scene);
        for (int i = 0; i < 3; ++i) lower[i] = bounds.lo[i], upper[i] = bounds.hi[i];
        return GLINT_OK;
    } catch (...) {
        return GLINT_ERROR_OUT_OF_MEMORY;
    }
}

glint_error glint_scene_get_diagnostic(const glint_scene *scene, uint32_t index, glint_diagnostic *place) {
    if (!is_handle(scene) || index >= scene->diagnostics.size()) return GLINT_ERROR_INVALID_ARGUMENT;
    const Diagnostic &from = scene->diagnostics[index];
    return give(place, glint_diagnostic{sizeof(glint_diagnostic), from.file.c_str(), from.message.c_str(),
                                        from.hint.c_str(), from.source_line.c_str(), from.line, from.column,
                                        from.severity == Diagnostic::Severity::error, 0});
}

glint_error glint_scene_get_object(const glint_scene *scene, uint32_t index, glint_object_info *place) {
    if (!is_made(scene) || index >= scene->scene->objects().size()) return GLINT_ERROR_INVALID_ARGUMENT;
    const Object &object = scene->scene->objects()[index];
    const auto triangles = object.mesh ? static_cast<uint32_t>(object.mesh->triangles.size()) : 0;
    return give(place, glint_object_info{sizeof(glint_object_info), object.name.c_str(), triangles,
                                         object.pose.has_value(), c_pose_of(object.pose.value_or(RigidTransform{}))});
}

glint_error glint_scene_get_camera(const glint_scene *scene, glint_camera *camera) {
    if (!is_made(scene) || !camera) return GLINT_ERROR_INVALID_ARGUMENT;
    *camera = c_camera_of(scene->scene->camera());
    return GLINT_OK;
}

glint_error glint_scene_move(const glint_scene *scene, const glint_object_pose *poses, size_t count,
                             glint_scene **moved) {
    return create(moved, [&](glint_scene &handle) -> glint_error {
        if (!is_made(scene)) return handle.refuse("there is no scene to move");
        if (!poses && count > 0) return handle.refuse("there are no poses");
        std::vector<ObjectPose> asked;
        asked.reserve(count);
        for (size_t i = 0; i < count; ++i) asked.push_back({poses[i].object, glint::pose_of(poses[i].pose)});
        return handle.take(with_poses(scene->scene, asked));
    });
}

glint_error glint_scene_at(const glint_scene *scene, double time_s, glint_scene **moved) {
    return create(moved, [&](glint_scene &handle) -> glint_error {
        if (!is_made(scene)) return handle.refuse("there is no scene to move");
        if (!std::isfinite(time_s)) return handle.refuse("the time is not finite");
        return handle.take(scene_at(scene->scene, time_s));
    });
}
