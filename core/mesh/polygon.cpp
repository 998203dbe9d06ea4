// Cutting a polygon into triangles.
#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

namespace glint {

namespace {

/// Area-weighted normal of a polygon (Newell's method).
glm::dvec3 newell_normal(std::span<const uint32_t> corners, const std::vector<Point> &positions) {
    const glm::dvec3 origin(positions[corners[0]]);
    glm::dvec3 normal(0.0);
    glm::dvec3 from(positions[corners.back()]);
    from -= origin;
    for (const uint32_t corner : corners) {
        glm::dvec3 to(positions[corner]);
        to -= origin;
        normal += glm::dvec3((from.y - to.y) * (from.z + to.z), (from.z - to.z) * (from.x + to.x),
                             (from.x - to.x) * (from.y + to.y));
        from = to;
    }
    return normal;
}

double squared_distance(const Point &a, const Point &b) {
    const glm::dvec3 delta = glm::dvec3(a) - glm::dvec3(b);
    return (delta.x * delta.x + delta.y * delta.y) + delta.z * delta.z;
}

} // namespace

void PolygonCutter::cut(std::span<const uint32_t> corners, const std::vector<Point> &positions, Triangle *out) {
    if (corners.size() == 3) {
        out[0] = {corners[0], corners[1], corners[2]};
        return;
    }
    flatten(corners, positions);
    if (corners.size() == 4) {
        cut_quad(corners, positions, out);
    } else if (turns_left_only()) {
        for (size_t i = 2; i < corners.size(); ++i) out[i - 2] = {corners[0], corners[i - 1], corners[i]};
    } else {
        clip_ears(corners, out);
    }
}

/// Drops the coordinate along which the polygon is thinnest; what is left are the file's own numbers, without rounding.
void PolygonCutter::flatten(std::span<const uint32_t> corners, const std::vector<Point> &positions) {
    const glm::dvec3 normal = newell_normal(corners, positions);
    const glm::dvec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const int thin = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    int u = (thin + 1) % 3, v = (thin + 2) % 3;
    if (normal[thin] < 0.0) std::swap(u, v);
    flat_.clear();
    for (const uint32_t corner : corners) flat_.emplace_back(positions[corner][u], positions[corner][v]);
}

/// Then the polygon is convex, or winds around several times and crosses itself, where one cut is as good as another.
bool PolygonCutter::turns_left_only() const {
    const size_t count = flat_.size();
    for (size_t i = 0; i < count; ++i) {
        if (!(turn(flat_[i], flat_[(i + 1) % count], flat_[(i + 2) % count]) > 0.0)) return false;
    }
    return true;
}

/// Cuts along a diagonal that lies inside; along the shorter one where both do.
void PolygonCutter::cut_quad(std::span<const uint32_t> corners, const std::vector<Point> &positions,
                             Triangle *out) const {
    const auto both_turn_left = [&](size_t a, size_t b, size_t c, size_t d) {
        return turn(flat_[a], flat_[b], flat_[c]) > 0.0 && turn(flat_[a], flat_[c], flat_[d]) > 0.0;
    };
    const bool inside_02 = both_turn_left(0, 1, 2, 3), inside_13 = both_turn_left(1, 2, 3, 0);
    const bool shorter_02 = squared_distance(positions[corners[0]], positions[corners[2]]) <=
                            squared_distance(positions[corners[1]], positions[corners[3]]);
    if (inside_02 == inside_13 ? shorter_02 : inside_02) {
        out[0] = {corners[0], corners[1], corners[2]};
        out[1] = {corners[0], corners[2], corners[3]};
    } else {
        out[0] = {corners[0], corners[1], corners[3]};
        out[1] = {corners[1], corners[2], corners[3]};
    }
}

void PolygonCutter::clip_ears(std::span<const uint32_t> corners, Triangle *out) {
    const auto count = static_cast<uint32_t>(corners.size());
    previous_.resize(count);
    next_.resize(count);
    reflex_.resize(count);
    clipped_.assign(count, 0);
    for (uint32_t i = 0; i < count; ++i) {
        previous_[i] = i > 0 ? i - 1 : count - 1;
        next_[i] = i + 1 < count ? i + 1 : 0;
    }
    for (uint32_t i = 0; i < count; ++i) reflex_[i] = is_reflex_or_flat(i);
    reflex_corners_.build(flat_, reflex_);

    cuts_.clear();
    for (uint32_t i = 0; i < count; ++i) consider(i);

    uint32_t left = count, somewhere = 0;
    while (left > 3) {
        uint32_t tip = somewhere;
        if (!cuts_.empty()) {
            std::pop_heap(cuts_.begin(), cuts_.end());
            const Cut cut = cuts_.back();
            cuts_.pop_back();
            tip = cut.tip;
            const bool is_outdated = clipped_[tip] || previous_[tip] != cut.a || next_[tip] != cut.c;
            if (is_outdated || !is_ear(tip)) continue;
        } // else no ear is left: the polygon crosses itself or is a line. Cut anything; its neighbours may be ears
          // then.
        *out++ = {corners[previous_[tip]], corners[tip], corners[next_[tip]]};
        somewhere = next_[tip];
        clip(tip);
        --left;
    }
    *out = {corners[previous_[somewhere]], corners[somewhere], corners[next_[somewhere]]};
}

/// A tip without area is no ear: cutting it would take a corner away from the edge that a neighbouring face shares.
void PolygonCutter::consider(uint32_t tip) {
    if (is_reflex_or_flat(tip)) return;
    const uint32_t a = previous_[tip], c = next_[tip];
    const glm::dvec2 cut = flat_[c] - flat_[a];
    cuts_.push_back({cut.x * cut.x + cut.y * cut.y, a, tip, c});
    std::push_heap(cuts_.begin(), cuts_.end());
}

void PolygonCutter::clip(uint32_t tip) {
    const uint32_t a = previous_[tip], c = next_[tip];
    next_[a] = c;
    previous_[c] = a;
    clipped_[tip] = 1;
    if (reflex_[tip]) reflex_corners_.remove(tip);
    for (const uint32_t neighbour : {a, c}) {
        // A cut can only make a reflex corner convex. (Cutting what is no ear may do the reverse; then all is lost
        // anyway.)
        if (reflex_[neighbour] && !is_reflex_or_flat(neighbour)) {
            reflex_[neighbour] = 0;
            reflex_corners_.remove(neighbour);
        }
        consider(neighbour);
    }
}

bool PolygonCutter::is_reflex_or_flat(uint32_t corner) const {
    return !(turn(flat_[previous_[corner]], flat_[corner], flat_[next_[corner]]) > 0.0);
}

bool PolygonCutter::is_ear(uint32_t tip) const {
    const uint32_t a = previous_[tip], c = next_[tip];
    return !reflex_corners_.any_near(flat_[a], flat_[tip], flat_[c],
                                     [&](uint32_t corner) { return blocks(corner, a, tip, c); });
}

/// Whether a reflex corner stops the triangle a, b, c (b the tip) from being cut off.
bool PolygonCutter::blocks(uint32_t corner, uint32_t a, uint32_t b, uint32_t c) const {
    if (clipped_[corner] || !reflex_[corner] || corner == a || corner == b || corner == c) return false;
    const glm::dvec2 &p = flat_[corner];
    if (turn(flat_[a], flat_[b], p) < 0.0 || turn(flat_[b], flat_[c], p) < 0.0 || turn(flat_[c], flat_[a], p) < 0.0) {
        return false;
    }
    // Holes are often written as a cut from the outline to the hole and back, so two corners may share one place. A
    // twin of the triangle's own corner does not block: an edge that went from it into the triangle would have to end
    // in there, at another reflex corner.
    return p != flat_[a] && p != flat_[b] && p != flat_[c];
}

} // namespace glint
