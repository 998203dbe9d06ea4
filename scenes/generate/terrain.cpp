// Mountains around a lake, cut from the land as a block: a heightfield of fractal noise with sides and a bottom.
#include <algorithm>
#include <array>
#include <cmath>

#include "generate/models.hpp"
#include "generate/noise.hpp"

namespace glint::scenes {
namespace {

/// Cells along each side; two triangles a cell.
constexpr uint32_t cells = 724;
constexpr double low_x = -14.0;
constexpr double low_z = -30.0;
constexpr double extent = 28.0;
constexpr double bottom_y = -1.5;

enum Ground : size_t { sand, grass, rock, snow, ground_count };
constexpr std::array<const char *, ground_count> ground_names{"sand", "grass", "rock", "snow"};

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// In [0, 1]: octaves of noise, each weighing less where those before it are steep, as rain wears down slopes first and
/// leaves ridges sharp. Source: Inigo Quilez, "Value noise derivatives", 2008.
double eroded_noise(Vec2 p) {
    double sum = 0.0;
    double weight = 0.5;
    Vec2 slope{0.0};
    for (uint32_t octave = 0; octave < 9; ++octave) {
        const NoiseSample sample = value_noise(p, octave);
        slope += sample.slope;
        sum += weight * sample.value / (1.0 + glm::dot(slope, slope));
        weight *= 0.5;
        // Twice as fine, and turned (3-4-5) so that the lattices do not line up.
        p = 2.0 * Vec2{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y};
    }
    return sum;
}

/// Height over the lake's surface (y = 0).
double height(double x, double z) {
    const double detail = eroded_noise({x * 0.11 + 4.7, z * 0.11 + 8.3});
    // How far outside the lake's oval; its shore is bent by the noise.
    const Vec2 from_lake{(x - 0.5) / 8.0, (z + 5.0) / 10.0};
    const double shore = std::sqrt(glm::dot(from_lake, from_lake)) + 1.2 * (detail - 0.3);
    const double rise = smooth_step(0.8, 2.2, shore);
    return -0.6 + 0.9 * smooth_step(0.6, 1.1, shore) + rise * (0.3 + 10.5 * detail);
}

Ground ground_of(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = glm::cross(b - a, c - a);
    const double upright = normal.y / glm::length(normal);
    const Vec3 middle = (a + b + c) / 3.0;
    const double speckle = value_noise({middle.x * 3.0, middle.z * 3.0}, 77).value;
    if (middle.y < 0.08) return sand;
    if (middle.y + speckle > 2.7 && upright > 0.5) return snow;
    if (upright + 0.15 * speckle > 0.8 && middle.y < 2.4) return grass;
    return rock;
}

/// Gathers the triangles of one kind of ground, with only those of the block's vertices that they use.
class GroundMesh {
public:
    GroundMesh(const std::vector<Vec3> &all, Mesh &mesh) : all_(all), mesh_(mesh), index_(all.size(), unknown) {}

    void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
        // One after another: compilers may evaluate arguments in any order, and the first use numbers a vertex.
        const uint32_t local_a = local(a);
        const uint32_t local_b = local(b);
        const uint32_t local_c = local(c);
        mesh_.add_triangle(local_a, local_b, local_c);
    }

private:
    static constexpr uint32_t unknown = ~0u;

    uint32_t local(uint32_t vertex) {
        if (index_[vertex] == unknown) index_[vertex] = mesh_.add_vertex(all_[vertex]);
        return index_[vertex];
    }

    const std::vector<Vec3> &all_;
    Mesh &mesh_;
    std::vector<uint32_t> index_;
};

} // namespace

std::vector<NamedMesh> terrain() {
    // Every vertex of the block: the grid's, then the bottom's rim below the grid's border, then the bottom's middle.
    std::vector<Vec3> positions;
    const auto grid_at = [](uint32_t column, uint32_t row) { return row * (cells + 1) + column; };
    for (uint32_t row = 0; row <= cells; ++row) {
        for (uint32_t column = 0; column <= cells; ++column) {
            const double x = low_x + extent * column / cells;
            const double z = low_z + extent * row / cells;
            positions.push_back({x, height(x, z), z});
        }
    }
    // The border, counter-clockwise seen from above (z points to the viewer).
    std::vector<uint32_t> border;
    for (uint32_t i = 0; i < cells; ++i) border.push_back(grid_at(i, cells));
    for (uint32_t i = 0; i < cells; ++i) border.push_back(grid_at(cells, cells - i));
    for (uint32_t i = 0; i < cells; ++i) border.push_back(grid_at(cells - i, 0));
    for (uint32_t i = 0; i < cells; ++i) border.push_back(grid_at(0, i));
    const auto rim = static_cast<uint32_t>(positions.size());
    for (const uint32_t vertex : border) positions.push_back({positions[vertex].x, bottom_y, positions[vertex].z});
    const auto middle = static_cast<uint32_t>(positions.size());
    positions.push_back({low_x + extent / 2.0, bottom_y, low_z + extent / 2.0});

    std::vector<NamedMesh> files(ground_count);
    std::vector<GroundMesh> grounds;
    for (size_t g = 0; g < ground_count; ++g) {
        files[g].file_name = std::string("terrain_") + ground_names[g] + ".obj";
        files[g].comment =
            std::string("Terrain: the ") + ground_names[g] + ". The terrain's files together are closed.";
        grounds.emplace_back(positions, files[g].mesh);
    }
    const auto add_land = [&](uint32_t a, uint32_t b, uint32_t c) {
        grounds[ground_of(positions[a], positions[b], positions[c])].add_triangle(a, b, c);
    };
    for (uint32_t row = 0; row < cells; ++row) {
        for (uint32_t column = 0; column < cells; ++column) {
            const uint32_t a = grid_at(column, row), b = grid_at(column, row + 1);
            const uint32_t c = grid_at(column + 1, row + 1), d = grid_at(column + 1, row);
            add_land(a, b, c);
            add_land(a, c, d);
        }
    }
    const auto border_count = static_cast<uint32_t>(border.size());
    for (uint32_t i = 0; i < border_count; ++i) {
        const uint32_t next = (i + 1) % border_count;
        grounds[rock].add_triangle(rim + i, rim + next, border[next]);
        grounds[rock].add_triangle(rim + i, border[next], border[i]);
        grounds[rock].add_triangle(rim + next, rim + i, middle);
    }
    return files;
}

} // namespace glint::scenes
