// Triangle meshes while they are being made, and the few ways to put them together.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace glint::scenes {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

/// Positions and triangles, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vec3> positions;
    std::vector<std::array<uint32_t, 3>> triangles;

    /// Returns the new vertex's index.
    uint32_t add_vertex(Vec3 position) {
        positions.push_back(position);
        return static_cast<uint32_t>(positions.size() - 1);
    }
    void add_triangle(uint32_t a, uint32_t b, uint32_t c) { triangles.push_back({a, b, c}); }
    /// Two triangles, cut from a to c.
    void add_quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        add_triangle(a, b, c);
        add_triangle(a, c, d);
    }
    /// A copy of `other`, scaled about the origin and then moved.
    void append(const Mesh &other, double scale = 1.0, Vec3 offset = {0.0, 0.0, 0.0}) {
        const auto first = static_cast<uint32_t>(positions.size());
        for (const Vec3 &position : other.positions) positions.push_back(position * scale + offset);
        for (const auto &[a, b, c] : other.triangles) add_triangle(first + a, first + b, first + c);
    }
};

/// A rotation about the vertical; from x towards -z, as a compass seen from above turns left.
struct Turn {
    double cosine = 1.0;
    double sine = 0.0;

    [[nodiscard]] Vec3 operator()(Vec3 p) const { return {p.x * cosine + p.z * sine, p.y, p.z * cosine - p.x * sine}; }
};

/// A rotation about the x axis that lifts what lies behind and shows the tops of things, as if the viewer looked down:
/// the camera of the 2013 dialect cannot be tilted, so the world is.
struct Tilt {
    double cosine = 1.0;
    double sine = 0.0;

    [[nodiscard]] Vec3 operator()(Vec3 p) const { return {p.x, p.y * cosine - p.z * sine, p.z * cosine + p.y * sine}; }
};

/// One OBJ file to be: its name without folder, the comment that opens it, and what it holds.
struct NamedMesh {
    std::string file_name;
    std::string comment;
    Mesh mesh;
};

/// Applies a Turn or a Tilt to every vertex of every mesh.
template <typename Rotation> void rotate_all(std::vector<NamedMesh> &files, Rotation rotation) {
    for (NamedMesh &file : files)
        for (Vec3 &position : file.mesh.positions) position = rotation(position);
}

} // namespace glint::scenes
