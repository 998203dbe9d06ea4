// Moving the objects of a finished scene.
#include <glint/motion.hpp>

#include <new>

#include "scene/rigid_check.hpp"
#include "scene/scene_check.hpp"
#include "scene/scene_edit.hpp"

namespace glint {

SceneEdit::SceneEdit(const Scene &scene) : scene_(new Scene(scene)) {}

Result<std::shared_ptr<const Scene>> with_poses(const std::shared_ptr<const Scene> &scene,
                                                std::span<const ObjectPose> poses) try {
    SceneEdit edit(*scene);
    SceneChecker check;
    const size_t count = scene->objects().size();
    for (const ObjectPose &to : poses) {
        if (to.object >= count) {
            check.complain("there is no object " + std::to_string(to.object) + " among " + std::to_string(count));
            continue;
        }
        Object &object = edit.object(to.object);
        const auto complain = [&](const std::string &why) {
            check.complain(surface_name("object", to.object, object.name) + ": " + why);
        };
        if (!object.pose) {
            complain("does not move: it was built without a pose");
            continue;
        }
        *object.pose = to.pose;
        if (const auto problem = straighten(*object.pose)) complain(*problem);
    }
    if (!check.ok()) return Error(ErrorCode::bad_input, check.take_diagnostics());
    return edit.take();
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

} // namespace glint
