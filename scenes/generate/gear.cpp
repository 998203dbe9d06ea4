// One toothed wheel: an involute gear with hub, web and rim, its web solid or cut into spokes.
//
// Flanks are involutes of the base circle at a pressure angle of 20 degrees, as gears have been cut for a century: two
// that touch roll on each other.
#include "generate/gear.hpp"

#include <algorithm>
#include <cmath>

#include "generate/trig.hpp"

namespace glint::scenes {
namespace {

constexpr double cos_pressure = 0.93969262078590838;      ///< of 20 degrees
constexpr double involute_of_pressure = 0.01490438386734; ///< tan(20 degrees) - 20 degrees in radians
constexpr uint32_t flank_steps = 5;

Vec2 rotated(Vec2 p, double angle_rad) {
    const auto [cosine, sine] = cos_sin_turns(angle_rad / (2.0 * pi));
    return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine};
}

double tip_radius(uint32_t teeth) {
    return pitch_radius(teeth) + gear_module;
}
double root_radius(uint32_t teeth) {
    return pitch_radius(teeth) - 1.25 * gear_module;
}

/// A ring of vertices around the gear, one to each point of the outline.
struct Ring {
    double radius; ///< of a circle, or 0: the ring follows the teeth
    double inset;  ///< by which fraction it is smaller than the teeth
    double y;
};

// The rings between which openings are cut into the web, by their place in the cross-section.
constexpr uint32_t window_outer = 4;
constexpr uint32_t window_inner = 5;

/// The rings from the teeth over the gear's top to the bore, and back along its underside; the last meets the first.
std::vector<Ring> cross_section(const Gear &gear) {
    const double root = root_radius(gear.teeth);
    const double rim = root - 1.3 * gear_module;
    const double hub = gear.bore_radius + std::max(1.2 * gear_module, 0.12 * root);
    const double bevel = 0.2 * gear_module;
    const double half = gear.thickness / 2.0;
    const double web = 0.45 * half;
    const double hub_half = 1.25 * half;
    std::vector<Ring> rings{{0.0, 0.0, half - bevel},
                            {0.0, bevel / tip_radius(gear.teeth), half},
                            {rim, 0.0, half},
                            {rim - bevel, 0.0, web},
                            {hub + 0.82 * (rim - hub), 0.0, web},
                            {hub + 0.18 * (rim - hub), 0.0, web},
                            {hub + bevel, 0.0, web},
                            {hub, 0.0, hub_half - bevel},
                            {hub - bevel, 0.0, hub_half},
                            {gear.bore_radius, 0.0, hub_half}};
    for (size_t i = rings.size(); i-- > 0;) rings.push_back({rings[i].radius, rings[i].inset, -rings[i].y});
    return rings;
}

/// Whether step j of the `around` steps around the gear lies in an opening rather than in a spoke.
bool is_open(const Gear &gear, uint32_t around, uint32_t j) {
    if (gear.windows == 0) return false;
    const uint32_t span = around / gear.windows;
    const uint32_t spoke = std::max(span / 5, 2u);
    const uint32_t in_span = j % span;
    // What the division leaves over widens the last spoke.
    return j < span * gear.windows && in_span >= spoke / 2 && in_span < span - (spoke + 1) / 2;
}

} // namespace

double pitch_radius(uint32_t teeth) {
    return gear_module * teeth / 2.0;
}

std::vector<Vec2> gear_outline(uint32_t teeth) {
    const double base = pitch_radius(teeth) * cos_pressure;
    const double root = root_radius(teeth);
    // Half the angle that a tooth spans at its base circle, less a little play.
    const double half_base = (pi / 2.0 - 0.04) / teeth + involute_of_pressure;
    std::vector<Vec2> rising; // from the root to the tip, below the x axis
    const double start = std::max(base, root);
    for (uint32_t s = 0; s <= flank_steps; ++s) {
        const double radius = start + (tip_radius(teeth) - start) * s / flank_steps;
        const double ratio = std::max(radius / base, 1.0);
        const double unrolled = std::sqrt(ratio * ratio - 1.0); // radians of thread off the base circle
        rising.push_back(rotated(rotated(Vec2{base, -base * unrolled}, unrolled), -half_base));
    }
    // Below the base circle the flank runs out into the gap, where a cutter leaves a fillet.
    const double half_gap = pi / teeth - half_base;
    if (root < base) rising.insert(rising.begin(), rotated(rising.front() * (root / base), -0.3 * half_gap));

    std::vector<Vec2> outline;
    for (uint32_t tooth = 0; tooth < teeth; ++tooth) {
        const double angle = 2.0 * pi * tooth / teeth;
        for (const Vec2 p : rising) outline.push_back(rotated(p, angle));
        outline.push_back(rotated({tip_radius(teeth), 0.0}, angle));
        for (auto p = rising.rbegin(); p != rising.rend(); ++p) outline.push_back(rotated({p->x, -p->y}, angle));
        outline.push_back(rotated({root, 0.0}, angle + pi / teeth));
    }
    return outline;
}

double meshing_phase(uint32_t teeth, double direction, uint32_t other_teeth, double other_phase) {
    // Where they touch, a tooth of one meets a gap of the other: their positions within a tooth add up to a half.
    const double in_other_tooth = (direction - other_phase) * other_teeth;
    return direction + 0.5 - (0.5 - in_other_tooth) / teeth;
}

Mesh gear_mesh(const Gear &gear) {
    // The surface is the product of two loops, the outline and the cross-section: a torus of rings.
    const std::vector<Vec2> outline = gear_outline(gear.teeth);
    const std::vector<Ring> rings = cross_section(gear);
    const auto around = static_cast<uint32_t>(outline.size());
    const auto ring_count = static_cast<uint32_t>(rings.size());
    Mesh mesh;
    for (const Ring &ring : rings) {
        for (const Vec2 p : outline) {
            const Vec2 q = ring.radius > 0.0 ? p * (ring.radius / glm::length(p)) : p * (1.0 - ring.inset);
            mesh.add_vertex({q.x, ring.y, -q.y});
        }
    }
    const auto at = [&](uint32_t ring, uint32_t j) { return ring % ring_count * around + j % around; };
    const auto below = [&](uint32_t ring) { return ring_count - 1 - ring; };
    const auto open = [&](uint32_t j) { return is_open(gear, around, j % around); };

    for (uint32_t ring = 0; ring < ring_count; ++ring) {
        const bool has_windows = ring == window_outer || ring == below(window_inner);
        for (uint32_t j = 0; j < around; ++j) {
            if (has_windows && open(j)) continue;
            mesh.add_quad(at(ring, j), at(ring, j + 1), at(ring + 1, j + 1), at(ring + 1, j));
        }
    }

    // The openings' walls: along the rim, along the hub, and beside the spokes.
    constexpr uint32_t o = window_outer, i = window_inner;
    for (uint32_t j = 0; j < around; ++j) {
        if (!open(j)) continue;
        mesh.add_quad(at(o, j), at(o, j + 1), at(below(o), j + 1), at(below(o), j));
        mesh.add_quad(at(i, j + 1), at(i, j), at(below(i), j), at(below(i), j + 1));
        if (!open(j + around - 1)) mesh.add_quad(at(i, j), at(o, j), at(below(o), j), at(below(i), j));
        if (!open(j + 1)) mesh.add_quad(at(o, j + 1), at(i, j + 1), at(below(i), j + 1), at(below(o), j + 1));
    }
    return mesh;
}

} // namespace glint::scenes
