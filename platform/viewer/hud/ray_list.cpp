// A pixel's rays as rows of a panel.
#include "viewer/hud/ray_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace glint::viewer {

namespace {

constexpr int head_rows = 3;

template <typename... Values> std::string format(const char *how, Values... values) {
    char text[96];
    const int length = std::snprintf(text, sizeof text, how, values...);
    return {text, static_cast<size_t>(std::clamp(length, 0, static_cast<int>(sizeof text) - 1))};
}

uint8_t to_byte(float channel) {
    return static_cast<uint8_t>(std::lround(255.0f * (channel > 0.0f ? std::min(channel, 1.0f) : 0.0f)));
}

Rgba opaque(const Color &color) {
    return {to_byte(color.r), to_byte(color.g), to_byte(color.b), 255};
}

/// The colour that comes along the ray: of a shadow ray, what its light adds.
Color arriving(const TracedRay &ray) {
    if (ray.kind == RayKind::shadow) return ray.local_color;
    return ray.weight > 0.0f ? ray.contribution * (1.0f / ray.weight) : Color(0.0f);
}

/// Names need not be unique.
std::string numbered(const std::string &name, uint32_t index) {
    return name + format(" (%u)", index);
}

std::string target_of(const TracedRay &ray) {
    return ray.target == RayTarget::background ? "background" : numbered(ray.target_name, ray.target_index);
}

std::string text_of(const RayTree &tree, const TracedRay &ray) {
    switch (ray.kind) {
    case RayKind::primary:
        return (tree.samples > 1 ? format("eye %u: ", ray.sample + 1) : std::string("eye: ")) + target_of(ray);
    case RayKind::mirror:
        return "mirrored: " + target_of(ray);
    case RayKind::transmitted:
        return "through: " + target_of(ray);
    case RayKind::shadow:
        break;
    }
    const std::string light = numbered(ray.light_name, ray.light);
    if (ray.light_share == 1.0f) return "light: " + light;
    const std::string share = ray.light_share > 0.0f ? format("%.0f%% of ", 100.0 * ray.light_share) : "no ";
    return share + light + ": " + target_of(ray);
}

Rgba color_of(const TracedRay &ray) {
    switch (ray.kind) {
    case RayKind::primary:
        return ink::bright;
    case RayKind::mirror:
        return {140, 200, 255, 255};
    case RayKind::transmitted:
        return {150, 230, 180, 255};
    case RayKind::shadow:
        break;
    }
    return ray.light_share > 0.0f ? Rgba{250, 214, 120, 255} : ink::dim;
}

std::string numbers_of(const TracedRay &ray) {
    const std::string weight = format("%5.1f%%", 100.0 * ray.weight);
    return weight + (std::isinf(ray.distance) ? std::string("       -") : format(" %7.4g", ray.distance));
}

void draw_row(const Panel &panel, int row, const RayTree &tree, const TracedRay &ray) {
    constexpr int swatch_columns = 2, text_column = 18, most_indent = 16;
    panel.swatch(row, 0, swatch_columns, opaque(arriving(ray)));
    panel.text(row, numbers_of(ray), ink::dim, swatch_columns + 1);
    const int indent = std::min(static_cast<int>(std::min(ray.level, 64u)) * 2, most_indent);
    panel.text(row, text_of(tree, ray), color_of(ray), text_column + indent);
}

} // namespace

int ray_list_rows(const RayTree &tree) {
    return head_rows + static_cast<int>(std::min<size_t>(tree.rays.size(), 10'000));
}

void draw_ray_list(const Panel &panel, const RayTree &tree, uint32_t first_ray) {
    const auto count = static_cast<int>(tree.rays.size());
    panel.ends(0, format("pixel %u,%u", tree.x, tree.y), ink::bright,
               format("%d ray%s, depth %u", count, count == 1 ? "" : "s", tree.max_depth), ink::dim);
    panel.swatch(1, 0, 2, {tree.rgba8[0], tree.rgba8[1], tree.rgba8[2], 255});
    panel.ends(1, "   " + format("%.4f %.4f %.4f", tree.color.r, tree.color.g, tree.color.b), ink::bright,
               format("%d %d %d", tree.rgba8[0], tree.rgba8[1], tree.rgba8[2]), ink::dim);

    const int room = panel.rows() - head_rows;
    if (room <= 0) return;
    // The last page is full.
    const int first =
        std::clamp(static_cast<int>(std::min<uint32_t>(first_ray, max_tree_rays)), 0, std::max(0, count - room));
    const bool has_more = count - first > room;
    const int shown = has_more ? room - 1 : count - first;
    for (int i = 0; i < shown; ++i) draw_row(panel, head_rows + i, tree, tree.rays[static_cast<size_t>(first + i)]);
    if (has_more) panel.text(panel.rows() - 1, format("%d more", count - first - shown), ink::dim, 3);
}

} // namespace glint::viewer
