// The sphereflake: a sphere carries nine spheres of a third its size, each of which carries nine, and so on.
//
// Source: Eric Haines, "A Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987, model "balls". Ours is tessellated, finer where a sphere is larger, and each generation has its own file so
// that it can have its own material.
#include <array>
#include <cmath>

#include "generate/models.hpp"
#include "generate/shapes.hpp"

namespace glint::scenes {
namespace {

/// Frequency of the geodesic sphere for each generation. Seen as in sphereflake.sdl, a triangle's edge is two or three
/// pixels in all of them.
constexpr std::array<uint32_t, 5> frequencies{48, 24, 10, 4, 2};

/// A sphere and where its children grow: `axis` points away from the parent, `side` is perpendicular to it.
struct Ball {
    Vec3 center;
    double radius;
    Vec3 axis;
    Vec3 side;
};

/// Directions of the nine children in a frame whose y is the ball's axis: six around the equator, three towards the
/// pole. They are nine of the twelve places where equal balls touch a ball in their midst.
std::array<Vec3, 9> child_directions() {
    const double half_root3 = std::sqrt(3.0) / 2.0;
    const double up = std::sqrt(2.0 / 3.0);
    const double out = std::sqrt(1.0 / 3.0);
    return {{{1.0, 0.0, 0.0},
             {0.5, 0.0, half_root3},
             {-0.5, 0.0, half_root3},
             {-1.0, 0.0, 0.0},
             {-0.5, 0.0, -half_root3},
             {0.5, 0.0, -half_root3},
             {out * half_root3, up, out * 0.5},
             {-out * half_root3, up, out * 0.5},
             {0.0, up, -out}}};
}

Ball child_of(const Ball &parent, Vec3 direction) {
    const Vec3 third = glm::cross(parent.side, parent.axis);
    const Vec3 axis = direction.x * parent.side + direction.y * parent.axis + direction.z * third;
    const double radius = parent.radius / 3.0;
    // The child's side lies in the plane of both axes, which no child direction makes parallel.
    const Vec3 towards_parent_axis = parent.axis - axis * glm::dot(axis, parent.axis);
    return {parent.center + axis * (parent.radius + radius), radius, axis,
            towards_parent_axis / glm::length(towards_parent_axis)};
}

} // namespace

std::vector<NamedMesh> sphereflake() {
    const Vec3 up{0.0, 1.0, 0.0};
    // Turned a little so that no child hides exactly behind another.
    std::vector<Ball> generation{{{0.0, 0.0, 0.0}, 1.0, up, {0.96, 0.0, 0.28}}};
    const auto directions = child_directions();

    std::vector<NamedMesh> files;
    for (size_t level = 0; level < frequencies.size(); ++level) {
        const Mesh sphere = geodesic_sphere(frequencies[level]);
        const std::string number = std::to_string(level);
        NamedMesh &file = files.emplace_back();
        file.file_name = "sphereflake_" + number + ".obj";
        file.comment = "Sphereflake, generation " + number + ": " + std::to_string(generation.size()) + " spheres.";
        for (const Ball &ball : generation) file.mesh.append(sphere, ball.radius, ball.center);

        std::vector<Ball> children;
        for (const Ball &ball : generation)
            for (const Vec3 direction : directions) children.push_back(child_of(ball, direction));
        generation = std::move(children);
    }
    return files;
}

} // namespace glint::scenes
