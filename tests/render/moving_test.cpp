// Scenes with objects that move: they look as scenes do whose meshes were moved before they were built.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/picture.hpp"
#include "support/random.hpp"

namespace glint::test {
namespace {

#ifdef GLINT_SANITIZED // every triangle is asked by every ray
constexpr uint32_t width = 48, height = 36, depth = 4;
#else
constexpr uint32_t width = 96, height = 72, depth = 4;
#endif

/// Everything that shading asks of a surface.
std::shared_ptr<const Mesh> smooth_and_textured_ball() {
    Mesh ball = icosphere(2);
    for (const Point &p : ball.positions) {
        ball.normals.push_back(p);
        ball.texcoords.push_back({p.x, p.y});
    }
    ball.normal_corners = ball.texcoord_corners = ball.triangles;
    return std::make_shared<const Mesh>(std::move(ball));
}

std::shared_ptr<const Texture> checks() {
    auto texture = std::make_shared<Texture>();
    texture->width_px = texture->height_px = 2;
    texture->texels = {{1, 0.5f, 0.5f}, {0.5f, 1, 0.5f}, {0.5f, 0.5f, 1}, {1, 1, 1}};
    return texture;
}

Material matt() {
    return {{0.9f, 0.8f, 0.7f}, 0.2f, 0.8f, 0.0f, 0.0f, 0.0f, 0.0f};
}
Material mirror() {
    return {{0.7f, 0.8f, 0.9f}, 0.2f, 0.5f, 0.3f, 20.0f, 0.4f, 0.0f};
}
Material glass() {
    Material glass{{0.3f, 0.8f, 0.9f}, 0.1f, 0.4f, 0.2f, 9.0f, 0.2f, 0.6f};
    glass.ior = 1.4f;
    return glass;
}

/// Objects around the origin, of about a unit's size.
std::vector<Object> bodies() {
    const auto shared = [](Mesh mesh) { return std::make_shared<const Mesh>(std::move(mesh)); };
    const auto ball = smooth_and_textured_ball();
    Material textured = matt();
    textured.texture = checks();
    std::vector<Object> all{{"torus", shared(torus(24, 12)), mirror()},
                            {"ball", ball, textured},
                            {"cube", shared(cube()), glass()},
                            {"bent", shared(soup(40)), matt()},
                            {"ball again", ball, mirror()},
                            {"egg", nullptr, matt()},
                            {"sphere", nullptr, glass()}};
    all[5].quadric = Quadric{1, 4, 9, 0, 0, 0, 0, 0, 0, -1};
    all[6].quadric = Quadric{1, 1, 1, 0, 0, 0, 0.25f, 0, 0, -1};
    return all;
}

RigidTransform random_pose(Random &random, const Point &around, float within) {
    return RigidTransform::turned(random.direction(), random.uniform(-3.0f, 3.0f),
                                  random.in_box({-1, -1, -1}, {1, 1, 1}),
                                  around + random.in_box(Point(-within), Point(within)));
}

/// A pose for each body, in two rows before the camera.
std::vector<RigidTransform> random_poses(uint64_t seed) {
    std::vector<RigidTransform> poses;
    Random random(seed);
    for (size_t i = 0; i < bodies().size(); ++i) {
        const Point place(2.2f * static_cast<float>(i % 4) - 3.3f, i < 4 ? 1.2f : -1.2f, -4.0f);
        poses.push_back(random_pose(random, place, 0.4f));
    }
    return poses;
}

/// How the bodies are given to the builder.
enum class As {
    movers, ///< with their poses
    meshes, ///< moved beforehand, as far as floats allow; they never move
};

Point moved_point(const RigidTransform &pose, const Point &p) {
    const glm::dvec3 x(pose.x), y(pose.y), z(pose.z);
    return Point(x * double(p.x) + y * double(p.y) + z * double(p.z) + glm::dvec3(pose.translation));
}

Object moved_object(Object object, const RigidTransform &pose) {
    if (object.mesh) {
        auto mesh = std::make_shared<Mesh>(*object.mesh);
        RigidTransform turn = pose;
        turn.translation = Vector(0.0f);
        for (Point &p : mesh->positions) p = moved_point(pose, p);
        for (Vector &n : mesh->normals) n = moved_point(turn, n);
        object.mesh = mesh;
        return object;
    }
    // p.Mp + 2 v.p + k at R^T (p - t), in double.
    const Quadric &q = *object.quadric;
    const double m[3][3] = {{q.a, q.d, q.f}, {q.d, q.b, q.e}, {q.f, q.e, q.c}}, v[3] = {q.g, q.h, q.j};
    const double r[3][3] = {
        {pose.x.x, pose.y.x, pose.z.x}, {pose.x.y, pose.y.y, pose.z.y}, {pose.x.z, pose.y.z, pose.z.z}};
    const double t[3] = {pose.translation.x, pose.translation.y, pose.translation.z};
    double n[3][3] = {}, w[3] = {}, k = q.k;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < 3; ++b) n[i][j] += r[i][a] * m[a][b] * r[j][b];
            }
        }
        for (int a = 0; a < 3; ++a) w[i] += r[i][a] * v[a];
    }
    for (int i = 0; i < 3; ++i) {
        k -= 2.0 * w[i] * t[i];
        for (int j = 0; j < 3; ++j) k += t[i] * n[i][j] * t[j];
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) w[i] -= n[i][j] * t[j];
    }
    const auto f = [](double x) { return static_cast<float>(x); };
    object.quadric = Quadric{f(n[0][0]), f(n[1][1]), f(n[2][2]), f(n[0][1]), f(n[1][2]),
                             f(n[0][2]), f(w[0]),    f(w[1]),    f(w[2]),    f(k)};
    return object;
}

