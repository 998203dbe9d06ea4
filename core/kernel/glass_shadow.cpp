// Light through transmissive surfaces, where a scene asks for it.
#include "kernel/glass_shadow.hpp"

namespace glint {

Hit next_in_the_way(const KernelScene &scene, const LightShading &light, const PreparedRay &ray, const Hit &last,
                    float t_max, uint32_t left) {
    const auto can_block = [&](uint32_t id) { return id != left && id - light.first_triangle >= light.triangle_count; };
    const Hit hit = next_hit(scene.geometry, ray, last, t_max, can_block);
    return hit.t < t_max ? hit : Hit{t_max, no_triangle};
}

float share_through_glass(const KernelScene &scene, const LightShading &light, const Ray &ray, float t_max,
                          uint32_t left) {
    const PreparedRay prepared(ray, scene.geometry.bounds);
    float share = 1.0f;
    Hit last{0.0f, no_triangle};
    while (true) {
        // One hit after the other, so that the product is taken in the same order whatever structure finds them.
        const Hit hit = next_in_the_way(scene, light, prepared, last, t_max, left);
        if (hit.triangle_id == no_triangle) return share;
        share *= scene.surfaces[scene.geometry.surfaces[hit.triangle_id].surface].transmission;
        if (!(share > 0.0f)) return 0.0f;
        last = hit;
    }
}

} // namespace glint
