// A hall of mirrors: four mirror walls, columns in the corners that the mirrors complete, and a few things to reflect.
#include <algorithm>

#include "generate/models.hpp"
#include "generate/shapes.hpp"

namespace glint::scenes {
namespace {

constexpr double half_width = 5.0; ///< along x, before the hall is turned
constexpr double half_length = 7.0;
constexpr double room_height = 5.0;
/// The hall stands askew to the picture so that both directions run away to the side (8-15-17: 28 degrees).
constexpr Turn hall_turn{15.0 / 17.0, 8.0 / 17.0};

Mesh mirror_walls() {
    constexpr double thickness = 0.1;
    const double x = half_width, z = half_length;
    Mesh mesh;
    mesh.append(box({-x - thickness, 0.0, -z}, {-x, room_height, z}));
    mesh.append(box({x, 0.0, -z}, {x + thickness, room_height, z}));
    mesh.append(box({-x, 0.0, -z - thickness}, {x, room_height, -z}));
    mesh.append(box({-x, 0.0, z}, {x, room_height, z + thickness}));
    return mesh;
}

/// Every other tile of a chequered floor whose top is y = 0; `odd` says which ones.
Mesh tiles(bool odd) {
    constexpr double half_joint = 0.01;
    Mesh mesh;
    for (int column = 0; column < static_cast<int>(2 * half_width); ++column) {
        for (int row = 0; row < static_cast<int>(2 * half_length); ++row) {
            if (((column + row) % 2 != 0) != odd) continue;
            const double x = column - half_width, z = row - half_length;
            mesh.append(box({x + half_joint, -0.1, z + half_joint}, {x + 1.0 - half_joint, 0.0, z + 1.0 - half_joint}));
        }
    }
    return mesh;
}

/// Ceiling, and the bed that the tiles lie in.
Mesh slabs() {
    const double x = half_width + 0.5, z = half_length + 0.5;
    Mesh mesh = box({-x, room_height, -z}, {x, room_height + 0.2, z});
    mesh.append(box({-x, -0.3, -z}, {x, -0.02, z}));
    return mesh;
}

Mesh columns() {
    const Mesh column = lathe(smooth_profile({{0.0, 0.0},
                                              {0.62, 0.0},
                                              {0.62, 0.25},
                                              {0.5, 0.3},
                                              {0.5, 0.42},
                                              {0.36, 0.55},
                                              {0.34, 2.5},
                                              {0.31, 4.3},
                                              {0.4, 4.45},
                                              {0.4, 4.55},
                                              {0.6, 4.75},
                                              {0.62, room_height},
                                              {0.0, room_height}},
                                             6),
                              64);
    Mesh mesh;
    for (const double x : {-half_width, half_width})
        for (const double z : {-half_length, half_length}) mesh.append(column, 1.0, {x, 0.0, z});
    return mesh;
}

} // namespace

std::vector<NamedMesh> mirrors() {
    const Mesh ball = geodesic_sphere(48);
    const Mesh pedestal = lathe(
        {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.12}, {0.36, 0.2}, {0.32, 0.9}, {0.45, 1.0}, {0.45, 1.1}, {0.0, 1.1}}, 64);
    Mesh pedestals;
    pedestals.append(pedestal, 1.0, {-1.5, 0.0, -2.0});
    pedestals.append(pedestal, 1.0, {2.2, 0.0, -3.5});
    Mesh gold, red, blue;
    gold.append(ball, 0.6, {-1.5, 1.7, -2.0});
    red.append(ball, 0.7, {0.8, 0.7, -0.6});
    red.append(ball, 0.35, {-2.6, 0.35, -0.4});
    blue.append(torus(0.55, 0.2, 96, 48), 1.0, {2.2, 1.3, -3.5});
    Mesh lamp, sconce;
    lamp.append(geodesic_sphere(8), 0.3, {0.0, 4.2, -1.0});
    sconce.append(geodesic_sphere(8), 0.15, {-4.3, 3.0, 3.0});

    std::vector<NamedMesh> files{
        {"mirrors_walls.obj", "Hall of mirrors: the four mirrors.", mirror_walls()},
        {"mirrors_tiles_light.obj", "Hall of mirrors: the floor's light tiles.", tiles(false)},
        {"mirrors_tiles_dark.obj", "Hall of mirrors: the floor's dark tiles.", tiles(true)},
        {"mirrors_slabs.obj", "Hall of mirrors: the ceiling and the bed of the tiles.", slabs()},
        {"mirrors_columns.obj", "Hall of mirrors: the columns in the corners.", columns()},
        {"mirrors_pedestals.obj", "Hall of mirrors: two pedestals.", std::move(pedestals)},
        {"mirrors_gold.obj", "Hall of mirrors: the gold ball.", std::move(gold)},
        {"mirrors_red.obj", "Hall of mirrors: the red balls.", std::move(red)},
        {"mirrors_blue.obj", "Hall of mirrors: the blue ring.", std::move(blue)},
        {"mirrors_lamp.obj", "Hall of mirrors: the lamp under the ceiling.", std::move(lamp)},
        {"mirrors_sconce.obj", "Hall of mirrors: the small lamp at the wall.", std::move(sconce)}};
    rotate_all(files, hall_turn);
    return files;
}

} // namespace glint::scenes
