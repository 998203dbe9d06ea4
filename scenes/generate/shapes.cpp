// Closed meshes that several models are put together from.
#include "generate/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "generate/trig.hpp"

namespace glint::scenes {

Mesh geodesic_sphere(uint32_t frequency) {
    // The icosahedron's corners are those of three golden rectangles.
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    const std::array<Vec3, 12> corners{{{-1, g, 0},
                                        {1, g, 0},
                                        {-1, -g, 0},
                                        {1, -g, 0},
                                        {0, -1, g},
                                        {0, 1, g},
                                        {0, -1, -g},
                                        {0, 1, -g},
                                        {g, 0, -1},
                                        {g, 0, 1},
                                        {-g, 0, -1},
                                        {-g, 0, 1}}};
    constexpr std::array<std::array<uint32_t, 3>, 20> faces{
        {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

    // A vertex is a blend of corners with whole weights. Faces that share it agree on which corners and weights (those
    // that are not zero), so that is what it is looked up by.
    using Share = std::pair<uint32_t, uint32_t>; // corner, weight
    std::map<std::array<Share, 3>, uint32_t> known;
    Mesh sphere;
    const auto vertex = [&](std::array<Share, 3> shares) {
        for (Share &share : shares)
            if (share.second == 0) share.first = 0;
        std::sort(shares.begin(), shares.end());
        const auto [place, is_new] = known.try_emplace(shares, static_cast<uint32_t>(sphere.positions.size()));
        if (is_new) {
            Vec3 sum{0.0};
            for (const auto &[corner, weight] : shares) sum += corners[corner] * double(weight);
            sphere.add_vertex(sum / glm::length(sum));
        }
        return place->second;
    };

    for (const auto &[a, b, c] : faces) {
        const auto at = [&, a = a, b = b, c = c](uint32_t i, uint32_t j) {
            return vertex({Share{a, frequency - i - j}, Share{b, i}, Share{c, j}});
        };
        for (uint32_t i = 0; i < frequency; ++i) {
            for (uint32_t j = 0; i + j < frequency; ++j) {
                // One after another: compilers may evaluate arguments in any order, and the first use numbers a vertex.
                const uint32_t here = at(i, j);
                const uint32_t next = at(i + 1, j);
                const uint32_t beside = at(i, j + 1);
                sphere.add_triangle(here, next, beside);
                if (i + j + 2 <= frequency) sphere.add_triangle(next, at(i + 1, j + 1), beside);
            }
        }
    }
    return sphere;
}

Mesh box(Vec3 low, Vec3 high) {
    Mesh mesh;
    // Vertex index bits: 1 = high x, 2 = high y, 4 = high z.
    for (uint32_t i = 0; i < 8; ++i)
        mesh.add_vertex({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    mesh.add_quad(0, 2, 3, 1); // back, low z
    mesh.add_quad(4, 5, 7, 6); // front
    mesh.add_quad(0, 4, 6, 2); // left
    mesh.add_quad(1, 3, 7, 5); // right
    mesh.add_quad(0, 1, 5, 4); // bottom
    mesh.add_quad(2, 6, 7, 3); // top
    return mesh;
}

Mesh lathe(const std::vector<Vec2> &profile, uint32_t segments) {
    Mesh mesh;
    const uint32_t bottom = mesh.add_vertex({0.0, profile.front().y, 0.0});
    const auto ring_count = static_cast<uint32_t>(profile.size() - 2);
    for (uint32_t ring = 1; ring <= ring_count; ++ring) {
        for (uint32_t s = 0; s < segments; ++s) {
            const auto [cosine, sine] = cos_sin_turns(double(s) / segments);
            mesh.add_vertex({profile[ring].x * cosine, profile[ring].y, -profile[ring].x * sine});
        }
    }
    const uint32_t top = mesh.add_vertex({0.0, profile.back().y, 0.0});

    const auto at = [&](uint32_t ring, uint32_t s) { return 1 + ring * segments + s % segments; };
    for (uint32_t s = 0; s < segments; ++s) {
        mesh.add_triangle(bottom, at(0, s + 1), at(0, s));
        for (uint32_t ring = 0; ring + 1 < ring_count; ++ring)
            mesh.add_quad(at(ring, s), at(ring, s + 1), at(ring + 1, s + 1), at(ring + 1, s));
        mesh.add_triangle(top, at(ring_count - 1, s), at(ring_count - 1, s + 1));
    }
    return mesh;
}

Mesh torus(double major, double minor, uint32_t major_segments, uint32_t minor_segments) {
    Mesh mesh;
    for (uint32_t i = 0; i < major_segments; ++i) {
        const auto [cos_i, sin_i] = cos_sin_turns(double(i) / major_segments);
        for (uint32_t j = 0; j < minor_segments; ++j) {
            const auto [cos_j, sin_j] = cos_sin_turns(double(j) / minor_segments);
            const double radius = major + minor * cos_j;
            mesh.add_vertex({radius * cos_i, minor * sin_j, -radius * sin_i});
        }
    }
    const auto at = [&](uint32_t i, uint32_t j) { return (i % major_segments) * minor_segments + j % minor_segments; };
    for (uint32_t i = 0; i < major_segments; ++i)
        for (uint32_t j = 0; j < minor_segments; ++j)
            mesh.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return mesh;
}

std::vector<Vec2> smooth_profile(const std::vector<Vec2> &points, uint32_t steps) {
    std::vector<Vec2> curve;
    const auto count = points.size();
    for (size_t i = 0; i + 1 < count; ++i) {
        const Vec2 before = points[i > 0 ? i - 1 : 0];
        const Vec2 from = points[i];
        const Vec2 to = points[i + 1];
        const Vec2 after = points[std::min(i + 2, count - 1)];
        for (uint32_t s = 0; s < steps; ++s) {
            const double t = double(s) / steps;
            Vec2 point = 0.5 * (2.0 * from + t * (to - before +
                                                  t * (2.0 * before - 5.0 * from + 4.0 * to - after +
                                                       t * (3.0 * (from - to) + after - before))));
            // Only the ends may lie on the axis.
            if (i > 0 || s > 0) point.x = std::max(point.x, 1e-3);
            curve.push_back(point);
        }
    }
    curve.push_back(points.back());
    return curve;
}

} // namespace glint::scenes
