// Every kernel's rays end where the scalar kernel's do, through the tree and by brute force.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

#include "kernel/ray_batches.hpp"
#include "kernel/ray_comparison.hpp"
#include "support/meshes.hpp"

namespace glint::test {
namespace {

// glint_compare_rays goes on from here with as many rays as one likes.
#ifdef GLINT_SANITIZED
constexpr uint32_t batches_a_mesh = 10;
#else
constexpr uint32_t batches_a_mesh = 270;
#endif

class EveryMesh : public testing::TestWithParam<NamedMesh> {};

TEST_P(EveryMesh, is_hit_alike_by_every_kernel) {
    const RayComparison result = compare_rays(scene_of(GetParam().mesh), 0, batches_a_mesh);
    EXPECT_EQ(result.differences, 0u) << result.first_difference;
    EXPECT_GT(result.rays, batches_a_mesh * 100u);
    EXPECT_GT(result.hits, result.rays / 20) << "the rays hardly meet the mesh: nothing was tested";
    EXPECT_LT(result.hits, result.rays);
}

INSTANTIATE_TEST_SUITE_P(meshes, EveryMesh, testing::ValuesIn(all_meshes()),
                         [](const auto &test) { return test.param.name; });

TEST(Batches, of_no_rays_or_one_are_answered) {
    const auto accel = Accel::build(scene_of(cube()));
    for (const Isa isa : available_isas()) {
        const RayQuery query(accel, isa);
        query.closest_hits({}, {});
        query.any_hits({}, nullptr);
        RayRows one;
        one.add({{0.25f, 0.5f, 3.0f}, {0.0f, 0.0f, -2.0f}}, 10.0f);
        float t = 0.0f;
        uint32_t triangle = no_triangle;
        uint8_t occluded = 7;
        query.closest_hits(one.batch(), {&t, &triangle});
        query.any_hits(one.batch(), &occluded);
        EXPECT_EQ(t, 1.0f) << isa_name(isa);
        EXPECT_NE(triangle, no_triangle) << isa_name(isa);
        EXPECT_EQ(occluded, 1) << isa_name(isa);
    }
}

/// A grid that crosses the z axis at each of these depths, and rises with x.
Mesh sheets(std::initializer_list<float> depths, float rise) {
    Mesh mesh;
    for (const float z : depths) {
        const auto base = static_cast<uint32_t>(mesh.positions.size());
        const Mesh sheet = flat_grid(4);
        for (const Point &p : sheet.positions) mesh.positions.push_back({p.x, p.y, z + rise * p.x});
        for (const Triangle &t : sheet.triangles) mesh.triangles.push_back({t.a + base, t.b + base, t.c + base});
    }
    return mesh;
}

// A direction's length is a matter of units: a power of two more makes distances exactly as much less.
TEST(Batches, may_have_directions_of_any_length) {
    const auto scene = scene_of(torus(40, 20));
    RayRows rows;
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const Point from = random.direction() * 5.0f;
        rows.add({from, normalize(random.direction() * 1.2f - from) * random.uniform(0.3f, 1.0f)}, FLT_MAX);
    }
    for (const AccelKind kind : {AccelKind::kdtree, AccelKind::bvh, AccelKind::brute}) {
        const auto accel = Accel::build(scene, {kind, 1});
        for (const Isa isa : available_isas()) {
            const RayQuery query(accel, isa);
            std::vector<float> t(rows.count()), scaled_t(rows.count());
            std::vector<uint32_t> triangle(rows.count(), no_triangle), scaled_triangle(rows.count(), no_triangle);
            query.closest_hits(rows.batch(), {t.data(), triangle.data()});
            EXPECT_GT(std::count(triangle.begin(), triangle.end(), no_triangle), 100);
            EXPECT_LT(std::count(triangle.begin(), triangle.end(), no_triangle), 1900);
            for (const int power : {-100, -50, 50, 100, 120, 126}) {
                RayRows scaled = rows;
                for (auto *row : {&scaled.dir_x, &scaled.dir_y, &scaled.dir_z}) {
                    for (float &coordinate : *row) coordinate = std::ldexp(coordinate, power);
                }
                query.closest_hits(scaled.batch(), {scaled_t.data(), scaled_triangle.data()});
                EXPECT_EQ(scaled_triangle, triangle)
                    << isa_name(isa) << ", " << accel_kind_name(kind) << ", times 2^" << power;
                for (size_t i = 0; i < rows.count(); ++i) {
                    if (triangle[i] == no_triangle) continue;
                    ASSERT_EQ(scaled_t[i], std::ldexp(t[i], -power)) << "ray " << i << ", " << isa_name(isa) << ", "
                                                                     << accel_kind_name(kind) << ", times 2^" << power;
                }
            }
        }
    }
}

// The way of most rays of a group may end before the first ray's origin, from which the group's depths are counted.
TEST(Batches, may_end_behind_their_first_ray) {
    for (const float way : {1.0f, -1.0f}) {
        for (const bool near_first : {false, true}) {
            const float near = way * -0.2f, far = way * -7.0f;
            RayRows rows;
            rows.add({{0.1f, 0.2f, 0.0f}, {0.0f, 0.0f, way}}, 1.0f);
            for (int i = 0; i < 40; ++i) rows.add({{0.1f, 0.2f, way * -10.0f}, {0.0f, 0.0f, way}}, 4.0f);
            const auto scene = scene_of(near_first ? sheets({near, far}, 4.0f * way) : sheets({far, near}, 4.0f * way));
            for (const AccelKind kind : {AccelKind::kdtree, AccelKind::bvh, AccelKind::brute}) {
                const auto accel = Accel::build(scene, {kind, 1});
                for (const Isa isa : available_isas()) {
                    std::vector<uint8_t> occluded(rows.count());
                    RayQuery(accel, isa).any_hits(rows.batch(), occluded.data());
                    EXPECT_EQ(occluded, std::vector<uint8_t>(rows.count(), 1))
                        << isa_name(isa) << ", " << accel_kind_name(kind) << ", way " << way << ", near first "
                        << near_first;
                }
            }
        }
    }
}

// A triangle seen edge on is hit at a point of its longest edge, before the ray comes to the triangle's plane: that it
// ends before the plane tells nothing.
TEST(Batches, may_end_before_the_plane_of_what_they_hit) {
    Mesh needle;
    needle.positions = {{0.0f, 0.0f, 0.0f},
                        {-0x1.1805bcp-1f, -0x1.9b51b6p-1f, -0x1.e275d2p-3f},
                        {-0x1.17ecc2p-1f, -0x1.9ad768p-1f, -0x1.e1d5f4p-3f}};
    needle.triangles = {{0, 1, 2}};
    const Ray along{{0x1.b66012p-2f, 0x1.4231cep-1f, 0x1.79f68ep-3f},
                    {-0x1.17f4aep-1f, -0x1.9b5bf8p-1f, -0x1.e2883ap-3f}};
    RayRows rows;
    for (int i = 0; i < 5; ++i) rows.add(along, 0x1.0cdf3cp+0f);
    const auto scene = scene_of(std::move(needle));
    for (const AccelKind kind : {AccelKind::kdtree, AccelKind::bvh}) {
        const auto accel = Accel::build(scene, {kind, 1});
        for (const Isa isa : available_isas()) {
            std::vector<uint8_t> occluded(rows.count());
            RayQuery(accel, isa).any_hits(rows.batch(), occluded.data());
            EXPECT_EQ(occluded, std::vector<uint8_t>(rows.count(), 1))
                << isa_name(isa) << ", " << accel_kind_name(kind);
        }
    }
}

TEST(Batches, answer_for_sound_rays_whatever_stands_beside_them) {
    const auto scene = scene_of(flat_grid(4)); // in the plane z = 0
    RayRows rows;
    const Point origin{0.1f, 0.2f, 5.0f};
    for (int i = 0; i < 16; ++i) rows.add({origin, {0.0f, 0.0f, -1.0f}}, 10.0f);
    for (int i = 0; i < 16; ++i) rows.add({origin, {0.0f, 0.0f, -0.0f}}, INFINITY); // go nowhere, for ever
    for (int i = 0; i < 16; ++i) rows.add({origin, {0.0f, 0.0f, -1.0f}}, 4.0f);
    for (const AccelKind kind : {AccelKind::kdtree, AccelKind::bvh}) {
        const auto accel = Accel::build(scene, {kind, 1});
        for (const Isa isa : available_isas()) {
            std::vector<uint8_t> occluded(rows.count());
            RayQuery(accel, isa).any_hits(rows.batch(), occluded.data());
            for (size_t i = 0; i < rows.count(); ++i) {
                ASSERT_EQ(occluded[i], i < 16 ? 1 : 0)
                    << "ray " << i << ", " << isa_name(isa) << ", " << accel_kind_name(kind);
            }
        }
    }
}

TEST(Batches, leave_the_memory_behind_them_alone) {
    const auto accel = Accel::build(scene_of(icosphere(1)));
    const auto &mesh = *accel->scene().objects()[0].mesh;
    for (uint32_t number = 0; number < 60; ++number) {
        const RayRows rows = BatchSet(mesh).batch(number);
        for (const Isa isa : available_isas()) {
            std::vector<float> t(rows.count() + 16, -7.0f);
            std::vector<uint32_t> triangle(rows.count() + 16, 7);
            std::vector<uint8_t> occluded(rows.count() + 16, 7);
            const RayQuery query(accel, isa);
            query.closest_hits(rows.batch(), {t.data(), triangle.data()});
            query.any_hits(rows.batch(), occluded.data());
            for (size_t i = rows.count(); i < t.size(); ++i) {
                ASSERT_TRUE(t[i] == -7.0f && triangle[i] == 7 && occluded[i] == 7) << isa_name(isa);
            }
        }
    }
}

} // namespace
} // namespace glint::test