std::shared_ptr<const Scene> built(SceneBuilder &builder) {
    auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return *scene;
}

std::shared_ptr<const Scene> scene_of_bodies(As as, const std::vector<RigidTransform> &poses,
                                             const OpticsSettings &optics = {}) {
    SceneBuilder builder;
    const std::vector<Object> all = bodies();
    for (size_t i = 0; i < all.size(); ++i) {
        if (i == 2) { // something at rest between them, so that neither's numbers are in a row
            builder.add_object({"floor", std::make_shared<Mesh>(moved(flat_grid(6), {0, 0, -7})), mirror()});
            builder.add_object({"small", std::make_shared<Mesh>(moved(cube(), {0, -4, -5})), matt()});
        }
        Object object = as == As::movers ? all[i] : moved_object(all[i], poses[i]);
        if (as == As::movers) object.pose = poses[i];
        builder.add_object(std::move(object));
    }
    Light lamp{"lamp", std::make_shared<Mesh>(moved(cube(), {6, 9, 8})), Color(1.0f), 0.8f};
    Light sun;
    sun.kind = Light::Kind::directional;
    sun.direction = {1, -2, -3};
    sun.intensity = 0.4f;
    builder.add_light(lamp).add_light(sun).set_ambient(0.4f).set_background({0.1f, 0.1f, 0.3f}).set_optics(optics);
    builder.set_camera(Camera::look_at({0, 0, 4}, {0, 0, -4}, {0, 1, 0}, 1.2f, 0.9f));
    return built(builder);
}

std::vector<RigidTransform> at_rest() {
    return std::vector<RigidTransform>(bodies().size());
}

size_t differing_pixels(const Framebuffer &a, const Framebuffer &b, int tolerance) {
    size_t count = 0;
    for (size_t i = 0; i < size_t{width} * height; ++i) {
        int most = 0;
        for (size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(int{a.rgba8()[4 * i + c]} - b.rgba8()[4 * i + c]));
        count += most > tolerance ? 1 : 0;
    }
    return count;
}

constexpr AccelKind every_kind[] = {AccelKind::kdtree, AccelKind::bvh, AccelKind::brute};

TEST(MovingObjects, at_rest_give_the_bits_that_they_give_where_they_cannot_move) {
    for (const OpticsSettings &optics : {OpticsSettings{}, OpticsSettings{true, true}}) {
        const auto still = scene_of_bodies(As::meshes, at_rest(), optics);
        const auto resting = scene_of_bodies(As::movers, at_rest(), optics);
        const uint64_t expected = render(still, width, height, depth).radiance_hash();
        for (const Isa isa : available_isas()) {
            for (const AccelKind kind : every_kind) {
                EXPECT_EQ(render(Accel::build(resting, {kind, 1}), width, height, depth, {2, isa}).radiance_hash(),
                          expected)
                    << isa_name(isa) << ", " << accel_kind_name(kind);
            }
        }
    }
}

TEST(MovingObjects, look_as_meshes_that_were_moved_beforehand) {
    for (const uint64_t seed : {1u, 2u, 3u}) {
        const auto poses = random_poses(seed);
        const Framebuffer moving = render(scene_of_bodies(As::movers, poses), width, height, depth);
        const Framebuffer still = render(scene_of_bodies(As::meshes, poses), width, height, depth);
        // At outlines and in what mirrors show of them a ray may pass on the other side.
        EXPECT_LT(differing_pixels(moving, still, 1), width * height / 200u);
        EXPECT_LT(differing_pixels(moving, still, 0), width * height / 50u);
        EXPECT_GT(differing_pixels(moving, render(scene_of_bodies(As::movers, at_rest()), width, height, depth), 8),
                  width * height / 4u)
            << "the bodies hardly moved: nothing was tested";
    }
}

