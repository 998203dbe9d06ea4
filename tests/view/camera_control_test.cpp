// The camera that a person moves, by algebra.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <glint/camera_control.hpp>

#include "scene/camera_check.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "view/scene_bounds.hpp"

namespace glint::test {
namespace {

std::shared_ptr<const Scene> scene_with(const Camera &camera, Mesh mesh = cube()) {
    SceneBuilder builder;
    PictureSettings picture;
    picture.width_px = 320;
    picture.height_px = 200;
    builder.add_object({"thing", std::make_shared<const Mesh>(std::move(mesh)), {}});
    auto scene = builder.set_camera(camera).set_picture(picture).build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return *scene;
}

struct Start {
    const char *name;
    Camera camera;
    Mesh mesh = cube();
};

/// Cameras of all kinds that scenes have.
std::vector<Start> starts() {
    Camera skewed = Camera::look_at({3, 4, 5}, {0, 0, 0}, {0, 0, 1}, 1.0f, 0.7f);
    skewed.right += skewed.down * 0.3f;
    return {
        {"SDL", Camera::through_window({0, 0, 5.7f}, -1, -1, 1, 1)},
        {"SDL, off the axis", Camera::through_window({1.5f, 2, 6}, -2, -1, 1.5f, 1)},
        {"SDL, from behind", Camera::through_window({0.3f, 0, -7}, 1, -1, -1, 1)},
        {"slanting", Camera::look_at({5, 3, -4}, {0.2f, 0, 0}, {0, 1, 0}, 1.2f, 0.8f)},
        {"z upwards", Camera::look_at({5, 6, 3}, {0, 0, 0}, {0, 0, 1}, 1.6f, 0.9f)},
        {"rolled", Camera::look_at({0, 2, 6}, {0, 0, 0}, {0.5f, 1, 0}, 1.0f, 1.0f)},
        {"from above", Camera::look_at({0, 8, 0}, {0, 0, 0}, {0, 0, -1}, 1.0f, 1.0f)},
        {"skewed", skewed},
        {"inside", Camera::look_at({0.2f, 0.1f, 0}, {0.5f, 0.1f, -1}, {0, 1, 0}, 1.5f, 1.0f)},
        {"looking away", Camera::look_at({0, 0, 6}, {0, 0, 9}, {0, 1, 0}, 1.0f, 1.0f)},
        {"far away", Camera::look_at({4e3f, 2, 4e3f + 9}, {4e3f, 0, 4e3f}, {0, 1, 0}, 1, 1),
         moved(cube(), {4e3f, 0, 4e3f})},
    };
}

bool same_bits(const Camera &a, const Camera &b) {
    return a.eye == b.eye && a.top_left == b.top_left && a.right == b.right && a.down == b.down;
}

/// Where a camera's picture shows a point.
glm::dvec2 seen_at(const Camera &camera, const glm::dvec3 &point) {
    const glm::dmat3 window = {glm::dvec3(camera.top_left) - glm::dvec3(camera.eye), camera.right, camera.down};
    const glm::dvec3 q = glm::inverse(window) * (point - glm::dvec3(camera.eye));
    return {q.y / q.x, q.z / q.x};
}

/// The place at a distance from the eye, under the cursor.
glm::dvec3 place_at(const CameraControl &control, glm::dvec2 cursor, double distance) {
    return control.eye() + control.direction_to(cursor) * distance;
}

void expect_near(const glm::dvec3 &a, const glm::dvec3 &b, double within, const char *what) {
    EXPECT_LE(glm::length(a - b), within) << what;
}
void expect_near(const glm::dvec2 &a, const glm::dvec2 &b, double within, const char *what) {
    EXPECT_LE(glm::length(a - b), within) << what;
}

/// A tenth of a pixel. Nearer than that no camera far from the origin can be told: its eye is three floats.
constexpr double of_window = 1e-4;

TEST(CameraControl, begins_with_the_scenes_camera_to_the_bit_and_comes_back_to_it) {
    for (const Start &start : starts()) {
        CameraControl control(scene_with(start.camera, start.mesh));
        EXPECT_TRUE(same_bits(control.camera(), start.camera)) << start.name;
        control.orbit({0.1, 0.2});
        control.zoom({0.3, 0.4}, 0.5);
        control.pan({0.5, 0.5}, {0.6, 0.1});
        control.fly({1, 2, 3}, 0.1);
        EXPECT_FALSE(same_bits(control.camera(), start.camera)) << start.name;
        control.resize(640, 400);
        control.reset();
        EXPECT_TRUE(same_bits(control.camera(), start.camera)) << start.name;
    }
}

TEST(CameraControl, keeps_the_place_under_the_cursor_when_it_zooms) {
    for (const Start &start : starts()) {
        for (const std::optional<double> distance : {std::optional<double>(), std::optional<double>(3.0)}) {
            CameraControl control(scene_with(start.camera, start.mesh));
            control.orbit({0.03, -0.02});
            const glm::dvec2 cursor(0.3, 0.8);
            for (const double factor : {0.9, 0.5, 0.99, 3.0, 1.7}) {
                const double pivot_distance = glm::length(control.pivot() - control.eye());
                const glm::dvec2 pivot_place = control.place_of(control.pivot()).value();
                const glm::dvec3 place = place_at(control, cursor, distance.value_or(pivot_distance));
                control.zoom(cursor, factor, distance);
                expect_near(seen_at(control.camera(), place), cursor, of_window, start.name);
                EXPECT_NEAR(glm::length(control.pivot() - control.eye()), factor * pivot_distance,
                            1e-6 * pivot_distance);
                expect_near(control.place_of(control.pivot()).value(), pivot_place, 1e-6, start.name);
                if (distance) {
                    EXPECT_NEAR(glm::length(place - control.eye()), factor * *distance, 1e-6);
                }
            }
        }
    }
}

TEST(CameraControl, drags_the_place_under_the_cursor_along) {
    for (const Start &start : starts()) {
        for (const std::optional<double> distance : {std::optional<double>(), std::optional<double>(2.5)}) {
            CameraControl control(scene_with(start.camera, start.mesh));
            control.orbit({-0.05, 0.04});
            const glm::dvec2 from(0.2, 0.7), to(0.9, 0.35);
            // The pivot lies in the plane that is dragged.
            const glm::dvec3 place = distance ? place_at(control, from, *distance) : control.pivot();
            const glm::dvec2 before = control.place_of(place).value();
            control.pan(from, to, distance);
            expect_near(seen_at(control.camera(), place), before + (to - from), of_window, start.name);
        }
    }
}

TEST(CameraControl, keeps_its_distance_and_the_pivots_place_when_it_orbits) {
    for (const Start &start : starts()) {
        CameraControl control(scene_with(start.camera, start.mesh));
        const double distance = glm::length(control.eye() - control.pivot());
        const glm::dvec2 place = control.place_of(control.pivot()).value();
        Random random(5);
        for (int i = 0; i < 200; ++i) {
            control.orbit({random.uniform(-1, 1), random.uniform(-0.5f, 0.5f)});
            EXPECT_NEAR(glm::length(control.eye() - control.pivot()), distance, 1e-9 * (1.0 + distance)) << start.name;
            expect_near(control.place_of(control.pivot()).value(), place, 1e-8, start.name);
            expect_near(seen_at(control.camera(), control.pivot()), place, of_window, start.name);
        }
    }
}

TEST(CameraControl, orbits_as_far_in_many_small_steps_as_in_a_large_one) {
    for (const Start &start : starts()) {
        CameraControl small(scene_with(start.camera, start.mesh)), large = small;
        const glm::dvec2 drag(0.7, -0.1);
        for (int i = 0; i < 1000; ++i) small.orbit(drag / 1000.0);
        large.orbit(drag);
        expect_near(small.eye(), large.eye(), 1e-7, start.name);
        expect_near(small.direction_to({0.1, 0.9}), large.direction_to({0.1, 0.9}), 1e-10, start.name);
    }
}

TEST(CameraControl, turns_things_the_way_they_are_dragged) {
    CameraControl control(scene_with(Camera::through_window({0, 0, 6}, -1, -1, 1, 1)));
    const glm::dvec3 front(0, 0, 1);
    control.orbit({0.05, 0.0});
    EXPECT_GT(control.place_of(front)->x, 0.51) << "to the right";
    control.reset();
    control.orbit({0.0, 0.05});
    EXPECT_GT(control.place_of(front)->y, 0.51) << "downwards";
    EXPECT_GT(control.eye().y, 0.0);
    control.reset();
    control.orbit({1.0, 0.0});
    expect_near(control.eye(), {0, 0, 6}, 1e-9, "the whole width is a turn");
    control.orbit({0.0, 0.25});
    EXPECT_NEAR(control.eye().y, 6 * std::sqrt(0.5), 1e-9) << "a quarter of the height is an eighth of a turn";
}

TEST(CameraControl, stops_short_of_the_poles_and_stays_upright) {
    for (const double way : {1.0, -1.0}) {
        CameraControl control(scene_with(Camera::through_window({0, 0, 6}, -1, -1, 1, 1)));
        for (int i = 0; i < 100; ++i) {
            control.orbit({0.01, way * 0.037});
            const Camera camera = control.camera();
            EXPECT_FALSE(camera_problem(camera));
            EXPECT_LT(camera.down.y, 0.0f) << "never upside down";
            EXPECT_NEAR(camera.right.y, 0.0f, 1e-6f) << "never rolled";
        }
        EXPECT_NEAR(std::atan2(std::hypot(control.eye().x, control.eye().z), way * control.eye().y), 3.14159265 / 180,
                    1e-6);
        control.orbit({0.0, -way * 0.5});
        EXPECT_NEAR(control.eye().y, -6 * way * std::sin(3.14159265 / 180), 1e-6) << "and comes back at once";
    }
}

TEST(CameraControl, comes_as_near_as_you_like_and_never_through) {
    CameraControl control(scene_with(Camera::through_window({0, 0, 6}, -1, -1, 1, 1)));
    const glm::dvec3 ahead = control.direction_to({0.5, 0.5});
    for (int i = 0; i < 2000; ++i) control.zoom({0.5, 0.5}, 0.5);
    const glm::dvec3 left = control.pivot() - control.eye();
    EXPECT_GT(glm::dot(left, ahead), 0.0);
    EXPECT_NEAR(glm::length(left), 1e-5 * control.scene_radius(), 1e-9);
    for (int i = 0; i < 2000; ++i) control.zoom({0.5, 0.5}, 2.0);
    EXPECT_NEAR(glm::length(control.pivot() - control.eye()), 1e3 * control.scene_radius(), 1e-3);
    control.zoom({0.5, 0.5}, 1e-300);
    EXPECT_GT(glm::length(control.pivot() - control.eye()), 0.0);
}

TEST(CameraControl, frames_the_whole_scene_and_wastes_nothing) {
    constexpr double margin = CameraControl::frame_margin;
    for (const Start &start : starts()) {
        for (const glm::uvec2 size : {glm::uvec2(320, 200), glm::uvec2(1000, 200), glm::uvec2(200, 900)}) {
            const auto scene = scene_with(start.camera, start.mesh);
            CameraControl control(scene);
            control.resize(size.x, size.y);
            control.fly({2, 5, -3}, 1.0);
            control.orbit({0.13, 0.07});
            const glm::dvec3 looks = control.direction_to({0.4, 0.3});
            control.frame();
            expect_near(control.direction_to({0.4, 0.3}), looks, 1e-9, "it only moves");

            const Box bounds = bounds_of_objects(*scene);
            glm::dvec2 least(9.0), greatest(-9.0);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p(corner & 1 ? bounds.hi.x : bounds.lo.x, corner & 2 ? bounds.hi.y : bounds.lo.y,
                                   corner & 4 ? bounds.hi.z : bounds.lo.z);
                ASSERT_TRUE(control.place_of(p).has_value()) << start.name << ": in front of the eye";
                const glm::dvec2 place = seen_at(control.camera(), p);
                least = glm::min(least, place);
                greatest = glm::max(greatest, place);
            }
            EXPECT_GE(std::min(least.x, least.y), margin - of_window) << start.name;
            EXPECT_LE(std::max(greatest.x, greatest.y), 1.0 - margin + of_window) << start.name;
            const glm::dvec2 extent = greatest - least;
            EXPECT_NEAR(std::max(extent.x, extent.y), 1.0 - 2.0 * margin, 2.0 * of_window) << start.name;
            expect_near(control.pivot(), 0.5 * (glm::dvec3(bounds.lo) + glm::dvec3(bounds.hi)), 1e-9, start.name);
        }
    }
}

TEST(CameraControl, keeps_what_is_seen_from_top_to_bottom_when_the_window_changes) {
    for (const Start &start : starts()) {
        CameraControl control(scene_with(start.camera, start.mesh));
        control.resize(640, 400);
        EXPECT_TRUE(same_bits(control.camera(), start.camera)) << "the same shape";
        const glm::dvec3 left_edge = control.direction_to({0.0, 0.5}), top = control.direction_to({0.5, 0.0}),
                         bottom = control.direction_to({0.5, 1.0});
        control.resize(1280, 400); // twice as wide: half as much again on either side
        const Camera wide = control.camera();
        EXPECT_FALSE(camera_problem(wide));
        expect_near(control.direction_to({0.25, 0.5}), left_edge, 1e-12, start.name);
        expect_near(control.direction_to({0.5, 0.0}), top, 1e-12, start.name);
        expect_near(control.direction_to({0.5, 1.0}), bottom, 1e-12, start.name);
        const glm::dvec3 place = place_at(control, {0.25, 0.5}, 4.0);
        expect_near(seen_at(wide, place), {0.25, 0.5}, of_window, start.name);
        control.resize(320, 200);
        EXPECT_TRUE(same_bits(control.camera(), start.camera)) << start.name;
    }
}

TEST(CameraControl, is_made_for_the_size_it_is_told) {
    const Camera camera = Camera::through_window({0, 0, 6}, -1, -1, 1, 1);
    CameraControl control(scene_with(camera), 512, 512);
    EXPECT_TRUE(same_bits(control.camera(), camera));
    control.resize(256, 256);
    EXPECT_TRUE(same_bits(control.camera(), camera));
    control.resize(1024, 512);
    EXPECT_FLOAT_EQ(control.camera().right.x, 4.0f);
    EXPECT_FLOAT_EQ(control.camera().top_left.x, -2.0f);
}

TEST(CameraControl, flies_in_scene_radii_a_second) {
    CameraControl control(scene_with(Camera::through_window({0, 0, 6}, -1, -1, 1, 1)));
    EXPECT_NEAR(control.scene_radius(), std::sqrt(3.0), 1e-6);
    const double step = control.scene_radius() * 0.5;
    control.fly({0, 0, 1}, 0.5);
    expect_near(control.eye(), {0, 0, 6 - step}, 1e-9, "ahead");
    control.fly({1, 0, 0}, 0.25);
    control.fly({1, 0, 0}, 0.25);
    expect_near(control.eye(), {step, 0, 6 - step}, 1e-9, "to the right");
    control.fly({0, 2, 0}, 0.25);
    expect_near(control.eye(), {step, step, 6 - step}, 1e-9, "upwards");
    expect_near(control.pivot(), {step, step, -step}, 1e-9, "and takes the pivot along");
}

TEST(CameraControl, knows_bounds_of_ellipsoids_and_does_without_bounds_of_planes) {
    SceneBuilder builder;
    Object ball{"ball", nullptr, {}, Quadric{1, 1, 1, 0, 0, 0, -3, 0, 0, 5}}; // radius 2 around (3, 0, 0)
    Object plane{"plane", nullptr, {}, Quadric{0, 0, 0, 0, 0, 0, 0, 0.5f, 0, 4}};
    builder.add_object(ball).add_object(plane);
    CameraControl control(*builder.build());
    EXPECT_NEAR(control.scene_radius(), 2.0 * std::sqrt(3.0), 1e-3);

    builder.add_object(plane);
    CameraControl unbounded(*builder.build());
    const glm::dvec3 eye = unbounded.eye();
    EXPECT_NEAR(unbounded.scene_radius(), 5.7, 1e-5);
    unbounded.frame();
    EXPECT_EQ(unbounded.eye(), eye);
    unbounded.orbit({0.1, 0.1});
    unbounded.zoom({0.1, 0.1}, 0.5);
    EXPECT_FALSE(camera_problem(unbounded.camera()));
}

TEST(CameraControl, always_has_a_camera_that_can_see_whatever_is_done_to_it) {
    const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const double odd[] = {0.0, 1.0, -1.0, 0.5, 1e-300, 1e-12, 1e6, -1e6, 1e15, 1e300, infinite, -infinite, nan};
    std::vector<Start> all = starts();
    all.push_back({"huge", Camera::look_at({0, 0, 5e11f}, {0, 0, 0}, {0, 1, 0}, 1, 1), [] {
                       Mesh mesh = cube();
                       for (Point &p : mesh.positions) p *= 9e11f;
                       return mesh;
                   }()});
    all.push_back({"tiny", Camera::look_at({0, 0, 5e-6f}, {0, 0, 0}, {0, 1, 0}, 1, 1), [] {
                       Mesh mesh = cube();
                       for (Point &p : mesh.positions) p *= 1e-6f;
                       return mesh;
                   }()});
    for (const Start &start : all) {
        Random random(11);
        CameraControl control(scene_with(start.camera, start.mesh));
        for (int i = 0; i < 5000; ++i) {
            const auto number = [&] {
                return random.below(6) == 0 ? odd[random.below(std::size(odd))] : double(random.uniform(-2, 2));
            };
            const auto distance = [&] { return random.below(2) == 0 ? std::optional<double>() : number(); };
            switch (random.below(16)) {
            case 0:
                control.reset();
                break;
            case 1:
                control.frame();
                break;
            case 2:
                control.resize(random.below(3) == 0 ? random.next() : random.below(2000), random.below(2000));
                break;
            case 3:
            case 4:
            case 5:
                control.zoom({number(), number()}, number(), distance());
                break;
            case 6:
            case 7:
                control.pan({number(), number()}, {number(), number()}, distance());
                break;
            case 8:
            case 9:
                control.fly({number(), number(), number()}, number());
                break;
            default:
                control.orbit({number(), number()});
            }
            const auto problem = camera_problem(control.camera());
            ASSERT_FALSE(problem) << start.name << ", move " << i << ": " << *problem;
            ASSERT_TRUE(std::isfinite(glm::length(control.pivot() - control.eye()))) << start.name;
        }
    }
}

} // namespace
} // namespace glint::test
