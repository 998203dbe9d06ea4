// What `glint inspect` prints for people.
#include "ray_tree_report.hpp"

#include <cmath>

#include <fmt/format.h>

namespace glint::cli {
namespace {

std::string plural(size_t count, const char *what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "cube1.obj (3)": names need not be unique.
std::string numbered(const std::string &name, uint32_t index) {
    return fmt::format("{} ({})", name, index);
}

std::string target_text(const TracedRay &ray) {
    if (ray.target == RayTarget::background) return "background";
    return (ray.target == RayTarget::light ? "light " : "") + numbered(ray.target_name, ray.target_index);
}

/// What the ray is and where it ends.
std::string ray_text(const RayTree &tree, const TracedRay &ray) {
    if (ray.kind == RayKind::shadow) {
        const std::string light = "light from " + numbered(ray.light_name, ray.light);
        if (ray.light_share == 1.0f) return light;
        if (ray.light_share > 0.0f)
            return fmt::format("{:.3g} of {} through {}", ray.light_share, light, target_text(ray));
        return fmt::format("no {}: {} is in the way", light, target_text(ray));
    }
    const std::string which =
        ray.kind == RayKind::primary && tree.samples > 1 ? fmt::format(" of sample {}", ray.sample + 1) : "";
    return fmt::format("{}{} to {}", ray_kind_name(ray.kind), which, target_text(ray));
}

std::string line_of(const RayTree &tree, const TracedRay &ray) {
    const std::string own = ray.kind == RayKind::shadow ? std::string() : fmt::format("{:.5f}", ray.local_weight);
    const std::string distance = std::isinf(ray.distance) ? std::string("-") : fmt::format("{:.5g}", ray.distance);
    const Color &c = ray.local_color;
    return fmt::format("{:7.5f} {:>7} {:8.5f} {:8.5f} {:8.5f} {:>9}  {:{}}{}\n", ray.weight, own, c.r, c.g, c.b,
                       distance, "", 2 * ray.level, ray_text(tree, ray));
}

} // namespace

std::string ray_tree_text(const std::string &scene, const RayTree &tree) {
    size_t counts[4] = {};
    for (const TracedRay &ray : tree.rays) ++counts[static_cast<int>(ray.kind)];
    std::string text = fmt::format("{}: pixel {},{} of {}x{}, depth {}, {}\n", scene, tree.x, tree.y, tree.width_px,
                                   tree.height_px, tree.max_depth, plural(tree.samples, "sample"));
    text += fmt::format("colour {:.5f} {:.5f} {:.5f}, bytes {} {} {}\n", tree.color.r, tree.color.g, tree.color.b,
                        tree.rgba8[0], tree.rgba8[1], tree.rgba8[2]);
    text += fmt::format("{}: {} primary, {} mirror, {} transmitted, {} shadow\n\n", plural(tree.rays.size(), "ray"),
                        counts[0], counts[1], counts[2], counts[3]);
    text += " weight     own      red    green     blue  distance  ray\n";
    for (const TracedRay &ray : tree.rays) text += line_of(tree, ray);
    return text;
}

} // namespace glint::cli
