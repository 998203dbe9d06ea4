// Where a scene's things are.
#include "view/scene_bounds.hpp"

#include <unordered_set>

#include "scene/quadric_shape.hpp"

namespace glint {

Box bounds_of_objects(const Scene &scene) {
    Box bounds;
    std::unordered_set<const Mesh *> seen;
    for (const Object &object : scene.objects()) {
        if (object.quadric) {
            if (const QuadricShape shape = quadric_shape(*object.quadric); shape.is_bounded)
                bounds.extend(shape.bounds);
        }
        if (!object.mesh || !seen.insert(object.mesh.get()).second) continue;
        for (const Triangle &triangle : object.mesh->triangles) {
            for (const uint32_t corner : {triangle.a, triangle.b, triangle.c}) {
                bounds.extend(object.mesh->positions[corner]);
            }
        }
    }
    return bounds;
}

} // namespace glint
