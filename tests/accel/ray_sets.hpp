// Rays that look for trouble with a mesh: through its vertices and edges, in its planes, from far away.
#pragma once

#include <string>
#include <vector>

#include <glint/scene.hpp>

#include "kernel/prepared_ray.hpp"
#include "support/random.hpp"

namespace glint::test {

/// The ray with this number of the endless set that belongs to a mesh. Kinds take turns.
class RaySet {
public:
    explicit RaySet(const Mesh &mesh) : mesh_(mesh) {
        for (const Point &p : mesh.positions) bounds_.extend(p);
        center_ = (bounds_.lo + bounds_.hi) * 0.5f;
        reach_ = max_abs(bounds_.hi - bounds_.lo);
    }

    [[nodiscard]] Ray ray(uint32_t number) const {
        Random random(number);
        const Triangle &triangle = mesh_.triangles[random.below(static_cast<uint32_t>(mesh_.triangles.size()))];
        const Point a = mesh_.positions[triangle.a], b = mesh_.positions[triangle.b], c = mesh_.positions[triangle.c];
        const Point near = center_ + random.in_box(Point(-reach_), Point(reach_));
        switch (number % 10) {
        case 0:
            return {near, random.direction()};
        case 1:
            return towards(near, a);
        case 2:
            return towards(near, (a + b) * 0.5f);
        case 3:
            return towards(near, a + (b - a) * random.uniform(0.0f, 1.0f));
        case 4:
            return towards(near, (a + b + c) / 3.0f);
        case 5:
            return axis_parallel(random, near);
        case 6:
            return axis_parallel(random, random.below(2) ? a : (b + c) * 0.5f); // in planes of axis-parallel faces
        case 7:
            return towards(a, random.below(2) ? b : c); // along edges, in the faces' planes
        case 8:
            return towards(center_ + 1e6f * reach_ * random.direction(), a + (b - a) * random.uniform(0.0f, 1.0f));
        default: { // grazing: in the triangle's plane but for a millionth
            const Point target = a + (b - a) * random.uniform(0.0f, 1.0f);
            const Vector along = (c - a) * random.uniform(-1.0f, 1.0f) + (b - a) * random.uniform(-1.0f, 1.0f);
            return towards(target - along * 3.0f + random.direction() * (1e-6f * reach_), target);
        }
        }
    }

private:
    static Ray towards(const Point &from, const Point &to) {
        const Vector delta = to - from;
        const float length = std::sqrt(dot(delta, delta));
        return {from, length > 0.0f ? delta / length : Vector(0.0f, 0.0f, 1.0f)};
    }

    Ray axis_parallel(Random &random, Point through) const {
        const auto axis = static_cast<int>(random.below(3));
        Vector dir(0.0f);
        dir[axis] = random.below(2) ? 1.0f : -1.0f;
        if (random.below(2)) dir[(axis + 1) % 3] = -0.0f;
        through[axis] -= dir[axis] * 2.0f * reach_;
        return {through, dir};
    }

    const Mesh &mesh_;
    Box bounds_;
    Point center_;
    float reach_;
};

} // namespace glint::test