TEST(MovingObjects, look_the_same_with_every_kernel_tree_and_number_of_threads) {
    for (const OpticsSettings &optics : {OpticsSettings{}, OpticsSettings{true, true}}) {
        const auto scene = scene_of_bodies(As::movers, random_poses(4), optics);
        const uint64_t expected = render(Accel::build(scene), width, height, depth, {1, Isa::scalar}).radiance_hash();
        for (const Isa isa : available_isas()) {
            for (const AccelKind kind : every_kind) {
                for (const unsigned threads : {1u, 3u}) {
                    EXPECT_EQ(
                        render(Accel::build(scene, {kind, 1}), width, height, depth, {threads, isa}).radiance_hash(),
                        expected)
                        << isa_name(isa) << ", " << accel_kind_name(kind) << ", " << threads << " threads";
                }
            }
        }
    }
}

std::vector<ObjectPose> new_poses(const Scene &scene, const std::vector<RigidTransform> &poses) {
    std::vector<ObjectPose> all;
    size_t next = 0;
    for (uint32_t i = 0; i < scene.objects().size(); ++i) {
        if (scene.objects()[i].pose) all.push_back({i, poses[next++]});
    }
    return all;
}

TEST(MovingObjects, look_the_same_after_an_update_as_in_a_scene_built_there) {
    const auto first = scene_of_bodies(As::movers, random_poses(5));
    auto accel = Accel::build(first);
    Renderer renderer(accel, {.threads = 2});
    auto picture = Framebuffer::create(width, height);
    ASSERT_TRUE(picture);
    for (const uint64_t seed : {6u, 7u, 8u}) {
        const auto poses = random_poses(seed);
        const auto scene = with_poses(first, new_poses(*first, poses));
        ASSERT_TRUE(scene) << scene.error().text();
        accel = Accel::update(accel, *scene);
        EXPECT_EQ(&accel->scene(), scene->get());
        renderer.set_accel(accel);
        RenderOptions options;
        options.max_depth = depth;
        ASSERT_TRUE(renderer.render(*picture, options));
        EXPECT_EQ(picture->radiance_hash(),
                  render(scene_of_bodies(As::movers, poses), width, height, depth).radiance_hash());
    }
}

TEST(MovingObjects, an_update_to_another_scene_is_a_new_tree) {
    const auto first = Accel::build(scene_of_bodies(As::movers, random_poses(5)));
    const auto other = scene_of(torus(8, 8));
    const auto accel = Accel::update(first, other);
    EXPECT_EQ(accel->statistics().triangles, other->triangle_count());
    Renderer renderer(first, {.threads = 1});
    renderer.set_accel(accel);
    auto picture = Framebuffer::create(width, height);
    ASSERT_TRUE(renderer.render(*picture));
    EXPECT_EQ(picture->pixel_hash(), render(other, width, height, 1).pixel_hash());
}

TEST(MovingObjects, alone_make_a_scene) {
    SceneBuilder builder;
    Object torus_object{"torus", std::make_shared<Mesh>(torus(24, 12)), matt()};
    torus_object.pose = RigidTransform::turned({1, 2, 3}, 1.0);
    builder.add_object(torus_object).set_ambient(1.0f).set_background({0, 0, 1});
    Light lamp;
    lamp.kind = Light::Kind::point;
    lamp.position = Point(4, 4, 8);
    const auto scene = built(builder.add_light(lamp));
    for (const AccelKind kind : every_kind) {
        const auto accel = Accel::build(scene, {kind, 1});
        EXPECT_EQ(accel->statistics().triangles, scene->triangle_count());
        EXPECT_GE(accel->statistics().references, scene->triangle_count());
        const Framebuffer expected = render(accel, width, height, 1, {1, Isa::scalar});
        for (const Isa isa : available_isas()) {
            EXPECT_EQ(render(accel, width, height, 1, {1, isa}).radiance_hash(), expected.radiance_hash());
        }
        size_t background = 0;
        for (uint32_t i = 0; i < width * height; ++i)
            background += pixel(expected, i % width, i / width) == Color(0, 0, 1);
        EXPECT_GT(background, width * height / 10u);
        EXPECT_LT(background, width * height * 9u / 10u);
    }
}

/// Rays from all around the bodies, most towards them.
struct Rays {
    std::vector<float> values[7], t;
    std::vector<uint32_t> ids;

    explicit Rays(size_t count) : t(count), ids(count) {
        Random random(9);
        for (size_t i = 0; i < count; ++i) {
            const Point org = random.in_box({-7, -7, -12}, {7, 7, 6});
            const Vector dir = random.in_box({-4, -3, -6}, {4, 3, -2}) - org;
            const float row[] = {org.x, org.y, org.z, dir.x, dir.y, dir.z, i % 3 == 0 ? 0.9f : 1e30f};
            for (int k = 0; k < 7; ++k) values[k].push_back(row[k]);
        }
    }
    [[nodiscard]] RayBatch batch() const {
        const auto &v = values;
        return {t.size(), v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), v[5].data(), v[6].data()};
    }
    [[nodiscard]] HitBatch hits() { return {t.data(), ids.data()}; }
};

