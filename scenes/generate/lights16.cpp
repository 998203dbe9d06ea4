// Sixteen lamps in a ring over a queen and her eight pawns on a round board: sixteen coloured shadows each.
#include "generate/models.hpp"
#include "generate/shapes.hpp"
#include "generate/trig.hpp"

namespace glint::scenes {
namespace {

constexpr uint32_t lamp_count = 16;
constexpr uint32_t pawn_count = 8;
/// Seen at 37 degrees over the board (3-4-5).
constexpr Tilt view_tilt{0.8, 0.6};

Mesh queen() {
    Mesh mesh = lathe(smooth_profile({{0.0, 0.0},
                                      {0.78, 0.0},
                                      {0.8, 0.16},
                                      {0.66, 0.26},
                                      {0.68, 0.36},
                                      {0.46, 0.56},
                                      {0.28, 1.2},
                                      {0.24, 1.9},
                                      {0.27, 2.2},
                                      {0.46, 2.28},
                                      {0.46, 2.36},
                                      {0.3, 2.46},
                                      {0.32, 2.6},
                                      {0.46, 3.0},
                                      {0.4, 3.04},
                                      {0.2, 3.12},
                                      {0.0, 3.14}},
                                     10),
                      192);
    mesh.append(geodesic_sphere(16), 0.14, {0.0, 3.24, 0.0});
    return mesh;
}

Mesh pawns() {
    Mesh pawn = lathe(smooth_profile({{0.0, 0.0},
                                      {0.46, 0.0},
                                      {0.48, 0.1},
                                      {0.38, 0.18},
                                      {0.38, 0.24},
                                      {0.24, 0.4},
                                      {0.15, 0.8},
                                      {0.28, 0.9},
                                      {0.26, 0.95},
                                      {0.0, 1.0}},
                                     8),
                      96);
    pawn.append(geodesic_sphere(24), 0.26, {0.0, 1.15, 0.0});
    Mesh mesh;
    for (uint32_t i = 0; i < pawn_count; ++i) {
        const auto [cosine, sine] = cos_sin_turns((i + 0.5) / pawn_count);
        mesh.append(pawn, 1.0, {2.4 * cosine, 0.0, -2.4 * sine});
    }
    return mesh;
}

Mesh board() {
    return lathe({{0.0, -0.3}, {5.0, -0.3}, {5.15, -0.25}, {5.15, -0.1}, {5.05, 0.0}, {0.0, 0.0}}, 256);
}

} // namespace

std::vector<NamedMesh> lights16() {
    std::vector<NamedMesh> files{{"lights16_board.obj", "Sixteen lamps: the round board.", board()},
                                 {"lights16_queen.obj", "Sixteen lamps: the queen.", queen()},
                                 {"lights16_pawns.obj", "Sixteen lamps: her pawns.", pawns()}};
    const Mesh ball = geodesic_sphere(8);
    for (uint32_t i = 0; i < lamp_count; ++i) {
        const auto [cosine, sine] = cos_sin_turns(double(i) / lamp_count);
        const std::string number = (i < 9 ? "0" : "") + std::to_string(i + 1);
        NamedMesh lamp{"lights16_lamp_" + number + ".obj", "Sixteen lamps: lamp " + number + ".", {}};
        lamp.mesh.append(ball, 0.16, {4.4 * cosine, 3.6, -4.4 * sine});
        files.push_back(std::move(lamp));
    }
    rotate_all(files, view_tilt);
    return files;
}

} // namespace glint::scenes
