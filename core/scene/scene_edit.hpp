// Changing a copy of a finished scene: the one way past the builder, for what can be changed without another look at
// the rest.
#pragma once

#include <memory>

#include <glint/scene.hpp>

namespace glint {

/// A copy of a scene, which shares its meshes, in the making.
class SceneEdit {
public:
    explicit SceneEdit(const Scene &scene);

    [[nodiscard]] Object &object(size_t i) { return scene_->objects_[i]; }
    [[nodiscard]] Camera &camera() { return scene_->camera_; }
    [[nodiscard]] std::shared_ptr<const Scene> take() { return std::move(scene_); }

private:
    std::shared_ptr<Scene> scene_;
};

} // namespace glint
