// Small meshes to trace.
#include "support/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "support/random.hpp"

namespace glint::test {

namespace {

void add_mesh(Mesh &to, const Mesh &from) {
    const auto base = static_cast<uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    for (const Triangle &t : from.triangles) to.triangles.push_back({t.a + base, t.b + base, t.c + base});
}

Mesh scaled(Mesh mesh, float factor) {
    for (Point &p : mesh.positions) p *= factor;
    return mesh;
}

/// A grid of (cells + 1)^2 vertices over [-1, 1]^2, height(i, j) above it.
template <typename Height> Mesh grid(int cells, Height &&height) {
    Mesh mesh;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const auto n = static_cast<float>(cells);
            mesh.positions.push_back(
                {2.0f * static_cast<float>(i) / n - 1.0f, 2.0f * static_cast<float>(j) / n - 1.0f, height(i, j)});
        }
    }
    const auto at = [&](int i, int j) { return static_cast<uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

} // namespace

Mesh cube() {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back({corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f});
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

Mesh tetrahedron() {
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

Mesh icosphere(int subdivisions) {
    const float g = (1.0f + std::sqrt(5.0f)) / 2.0f;
    Mesh mesh{{{-1, g, 0},
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
               {-g, 0, 1}},
              {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (int step = 0; step < subdivisions; ++step) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [entry, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(mesh.positions.size()));
            if (is_new) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5f);
            return entry->second;
        };
        std::vector<Triangle> finer;
        for (const Triangle &t : mesh.triangles) {
            const uint32_t ab = middle(t.a, t.b), bc = middle(t.b, t.c), ca = middle(t.c, t.a);
            finer.insert(finer.end(), {{t.a, ab, ca}, {t.b, bc, ab}, {t.c, ca, bc}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Point &p : mesh.positions) p /= std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    return mesh;
}

Mesh torus(int around, int across) {
    Mesh mesh;
    const float turn = 6.2831853f;
    for (int i = 0; i < around; ++i) {
        const float a = turn * static_cast<float>(i) / static_cast<float>(around);
        for (int j = 0; j < across; ++j) {
            const float b = turn * static_cast<float>(j) / static_cast<float>(across);
            const float r = 0.7f + 0.3f * std::cos(b);
            mesh.positions.push_back({r * std::cos(a), 0.3f * std::sin(b), r * std::sin(a)});
        }
    }
    const auto at = [&](int i, int j) { return static_cast<uint32_t>((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

Mesh terrain(int cells) {
    Random random(5);
    return grid(cells, [&](int, int) { return random.uniform(-0.2f, 0.2f); });
}

Mesh flat_grid(int cells) {
    return grid(cells, [](int, int) { return 0.0f; });
}

Mesh soup(int triangles) {
    Mesh mesh;
    Random random(7);
    for (int i = 0; i < triangles; ++i) {
        const Point center = random.in_box(Point(-1.0f), Point(1.0f));
        for (int corner = 0; corner < 3; ++corner) {
            mesh.positions.push_back(center + random.in_box(Point(-0.4f), Point(0.4f)));
        }
        const auto base = static_cast<uint32_t>(3 * i);
        mesh.triangles.push_back({base, base + 1, base + 2});
    }
    return mesh;
}

Mesh slivers(int triangles) {
    Mesh mesh;
    Random random(9);
    mesh.positions.push_back(Point(0.0f));
    for (int i = 0; i < triangles; ++i) {
        const Point tip = random.direction();
        mesh.positions.push_back(tip);
        mesh.positions.push_back(tip + 0.001f * random.direction());
        const auto base = static_cast<uint32_t>(1 + 2 * i);
        mesh.triangles.push_back({0, base, base + 1});
    }
    return mesh;
}

Mesh stacked_copies(int copies) {
    Mesh mesh;
    for (int i = 0; i < copies; ++i) {
        const auto base = static_cast<uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {{-1, -1, 0.25f}, {1, -1, 0.25f}, {1, 1, 0.25f}, {-1, 1, 0.25f}});
        mesh.triangles.push_back({base, base + 1, base + 2});
        mesh.triangles.push_back({base, base + 2, base + 3});
    }
    return mesh;
}

Mesh small_in_large() {
    Mesh mesh = scaled(cube(), 1000.0f);
    add_mesh(mesh, scaled(icosphere(1), 0.001f));
    return mesh;
}

Mesh moved(Mesh mesh, Vector by) {
    for (Point &p : mesh.positions) p += by;
    return mesh;
}

Mesh turned(Mesh mesh) {
    const float c1 = std::cos(0.7f), s1 = std::sin(0.7f), c2 = std::cos(1.1f), s2 = std::sin(1.1f);
    for (Point &p : mesh.positions) {
        const Point q = {c1 * p.x - s1 * p.y, s1 * p.x + c1 * p.y, p.z};
        p = {q.x, c2 * q.y - s2 * q.z, s2 * q.y + c2 * q.z};
    }
    return mesh;
}

std::shared_ptr<const Mesh> square(Point centre, float half) {
    const float x = centre.x, y = centre.y, z = centre.z;
    return std::make_shared<Mesh>(
        Mesh{{{x - half, y - half, z}, {x + half, y - half, z}, {x + half, y + half, z}, {x - half, y + half, z}},
             {{0, 1, 2}, {0, 2, 3}}});
}

std::shared_ptr<const Scene> scene_of(Mesh mesh) {
    SceneBuilder builder;
    builder.add_object({"mesh", std::make_shared<Mesh>(std::move(mesh)), {}});
    auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return scene.value();
}

std::vector<NamedMesh> all_meshes() {
    Mesh mixture = soup(40);
    add_mesh(mixture, cube());
    add_mesh(mixture, flat_grid(4));
    return {
        {"cube", cube(), true},
        {"turned_cube", turned(cube()), true},
        {"tetrahedron", tetrahedron(), true},
        {"icosphere", icosphere(1), true},
        {"torus", torus(14, 8), true},
        {"turned_torus", turned(torus(10, 6)), true},
        {"terrain", terrain(8), false},
        {"flat_grid", flat_grid(6), false},
        {"turned_flat_grid", turned(flat_grid(6)), false},
        {"soup", soup(100), false},
        {"slivers", slivers(80), false},
        {"stacked_copies", stacked_copies(20), false},
        {"small_in_large", small_in_large(), true},
        {"far_torus", moved(torus(10, 6), {1e4f, -2e4f, 3e4f}), true},
        {"mixture", mixture, false},
    };
}

} // namespace glint::test
