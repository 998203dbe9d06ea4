// What comparisons with another ray tracer rest on: equal rays, turns, and pictures and hits that are held against each
// other.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/comparison_report.hpp"
#include "bench/find_peer.hpp"
#include "bench/interleaved.hpp"
#include "bench/kernel_comparison.hpp"
#include "bench/picture_difference.hpp"
#include "bench/ray_classes.hpp"

namespace glint::bench {
namespace {

Framebuffer grey_picture() {
    Framebuffer picture = Framebuffer::create(100, 20, false).value();
    for (int i = 0; i < 100 * 20 * 4; ++i) picture.rgba8()[i] = 100;
    return picture;
}

TEST(PictureDifference, a_step_of_one_is_rounding) {
    const Framebuffer a = grey_picture();
    Framebuffer b = grey_picture();
    for (int i = 0; i < 100 * 20 * 4; ++i) b.rgba8()[i] = static_cast<uint8_t>(i % 2 == 0 ? 99 : 101);
    const PictureDifference difference = compare_pictures(a, b);
    EXPECT_EQ(difference.pixels, 2000u);
    EXPECT_EQ(difference.differing, 0u);
    EXPECT_EQ(difference.largest, 1);
    EXPECT_TRUE(difference.same_picture());
}

TEST(PictureDifference, one_pixel_in_a_thousand_may_differ_and_no_more) {
    const Framebuffer a = grey_picture();
    Framebuffer b = grey_picture();
    b.rgba8()[0] = 102;
    b.rgba8()[1] = 0; // the same pixel
    b.rgba8()[4 * 1999 + 2] = 98;
    EXPECT_EQ(compare_pictures(a, b).differing, 2u);
    EXPECT_EQ(compare_pictures(a, b).largest, 100);
    EXPECT_TRUE(compare_pictures(a, b).same_picture());
    b.rgba8()[4 * 1000 + 3] = 255;
    EXPECT_EQ(compare_pictures(a, b).differing, 3u);
    EXPECT_FALSE(compare_pictures(a, b).same_picture());
}

/// Answers of 10,000 rays that all hit triangle 7.
RayAnswers ten_thousand_hits(RayQuestion question) {
    RaySet rays("", question);
    for (int i = 0; i < 10000; ++i) rays.add(Point(0.0f), Vector(1.0f), 1.0f);
    RayAnswers answers(rays);
    answers.triangle_id.assign(answers.triangle_id.size(), 7);
    answers.occluded.assign(answers.occluded.size(), 1);
    return answers;
}

TEST(Agreement, one_hit_in_ten_thousand_may_be_missing_and_no_more) {
    for (const RayQuestion question : {RayQuestion::closest_hit, RayQuestion::any_hit}) {
        const RayAnswers ours = ten_thousand_hits(question);
        RayAnswers theirs = ours;
        const auto miss = [&](size_t ray) {
            if (question == RayQuestion::any_hit)
                theirs.occluded[ray] = 0;
            else
                theirs.triangle_id[ray] = no_triangle;
        };
        miss(17);
        Agreement agreement = compare_answers(question, ours, theirs);
        EXPECT_EQ(agreement.glint_hits, 10000u);
        EXPECT_EQ(agreement.peer_hits, 9999u);
        EXPECT_EQ(agreement.same, 9999u);
        EXPECT_TRUE(agreement.hits_equal());
        miss(18);
        agreement = compare_answers(question, ours, theirs);
        EXPECT_FALSE(agreement.hits_equal());
        EXPECT_FALSE(compare_answers(question, theirs, ours).hits_equal());
    }
}

TEST(Agreement, another_triangle_is_a_hit_but_not_the_same) {
    const RayAnswers ours = ten_thousand_hits(RayQuestion::closest_hit);
    RayAnswers theirs = ours;
    for (size_t i = 0; i < 100; ++i) theirs.triangle_id[i] = 8;
    const Agreement agreement = compare_answers(RayQuestion::closest_hit, ours, theirs);
    EXPECT_TRUE(agreement.hits_equal());
    EXPECT_EQ(agreement.same, 9900u);
}

TEST(Turns, each_side_begins_every_other_time_and_only_running_is_timed) {
    std::string order;
    struct Thing {
        std::string &order;
        char prepared, ran;
        void prepare() const { order += prepared; }
        void run() const { order += ran; }
    };
    Turns turns;
    for (int i = 0; i < 3; ++i) turns.take(Thing{order, 'g', 'G'}, Thing{order, 'p', 'P'});
    EXPECT_EQ(order, "gGpPpPgGgGpP");
    EXPECT_EQ(turns.glint_ms.size(), 3u);
    EXPECT_EQ(turns.peer_ms.size(), 3u);
}

/// A floor of two triangles at y = 0, from -1 to 1.
std::shared_ptr<const Scene> floor_scene() {
    const auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    SceneBuilder builder;
    builder.add_object({"floor", mesh, Material{}});
    return builder.build().value();
}

class FloorRays : public testing::Test {
protected:
    Point org(const RaySet &rays, size_t i) const { return {rays.org_x[i], rays.org_y[i], rays.org_z[i]}; }
    Vector dir(const RaySet &rays, size_t i) const { return {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]}; }
    static float length(const Vector &a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

    static constexpr uint32_t size_px = 40; // no multiple of a tile's
    std::shared_ptr<const Scene> scene = floor_scene();
    Viewpoint viewpoint = viewpoint_framing(*scene);
    RayQuery query{Accel::build(scene)};
    std::vector<RaySet> classes = make_ray_classes(*scene, query, viewpoint, size_px);
    const RaySet &primary = classes[0], &shadow = classes[1], &mirror = classes[2], &diffuse = classes[3];
};

TEST_F(FloorRays, there_is_a_primary_ray_for_every_pixel_and_one_of_each_other_class_for_every_hit) {
    ASSERT_EQ(classes.size(), 4u);
    EXPECT_EQ(primary.size(), size_px * size_px);
    RayAnswers answers(primary);
    query.closest_hits(primary.batch(0, primary.size()), {answers.t.data(), answers.triangle_id.data()});
    const auto hits = static_cast<size_t>(std::count_if(answers.triangle_id.begin(), answers.triangle_id.end(),
                                                        [](uint32_t id) { return id != no_triangle; }));
    EXPECT_GT(hits, 100u);
    EXPECT_LT(hits, primary.size());
    for (size_t i = 1; i < 4; ++i) EXPECT_EQ(classes[i].size(), hits) << classes[i].name;
    EXPECT_EQ(shadow.question, RayQuestion::any_hit);
    EXPECT_EQ(mirror.question, RayQuestion::closest_hit);
}

TEST_F(FloorRays, primary_rays_come_in_blocks_of_four_by_four) {
    // The pixel of ray i from where it passes the window.
    const Camera &camera = viewpoint.camera;
    const auto pixel = [&](size_t i) {
        const Vector d = dir(primary, i), corner = camera.top_left - camera.eye;
        const Vector n{camera.right.y * camera.down.z - camera.right.z * camera.down.y,
                       camera.right.z * camera.down.x - camera.right.x * camera.down.z,
                       camera.right.x * camera.down.y - camera.right.y * camera.down.x};
        const auto dot = [](const Vector &a, const Vector &b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
        const Vector p = d * (dot(corner, n) / dot(d, n)) - corner;
        return std::pair(static_cast<int>(dot(p, camera.right) / dot(camera.right, camera.right) * size_px),
                         static_cast<int>(dot(p, camera.down) / dot(camera.down, camera.down) * size_px));
    };
    EXPECT_EQ(pixel(0), std::pair(0, 0));
    EXPECT_EQ(pixel(3), std::pair(3, 0));
    EXPECT_EQ(pixel(4), std::pair(0, 1));
    EXPECT_EQ(pixel(15), std::pair(3, 3));
    EXPECT_EQ(pixel(16), std::pair(4, 0));
    EXPECT_EQ(pixel(64), std::pair(0, 4));
    EXPECT_EQ(pixel(256), std::pair(16, 0));
}

TEST_F(FloorRays, shadow_rays_run_from_the_light_to_just_before_the_floor) {
    for (size_t i = 0; i < shadow.size(); ++i) {
        EXPECT_EQ(org(shadow, i), viewpoint.light);
        EXPECT_NEAR(org(shadow, i).y + dir(shadow, i).y, 0.0f, 1e-5f);
        EXPECT_LT(shadow.t_max[i], 1.0f);
    }
    std::vector<uint8_t> occluded(shadow.size());
    query.any_hits(shadow.batch(0, shadow.size()), occluded.data());
    EXPECT_EQ(std::count(occluded.begin(), occluded.end(), 1), 0) << "nothing stands on the floor";
}

TEST_F(FloorRays, mirror_rays_leave_upwards_at_the_angle_of_arrival) {
    for (size_t i = 0; i < mirror.size(); ++i) {
        const Vector in = org(mirror, i) - viewpoint.camera.eye, out = dir(mirror, i);
        EXPECT_GT(org(mirror, i).y, 0.0f);
        EXPECT_NEAR(out.y, -in.y / length(in), 1e-4f);
        EXPECT_NEAR(out.x, in.x / length(in), 1e-4f);
        EXPECT_NEAR(length(out), 1.0f, 1e-6f);
    }
}

TEST_F(FloorRays, diffuse_rays_are_cosine_distributed_and_the_same_in_every_run) {
    double sum = 0.0;
    for (size_t i = 0; i < diffuse.size(); ++i) {
        EXPECT_GT(dir(diffuse, i).y, 0.0f);
        EXPECT_NEAR(length(dir(diffuse, i)), 1.0f, 1e-6f);
        sum += dir(diffuse, i).y;
    }
    // The mean cosine is 2/3, its standard deviation over n rays sqrt(1/18 n).
    const auto n = static_cast<double>(diffuse.size());
    EXPECT_NEAR(sum / n, 2.0 / 3.0, 5.0 * std::sqrt(1.0 / (18.0 * n)));
    EXPECT_EQ(make_ray_classes(*scene, query, viewpoint, size_px)[3].dir_x, diffuse.dir_x);
}

TEST_F(FloorRays, a_mesh_fills_four_fifths_of_the_height_or_all_of_the_width) {
    const Camera &camera = viewpoint.camera;
    const auto dot = [](const Vector &a, const Vector &b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const Vector centre = camera.top_left + (camera.right + camera.down) * 0.5f - camera.eye;
    float widest = 0.0f, highest = 0.0f;
    for (const Point &position : scene->surface_mesh(0)->positions) {
        const Vector p = position - camera.eye;
        const Vector on_window = p * (dot(centre, centre) / dot(p, centre)) - centre;
        widest = std::max(widest, std::abs(2.0f * dot(on_window, camera.right) / dot(camera.right, camera.right)));
        highest = std::max(highest, std::abs(2.0f * dot(on_window, camera.down) / dot(camera.down, camera.down)));
    }
    EXPECT_NEAR(std::max(widest, highest / 0.8f), 1.0f, 1e-5f);
}

TEST(FindPeer, an_unknown_peer_is_refused_with_those_there_are) {
    const auto peer = find_peer("povray");
    ASSERT_FALSE(peer.ok());
    EXPECT_EQ(peer.error().code, ErrorCode::bad_input);
    EXPECT_NE(peer.error().text().find("embree"), std::string::npos);
}

TEST(ComparisonReport, a_picture_that_is_another_one_is_shouted_about) {
    FrameCell cell{};
    cell.width_px = cell.height_px = 100;
    cell.glint_ms.median = 2.0;
    cell.peer_ms.median = 3.0;
    cell.difference = {.pixels = 10000, .differing = 10, .largest = 9};
    FrameReport report;
    report.comparison.cells = {cell};
    EXPECT_NE(to_text(report).find("1.50x"), std::string::npos) << to_text(report);
    EXPECT_EQ(to_text(report).find("ANOTHER"), std::string::npos) << to_text(report);
    report.comparison.cells[0].difference.differing = 11;
    EXPECT_NE(to_text(report).find("ANOTHER"), std::string::npos) << to_text(report);
    EXPECT_NE(to_json(report).find("\"same_picture\": false"), std::string::npos) << to_json(report);
}

} // namespace
} // namespace glint::bench
