// The tree against the oracle: same triangle, same distance to the last bit, for every ray.
#include <algorithm>
#include <cfloat>
#include <mutex>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "accel/accel_impl.hpp"
#include "accel/ray_sets.hpp"
#include "kernel/traverse.hpp"
#include "math/bits.hpp"
#include "support/geometry.hpp"
#include "support/meshes.hpp"

namespace glint::test {
namespace {

// Sanitized builds are some ten times slower; they look for other faults than differing bits.
#ifdef GLINT_SANITIZED
constexpr uint32_t rays_per_mesh = 20'000;
#else
constexpr uint32_t rays_per_mesh = 1'000'000;
#endif

constexpr auto everything = [](uint32_t) { return true; };

class EveryMesh : public testing::TestWithParam<NamedMesh> {
protected:
    static void compare_with_brute_force(AccelKind kind);
};

std::string describe(const Ray &ray, const Hit &tree, const Hit &brute) {
    std::ostringstream text;
    text << std::hexfloat << "org " << ray.org.x << ' ' << ray.org.y << ' ' << ray.org.z << " dir " << ray.dir.x << ' '
         << ray.dir.y << ' ' << ray.dir.z << ": tree " << tree.triangle_id << " at " << tree.t << ", brute force "
         << brute.triangle_id << " at " << brute.t;
    return text.str();
}

TEST_P(EveryMesh, kdtree_finds_what_brute_force_finds) {
    compare_with_brute_force(AccelKind::kdtree);
}
TEST_P(EveryMesh, bvh_finds_what_brute_force_finds) {
    compare_with_brute_force(AccelKind::bvh);
}

void EveryMesh::compare_with_brute_force(AccelKind kind) {
    const auto scene = scene_of(GetParam().mesh);
    const auto accel = Accel::build(scene, {kind});
    ASSERT_EQ(accel->kind(), kind);
    const GeometryView tree = geometry_of(*accel);
    const auto oracle = Accel::build(scene, {AccelKind::brute});
    const GeometryView brute = geometry_of(*oracle);

    const RaySet rays(*scene->objects()[0].mesh);
    std::mutex mutex;
    uint32_t differences = 0, hits = 0;
    std::string first_difference;
    {
        std::vector<std::jthread> threads;
        const unsigned thread_count = std::max(1u, std::thread::hardware_concurrency());
        for (unsigned thread = 0; thread < thread_count; ++thread) {
            threads.emplace_back([&, thread] {
                uint32_t my_hits = 0;
                for (uint32_t i = thread; i < rays_per_mesh; i += thread_count) {
                    const Ray ray = rays.ray(i);
                    const PreparedRay prepared(ray, tree.bounds);
                    const Hit by_tree = closest_hit(tree, prepared, FLT_MAX);
                    const Hit by_force = closest_hit(brute, prepared, FLT_MAX);
                    // Any hit, up to just beyond and just before the closest one.
                    const float beyond = std::nextafter(by_force.t, INFINITY);
                    const bool any_agrees =
                        any_hit(tree, prepared, beyond, everything) == (by_force.triangle_id != no_triangle) &&
                        !any_hit(tree, prepared, by_force.t, everything);
                    my_hits += by_force.triangle_id != no_triangle;
                    if (by_tree.triangle_id != by_force.triangle_id ||
                        bit_cast<uint32_t>(by_tree.t) != bit_cast<uint32_t>(by_force.t) || !any_agrees) {
                        const std::lock_guard lock(mutex);
                        if (differences++ == 0) first_difference = describe(ray, by_tree, by_force);
                    }
                }
                const std::lock_guard lock(mutex);
                hits += my_hits;
            });
        }
    }
    EXPECT_EQ(differences, 0u) << "ray " << first_difference;
    EXPECT_GT(hits, rays_per_mesh / 100) << "the rays hardly meet the mesh: nothing was tested";
    EXPECT_LT(hits, rays_per_mesh);
}

/// Every edge once.
std::vector<std::pair<uint32_t, uint32_t>> edges_of(const Mesh &mesh) {
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    for (const Triangle &t : mesh.triangles) {
        edges.insert(edges.end(), {std::minmax(t.a, t.b), std::minmax(t.b, t.c), std::minmax(t.c, t.a)});
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

class EveryClosedMesh : public testing::TestWithParam<NamedMesh> {};

TEST_P(EveryClosedMesh, no_ray_from_inside_escapes_at_a_vertex_or_an_edge) {
    const auto scene = scene_of(GetParam().mesh);
    const Mesh &mesh = *scene->objects()[0].mesh;
    const auto accel = Accel::build(scene, {AccelKind::kdtree}), other = Accel::build(scene, {AccelKind::bvh});
    const GeometryView tree = geometry_of(*accel), hierarchy = geometry_of(*other);
    const auto oracle = Accel::build(scene, {AccelKind::brute});
    const GeometryView brute = geometry_of(*oracle);
    const LeafTriangles triangles(brute.leaf_words, 0, brute.triangle_count);

    std::vector<Point> targets = mesh.positions;
    for (const auto &[a, b] : edges_of(mesh)) targets.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5f);

    // A point is inside when a ray from it, in no special direction, crosses the mesh an odd number of times.
    Random random(3);
    int origins = 0;
    uint32_t misses = 0;
    for (int attempt = 0; attempt < 1000 && origins < 40; ++attempt) {
        const Point org = random.in_box(tree.bounds.lo, tree.bounds.hi);
        const PreparedRay probe({org, normalize(Vector(0.3f, 0.5f, 0.8f))}, tree.bounds);
        int crossings = 0;
        for (uint32_t id = 0; id < brute.triangle_count; ++id)
            crossings += intersect(probe, triangles.corners(id)) > 0.0f;
        if (crossings % 2 == 0) continue;
        ++origins;
        for (const Point &target : targets) {
            const PreparedRay ray({org, target - org}, tree.bounds); // not normalised: t = 1 is the target
            const Hit hit = closest_hit(tree, ray, FLT_MAX);
            misses += hit.triangle_id == no_triangle;
            misses += closest_hit(hierarchy, ray, FLT_MAX).triangle_id == no_triangle;
            misses += closest_hit(brute, ray, FLT_MAX).triangle_id == no_triangle;
        }
    }
    EXPECT_GT(origins, 10);
    EXPECT_EQ(misses, 0u);
}

std::vector<NamedMesh> closed_meshes() {
    std::vector<NamedMesh> meshes = all_meshes();
    std::erase_if(meshes, [](const NamedMesh &mesh) { return !mesh.closed; });
    return meshes;
}

constexpr auto name_of = [](const auto &test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(meshes, EveryMesh, testing::ValuesIn(all_meshes()), name_of);
INSTANTIATE_TEST_SUITE_P(meshes, EveryClosedMesh, testing::ValuesIn(closed_meshes()), name_of);

TEST(Ties, lowest_triangle_id_wins) {
    const auto accel = Accel::build(scene_of(stacked_copies(9)));
    const GeometryView tree = geometry_of(*accel);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Point target = {random.uniform(-0.9f, 0.9f), random.uniform(-0.9f, 0.9f), 0.25f};
        const Hit hit = closest_hit(tree, PreparedRay({{0, 0, 3}, target - Point(0, 0, 3)}, tree.bounds), FLT_MAX);
        ASSERT_LT(hit.triangle_id, 2u);
    }
}

} // namespace
} // namespace glint::test