TEST(MovingObjects, are_hit_where_moved_meshes_are_hit) {
    const auto poses = random_poses(10);
    const auto moving = Accel::build(scene_of_bodies(As::movers, poses));
    const auto still = Accel::build(scene_of_bodies(As::meshes, poses));
    Rays found(20'000), expected(20'000);
    RayQuery(moving).closest_hits(found.batch(), found.hits());
    RayQuery(still).closest_hits(expected.batch(), expected.hits());
    size_t hits = 0, others = 0;
    for (size_t i = 0; i < found.t.size(); ++i) {
        if (found.ids[i] != expected.ids[i]) {
            ++others; // across an edge, or past an outline
            continue;
        }
        if (found.ids[i] == no_triangle) continue;
        ++hits;
        EXPECT_NEAR(found.t[i], expected.t[i], 1e-5f * expected.t[i] + 1e-6f) << "ray " << i;
    }
    EXPECT_GT(hits, found.t.size() / 3);
    EXPECT_LT(others, found.t.size() / 500);
}

TEST(MovingObjects, are_hit_by_every_kernel_where_the_definition_has_it) {
    const auto scene = scene_of_bodies(As::movers, random_poses(11));
    Rays expected(20'000);
    std::vector<uint8_t> expected_any(expected.t.size());
    const RayQuery oracle(Accel::build(scene, {AccelKind::brute}), Isa::scalar);
    oracle.closest_hits(expected.batch(), expected.hits());
    oracle.any_hits(expected.batch(), expected_any.data());
    for (const Isa isa : available_isas()) {
        for (const AccelKind kind : every_kind) {
            Rays found(expected.t.size());
            std::vector<uint8_t> any(found.t.size());
            const RayQuery query(Accel::build(scene, {kind, 1}), isa);
            query.closest_hits(found.batch(), found.hits());
            query.any_hits(found.batch(), any.data());
            EXPECT_EQ(found.ids, expected.ids) << isa_name(isa) << ", " << accel_kind_name(kind);
            EXPECT_EQ(std::memcmp(found.t.data(), expected.t.data(), found.t.size() * sizeof(float)), 0)
                << isa_name(isa) << ", " << accel_kind_name(kind);
            EXPECT_EQ(any, expected_any) << isa_name(isa) << ", " << accel_kind_name(kind);
        }
    }
}

TEST(MovingObjects, of_one_place_are_told_apart_by_their_order) {
    SceneBuilder builder;
    const auto mesh = std::make_shared<const Mesh>(torus(12, 8));
    for (int i = 0; i < 3; ++i) {
        Object object{"torus", mesh, matt()};
        if (i != 1) object.pose = RigidTransform{};
        builder.add_object(object);
    }
    const auto accel = Accel::build(built(builder));
    for (const Isa isa : available_isas()) {
        Rays rays(5'000);
        for (float &z : rays.values[5]) z += 4.0f; // towards the origin
        RayQuery(accel, isa).closest_hits(rays.batch(), rays.hits());
        size_t hits = 0;
        for (const uint32_t id : rays.ids) {
            if (id == no_triangle) continue;
            ++hits;
            ASSERT_LT(id, mesh->triangles.size());
        }
        EXPECT_GT(hits, 100u);
    }
}

/// The eye's own medium is found out in the object's space, wherever that stands.
TEST(MovingObjects, may_hold_the_eye) {
    const auto scene_at_offset = [](const Vector &by, bool moves) {
        SceneBuilder builder;
        Object ball{"ball", std::make_shared<Mesh>(icosphere(3)), glass()};
        ball.pose = RigidTransform{};
        ball.pose->translation = by;
        if (!moves) ball = moved_object(ball, *ball.pose), ball.pose.reset();
        Object wall{"wall", std::make_shared<Mesh>(moved(flat_grid(4), by + Vector(0, 0, -5))), matt()};
        builder.add_object(ball).add_object(wall).set_ambient(0.5f);
        Light lamp;
        lamp.kind = Light::Kind::point;
        lamp.position = by + Vector(3, 4, 8);
        builder.add_light(lamp).set_camera(
            Camera::look_at(by + Vector(0.2f, 0.1f, 0.3f), by + Vector(0, 0, -5), {0, 1, 0}, 1.2f, 0.9f));
        return built(builder);
    };
    const Framebuffer moving = render(scene_at_offset({8, 16, 4}, true), width, height, depth);
    const Framebuffer still = render(scene_at_offset({8, 16, 4}, false), width, height, depth);
    EXPECT_LT(differing_pixels(moving, still, 2), width * height / 100u);
}

} // namespace
} // namespace glint::test
