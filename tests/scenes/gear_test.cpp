// Gears that mesh touch, and do not cut into each other.
#include "generate/gear.hpp"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "generate/trig.hpp"

namespace glint::scenes {
namespace {

std::vector<Vec2> placed_outline(uint32_t teeth, double phase, Vec2 middle) {
    auto outline = gear_outline(teeth);
    const auto [cosine, sine] = cos_sin_turns(phase);
    for (Vec2 &p : outline) p = middle + Vec2{p.x * cosine - p.y * sine, p.x * sine + p.y * cosine};
    return outline;
}

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// Whether two stretches cross each other away from their ends.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

bool outlines_cross(const std::vector<Vec2> &one, const std::vector<Vec2> &other) {
    for (size_t i = 0; i < one.size(); ++i)
        for (size_t j = 0; j < other.size(); ++j)
            if (cross_each_other(one[i], one[(i + 1) % one.size()], other[j], other[(j + 1) % other.size()]))
                return true;
    return false;
}

TEST(Gear, meshes_with_another_without_cutting_into_it) {
    for (const auto &[teeth, other_teeth] : {std::pair{14u, 38u}, {20u, 56u}, {24u, 16u}, {18u, 46u}}) {
        const double distance = pitch_radius(teeth) + pitch_radius(other_teeth);
        for (const double direction : {0.0, 0.13, 0.4, 0.93}) {
            for (const double other_phase : {0.0, 0.011, 0.3}) {
                const auto [cosine, sine] = cos_sin_turns(direction);
                const double phase = meshing_phase(teeth, direction, other_teeth, other_phase);
                const auto other = placed_outline(other_teeth, other_phase, {0.0, 0.0});
                const Vec2 middle = distance * Vec2{cosine, sine};
                EXPECT_FALSE(outlines_cross(placed_outline(teeth, phase, middle), other))
                    << teeth << " on " << other_teeth << " in direction " << direction;
                // A tenth of a tooth further and they would collide: they do stand in each other's gaps.
                EXPECT_TRUE(outlines_cross(placed_outline(teeth, phase + 0.1 / teeth, middle), other));
            }
        }
    }
}

} // namespace
} // namespace glint::scenes
