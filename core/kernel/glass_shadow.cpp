// Light through transmissive surfaces, where a scene asks for it.
#include "kernel/glass_shadow.hpp"

namespace glint {

float share_through_glass(const KernelScene &scene, const LightShading &light, const Ray &ray, float t_max,
                          uint32_t left, InTheWay *in_the_way) {
    const PreparedRay prepared(ray, scene.geometry.bounds);
    const auto can_block = [&](uint32_t id) { return id != left && id - light.first_triangle >= light.triangle_count; };
    float share = 1.0f;
    Hit last{0.0f, no_triangle};
    while (true) {
        // One hit after the other, so that the product is taken in the same order whatever structure finds them.
        const Hit hit = next_hit(scene.geometry, prepared, last, t_max, can_block);
        if (hit.triangle_id == no_triangle || !(hit.t < t_max)) return share;
        share *= scene.surfaces[scene.geometry.surfaces[hit.triangle_id].surface].transmission;
        if (in_the_way) {
            if (last.triangle_id == no_triangle) in_the_way->first = hit;
            in_the_way->last = hit;
        } else if (!(share > 0.0f)) {
            return 0.0f;
        }
        last = hit;
    }
}

} // namespace glint
