// What `glint inspect --json` prints for programs. `glint inspect --help` says what is in it.
#include "ray_tree_report.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const glm::vec3 &v) {
    return Json::array({v.x, v.y, v.z});
}

Json target_json(const TracedRay &ray) {
    const bool is_something = ray.target != RayTarget::background;
    return {{"kind", ray_target_name(ray.target)},
            {"index", is_something ? Json(ray.target_index) : Json(nullptr)},
            {"name", is_something ? Json(ray.target_name) : Json(nullptr)}};
}

Json to_json(const TracedRay &ray) {
    const bool is_shadow = ray.kind == RayKind::shadow;
    return {{"kind", ray_kind_name(ray.kind)},
            {"parent", ray.parent == no_ray ? Json(nullptr) : Json(ray.parent)},
            {"level", ray.level},
            {"sample", ray.sample},
            {"origin", to_json(ray.origin)},
            {"direction", to_json(ray.direction)},
            {"distance", std::isinf(ray.distance) ? Json(nullptr) : Json(ray.distance)},
            {"target", target_json(ray)},
            {"weight", ray.weight},
            {"local_weight", ray.local_weight},
            {"local_color", to_json(ray.local_color)},
            {"contribution", to_json(ray.contribution)},
            {"light", is_shadow ? Json(ray.light) : Json(nullptr)},
            {"light_name", is_shadow ? Json(ray.light_name) : Json(nullptr)},
            {"light_share", is_shadow ? Json(ray.light_share) : Json(nullptr)}};
}

} // namespace

std::string ray_tree_json(const std::string &scene, const RayTree &tree) {
    Json rays = Json::array();
    for (const TracedRay &ray : tree.rays) rays.push_back(to_json(ray));
    const Json report = {{"scene", scene},
                         {"width", tree.width_px},
                         {"height", tree.height_px},
                         {"x", tree.x},
                         {"y", tree.y},
                         {"depth", tree.max_depth},
                         {"samples_per_pixel", tree.samples},
                         {"color", to_json(tree.color)},
                         {"rgba8", tree.rgba8},
                         {"rays", std::move(rays)}};
    // A file name need not be UTF-8; JSON text must be.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace glint::cli
