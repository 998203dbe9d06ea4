// Generated meshes have no cracks: each edge belongs to two triangles that agree which side is outside.
#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include <glint/read.hpp>
#include <gtest/gtest.h>

#include "generate/models.hpp"
#include "scenes/scene_folder.hpp"

namespace glint::test {
namespace {

void append_file(const std::filesystem::path &path, Mesh &mesh) {
    const auto read = read_obj(path);
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_TRUE(read->warnings.empty()) << read->warnings.front().text();
    const Mesh &added = *read->mesh;
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), added.positions.begin(), added.positions.end());
    for (const Triangle &t : added.triangles) mesh.triangles.push_back({first + t.a, first + t.b, first + t.c});
}

/// Makes triangles that have a corner in the same place share its vertex.
void weld(Mesh &mesh) {
    std::vector<uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](uint32_t i) {
        const Point p = mesh.positions[i];
        return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(), [&](uint32_t i, uint32_t j) { return place(i) < place(j); });
    std::vector<uint32_t> shared(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        const bool is_new = i == 0 || place(order[i]) != place(order[i - 1]);
        shared[order[i]] = is_new ? order[i] : shared[order[i - 1]];
    }
    for (Triangle &t : mesh.triangles) t = {shared[t.a], shared[t.b], shared[t.c]};
}

/// Every edge, from and to, as one number; sorted.
std::vector<uint64_t> directed_edges(const Mesh &mesh, bool reversed) {
    std::vector<uint64_t> edges;
    edges.reserve(mesh.triangles.size() * 3);
    const auto add = [&](uint32_t from, uint32_t to) {
        edges.push_back(reversed ? uint64_t{to} << 32 | from : uint64_t{from} << 32 | to);
    };
    for (const Triangle &t : mesh.triangles) {
        add(t.a, t.b);
        add(t.b, t.c);
        add(t.c, t.a);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

double signed_volume(const Mesh &mesh) {
    double six_volumes = 0.0;
    for (const Triangle &t : mesh.triangles) {
        const scenes::Vec3 a = mesh.positions[t.a], b = mesh.positions[t.b], c = mesh.positions[t.c];
        six_volumes += glm::dot(a, glm::cross(b, c));
    }
    return six_volumes / 6.0;
}

void expect_closed(const Mesh &mesh, const std::string &what) {
    const auto edges = directed_edges(mesh, false);
    EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end()) << what << ": an edge is used twice one way";
    EXPECT_TRUE(edges == directed_edges(mesh, true)) << what << ": an edge has a triangle on one side only";
    EXPECT_GT(signed_volume(mesh), 0.0) << what << ": inside out";
}

class ClosedModel : public testing::TestWithParam<std::string> {};

TEST_P(ClosedModel, has_two_triangles_at_every_edge_and_faces_outwards) {
    for (const scenes::Model &model : scenes::models()) {
        if (model.name != GetParam()) continue;
        // The terrain is one body cut into files by material; in all other models each file is closed by itself.
        const bool is_one_body = model.name == "terrain";
        Mesh body;
        for (const scenes::NamedMesh &file : model.make()) {
            append_file(scene_folder() / "generated" / file.file_name, body);
            if (is_one_body) continue;
            expect_closed(body, file.file_name);
            body = {};
        }
        if (is_one_body) {
            weld(body);
            expect_closed(body, "terrain");
        }
        return;
    }
    FAIL() << "no such model";
}

INSTANTIATE_TEST_SUITE_P(, ClosedModel, testing::Values("sphereflake", "terrain", "gears", "mirrors", "lights16"),
                         [](const auto &instance) { return instance.param; });

} // namespace
} // namespace glint::test
