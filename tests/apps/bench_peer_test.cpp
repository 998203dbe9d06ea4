// The peers do what Glint does: the same picture, the same hits, by every one of their ways.
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glint/glint.hpp>

#include "bench/find_peer.hpp"
#include "bench/kernel_comparison.hpp"
#include "bench/picture_difference.hpp"
#include "bench/ray_classes.hpp"
#include "support/meshes.hpp"

namespace glint::bench {
namespace {

class EmbreePeer : public testing::TestWithParam<Isa> {
protected:
    void SetUp() override {
        const auto found = find_peer("embree");
        if (!found) GTEST_SKIP() << found.error().text();
        peer = *found;
    }

    const Peer *peer = nullptr;
};

/// A scene that has all that shading knows: mirrors, glass, highlights, several lights, a background. No edge lies
/// along a row of rays, where either answer is right.
std::shared_ptr<const Scene> colourful_scene() {
    SceneBuilder builder;
    const auto square = [](const Point &corner, const Vector &u, const Vector &v) {
        const auto mesh = std::make_shared<Mesh>();
        mesh->positions = {corner, corner + u, corner + u + v, corner + v};
        mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
        return mesh;
    };
    builder.add_object({"floor",
                        square({-2, -1, -4}, {4, 0, 0}, {0, 0, 4}),
                        {.color = {0.9f, 0.8f, 0.7f}, .ambient = 0.1f, .diffuse = 0.7f, .reflection = 0.3f}});
    builder.add_object({"mirror",
                        square({-2, -1, -4}, {4, 0, 0.5f}, {0, 2.5f, 0}),
                        {.color = {1, 1, 1}, .ambient = 0.1f, .diffuse = 0.3f, .reflection = 0.8f}});
    builder.add_object({"glass",
                        square({-0.5f, -0.9f, -1.5f}, {1, 0, 0.3f}, {0, 1.2f, 0.2f}),
                        {.color = {0.5f, 0.9f, 1},
                         .ambient = 0.1f,
                         .diffuse = 0.4f,
                         .specular = 0.5f,
                         .specular_exponent = 20.0f,
                         .reflection = 0.3f,
                         .transmission = 0.6f}});
    builder.add_object({"tile",
                        square({0.6f, -0.9f, -2.0f}, {0.8f, 0, -0.3f}, {0, 0.93f, 0.1f}),
                        {.color = {1, 0.2f, 0.2f}, .diffuse = 0.6f, .specular = 0.6f, .specular_exponent = 3.5f}});
    builder.add_light({"lamp", square({-0.3f, 1.2f, -2.2f}, {0.6f, 0, 0}, {0, 0, 0.6f}), {1, 0.9f, 0.8f}, 0.6f});
    builder.add_light({"second", square({-1.9f, 0.3f, -0.5f}, {0, 0.3f, 0}, {0, 0, 0.3f}), {0.3f, 0.4f, 1}, 0.5f});
    builder.set_background({0.1f, 0.2f, 0.3f}).set_ambient(1.0f);
    return builder.build().value();
}

TEST_P(EmbreePeer, its_picture_is_ours_at_every_depth_and_size) {
    const auto scene = colourful_scene();
    const auto peer_renderer = peer->renderer(scene, GetParam(), 2);
    if (!peer_renderer) GTEST_SKIP() << peer_renderer.error().text();
    Renderer renderer(Accel::build(scene), {.threads = 2, .isa = Isa::scalar});
    for (const auto &[width, height] : {std::pair(200u, 200u), std::pair(131u, 77u), std::pair(1u, 1u)}) {
        for (const uint32_t depth : {0u, 1u, 2u, 6u}) {
            Framebuffer ours = Framebuffer::create(width, height, false).value();
            Framebuffer theirs = Framebuffer::create(width, height, false).value();
            ASSERT_TRUE(renderer.render(ours, {.max_depth = depth, .camera = {}}).ok());
            (*peer_renderer)->render(theirs, depth);
            const PictureDifference difference = compare_pictures(ours, theirs);
            EXPECT_TRUE(difference.same_picture())
                << width << "x" << height << " depth " << depth << ": " << difference.differing << " pixels differ";
        }
    }
}

TEST_P(EmbreePeer, every_way_to_trace_finds_the_same_hits) {
    const auto accel = Accel::build(test::scene_of(test::torus(60, 30)));
    const RayQuery query(accel, Isa::scalar);
    const auto kernels = peer->kernels(std::shared_ptr<const Scene>(accel, &accel->scene()), GetParam());
    if (!kernels) GTEST_SKIP() << kernels.error().text();
    const auto classes = make_ray_classes(accel->scene(), query, viewpoint_framing(accel->scene()), 67);
    for (const RaySet &rays : classes) {
        RayAnswers ours(rays);
        const RayBatch batch = rays.batch(0, rays.size());
        if (rays.question == RayQuestion::any_hit)
            query.any_hits(batch, ours.occluded.data());
        else
            query.closest_hits(batch, {ours.t.data(), ours.triangle_id.data()});
        const std::vector<std::string> ways = (*kernels)->ways(rays.question);
        ASSERT_FALSE(ways.empty());
        for (size_t way = 0; way < ways.size(); ++way) {
            const auto traced = (*kernels)->query(rays, way);
            RayAnswers theirs(rays);
            for (int again = 0; again < 2; ++again) {
                traced->reset(0, rays.size());
                traced->trace(0, rays.size());
            }
            traced->read(theirs);
            const Agreement agreement = compare_answers(rays.question, ours, theirs);
            EXPECT_TRUE(agreement.hits_equal()) << rays.name << ", " << ways[way];
            EXPECT_GT(agreement.same, agreement.rays * 999 / 1000) << rays.name << ", " << ways[way];
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Isas, EmbreePeer, testing::Values(Isa::sse4, Isa::avx2, Isa::avx512),
                         [](const auto &isa) { return std::string(isa_name(isa.param)); });

} // namespace
} // namespace glint::bench
