// Rays and quadrics: against the same equation in long double, and against fine meshes of the same shapes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include <glint/glint.hpp>

#include "kernel/quadric.hpp"
#include "scene/quadric_shape.hpp"
#include "support/random.hpp"

namespace glint::test {
namespace {

constexpr float everywhere = std::numeric_limits<float>::infinity();

PlacedQuadric placed(const Quadric &q, const Box &bounds) {
    return {q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.j, q.k, bounds, 0};
}

/// The left side of the equation along a ray: A t^2 + 2 B t + C.
struct Polynomial {
    long double a, b, c;

    Polynomial(const Quadric &q, const Ray &ray) {
        const long double o[3] = {ray.org.x, ray.org.y, ray.org.z}, d[3] = {ray.dir.x, ray.dir.y, ray.dir.z};
        const long double m[3][3] = {{q.a, q.d, q.f}, {q.d, q.b, q.e}, {q.f, q.e, q.c}}, g[3] = {q.g, q.h, q.j};
        a = b = 0.0L;
        c = q.k;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                a += d[i] * m[i][j] * d[j];
                b += d[i] * m[i][j] * o[j];
                c += o[i] * m[i][j] * o[j];
            }
            b += g[i] * d[i];
            c += 2.0L * g[i] * o[i];
        }
    }
    [[nodiscard]] long double discriminant() const { return b * b - a * c; }
    /// How much of the discriminant may be a double's rounding.
    [[nodiscard]] long double doubtful() const { return 1e-10L * (b * b + std::abs(a * c)); }
    /// The least root above 0, NaN where there is none.
    [[nodiscard]] long double least_root() const {
        if (discriminant() < 0.0L) return NAN;
        const long double q = -(b + std::copysign(std::sqrt(discriminant()), b));
        const long double one = q / a, other = c / q;
        long double least = NAN;
        for (const long double t : {one, other}) {
            if (t > 0.0L && t < 1e30L && !(least < t)) least = t;
        }
        return least;
    }
};

TEST(Quadrics, are_met_where_long_double_has_it) {
    Random random(4711);
    const Box all{glm::vec3(-everywhere), glm::vec3(everywhere)};
    const Box scene{glm::vec3(-100.0f), glm::vec3(100.0f)};
    int met = 0, missed = 0, doubtful = 0;
    for (int i = 0; i < 1000000; ++i) {
        // All shapes, planes and cylinders among them, from coefficients of very different sizes.
        const auto number = [&] {
            return random.below(4) == 0 ? 0.0f : random.uniform(-1, 1) * std::pow(10.0f, random.uniform(-2, 2));
        };
        const Quadric q{number(), number(), number(), number(), number(),
                        number(), number(), number(), number(), number()};
        const Ray ray{random.in_box(glm::vec3(-20.0f), glm::vec3(20.0f)), random.direction()};
        const Polynomial along(q, ray);
        const long double expected = along.least_root();
        const float t = quadric_distance(placed(q, all), PreparedRay(ray, scene));
        const bool is_doubtful = std::abs(along.discriminant()) <= along.doubtful() || std::abs(along.c) <= 1e-12L ||
                                 expected > 1e9L || std::abs(along.a) < 1e-12L;
        if (is_doubtful) {
            ++doubtful;
        } else if (std::isnan(expected)) {
            ++missed;
            ASSERT_TRUE(std::isnan(t)) << i << " found " << t;
        } else {
            ++met;
            ASSERT_NEAR(t, static_cast<double>(expected), 2e-7 * static_cast<double>(expected) + 1e-9) << i;
        }
    }
    EXPECT_GT(met, 300000);
    EXPECT_GT(missed, 200000);
    EXPECT_LT(doubtful, 50000);
}

/// A shape as a quadric and as a function of two parameters in [0, 1].
struct Shape {
    const char *name;
    Quadric quadric;
    std::function<glm::dvec3(double, double)> at;
};

constexpr double pi = 3.141592653589793;

std::vector<Shape> shapes() {
    const auto coefficients = [](float a, float b, float c, float j, float k) {
        Quadric q;
        q.a = a, q.b = b, q.c = c, q.j = j, q.k = k;
        return q;
    };
    return {
        {"sphere", coefficients(1, 1, 1, 0, -1),
         [](double u, double v) {
             return glm::dvec3(std::sin(pi * v) * std::cos(2 * pi * u), std::sin(pi * v) * std::sin(2 * pi * u),
                               std::cos(pi * v));
         }},
        {"ellipsoid", coefficients(1, 4, 0.25f, 0, -1),
         [](double u, double v) {
             return glm::dvec3(std::sin(pi * v) * std::cos(2 * pi * u), 0.5 * std::sin(pi * v) * std::sin(2 * pi * u),
                               2.0 * std::cos(pi * v));
         }},
        {"cylinder", coefficients(1, 1, 0, 0, -1),
         [](double u, double v) { return glm::dvec3(std::cos(2 * pi * u), std::sin(2 * pi * u), 8.0 * v - 4.0); }},
        {"cone", coefficients(1, 1, -1, 0, 0),
         [](double u, double v) {
             const double z = 8.0 * v - 4.0;
             return glm::dvec3(z * std::cos(2 * pi * u), z * std::sin(2 * pi * u), z);
         }},
        {"paraboloid", coefficients(1, 1, 0, -0.5f, 0),
         [](double u, double v) {
             return glm::dvec3(2 * v * std::cos(2 * pi * u), 2 * v * std::sin(2 * pi * u), 4 * v * v);
         }},
        {"hyperboloid", coefficients(1, 1, -1, 0, -1),
         [](double u, double v) {
             const double z = 6.0 * v - 3.0, r = std::sqrt(1.0 + z * z);
             return glm::dvec3(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), z);
         }},
    };
}

class QuadricAndMesh : public testing::TestWithParam<size_t> {};

std::shared_ptr<const Scene> scene_with(Object object) {
    SceneBuilder builder;
    builder.add_object(std::move(object));
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return *scene;
}

glm::vec3 gradient(const Quadric &q, const glm::vec3 &p) {
    return quadric_normal(placed(q, {}), p, glm::vec3(0.0f));
}

TEST_P(QuadricAndMesh, are_met_at_the_same_depth_with_the_same_normal) {
    const Shape shape = shapes()[GetParam()];
    constexpr uint32_t columns = 720, rows = 360;
    auto mesh = std::make_shared<Mesh>();
    for (uint32_t row = 0; row <= rows; ++row) {
        for (uint32_t column = 0; column <= columns; ++column) {
            mesh->positions.emplace_back(shape.at(double(column % columns) / columns, double(row) / rows));
        }
    }
    for (uint32_t row = 0; row < rows; ++row) {
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t i = row * (columns + 1) + column, below = i + columns + 1;
            mesh->triangles.push_back({i, i + 1, below});
            mesh->triangles.push_back({i + 1, below + 1, below});
        }
    }
    ASSERT_GT(mesh->triangles.size(), 100000u);
    Object quadric{"quadric", nullptr, {}};
    quadric.quadric = shape.quadric;
    const auto exact = Accel::build(scene_with(quadric)), cut = Accel::build(scene_with({"mesh", mesh, {}}));
    const Mesh &kept = *cut->scene().objects()[0].mesh; // without triangles that have no area

    constexpr size_t count = 4096;
    std::vector<float> org[3], dir[3], t_max(count, 1e30f), t_exact(count), t_cut(count);
    std::vector<uint32_t> id_exact(count), id_cut(count);
    Random random(GetParam() + 1);
    for (size_t i = 0; i < count; ++i) {
        // From outside towards the shape's middle, where the mesh has no ends.
        const glm::vec3 from = random.direction() * 9.0f;
        const glm::vec3 to =
            random.in_box(glm::vec3(-0.6f), glm::vec3(0.6f)) + glm::vec3(0, 0, GetParam() == 4 ? 1.5f : 0);
        const glm::vec3 way = (to - from) / 8.0f;
        for (int axis = 0; axis < 3; ++axis) {
            org[axis].push_back(from[axis]);
            dir[axis].push_back(way[axis]);
        }
    }
    const RayBatch rays{count,         org[0].data(), org[1].data(), org[2].data(),
                        dir[0].data(), dir[1].data(), dir[2].data(), t_max.data()};
    for (const Isa isa : available_isas()) {
        RayQuery(exact, isa).closest_hits(rays, {t_exact.data(), id_exact.data()});
        RayQuery(cut, isa).closest_hits(rays, {t_cut.data(), id_cut.data()});
        int compared = 0;
        for (size_t i = 0; i < count; ++i) {
            if (id_exact[i] == no_triangle || id_cut[i] == no_triangle) continue;
            const auto point = [&](float t) {
                return glm::vec3(org[0][i] + t * dir[0][i], org[1][i] + t * dir[1][i], org[2][i] + t * dir[2][i]);
            };
            const glm::vec3 p = point(t_exact[i]), d(dir[0][i], dir[1][i], dir[2][i]);
            const glm::vec3 n = gradient(shape.quadric, p);
            // Grazing rays and those that miss the mesh's end say nothing of the surface.
            const float slope = std::abs(dot(n, normalize(d)));
            if (slope < 0.2f || max_abs(point(t_cut[i])) > 2.9f || max_abs(p) > 2.9f) continue;
            ++compared;
            ASSERT_NEAR(t_exact[i] * std::sqrt(dot(d, d)), t_cut[i] * std::sqrt(dot(d, d)), 1e-3) << isa_name(isa);
            // The mesh's normal between its corners' own, as smooth shading has it.
            const Triangle &triangle = kept.triangles[id_cut[i]];
            const glm::vec3 corners[3] = {kept.positions[triangle.a], kept.positions[triangle.b],
                                          kept.positions[triangle.c]};
            glm::vec3 smooth(0.0f);
            const glm::vec3 at = point(t_cut[i]);
            float weights[3], sum = 0.0f;
            for (int k = 0; k < 3; ++k) {
                const glm::vec3 a = corners[(k + 1) % 3] - at, b = corners[(k + 2) % 3] - at;
                const glm::vec3 c(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
                weights[k] = std::sqrt(dot(c, c));
                sum += weights[k];
            }
            for (int k = 0; k < 3; ++k) smooth += gradient(shape.quadric, corners[k]) * (weights[k] / sum);
            const glm::vec3 difference = normalize(smooth) - n;
            ASSERT_LT(std::sqrt(dot(difference, difference)), 1e-3f) << isa_name(isa);
        }
        EXPECT_GT(compared, 500) << isa_name(isa);
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, QuadricAndMesh, testing::Range(size_t{0}, shapes().size()),
                         [](const auto &row) { return std::string(shapes()[row.param].name); });

TEST(QuadricTrees, find_what_asking_every_quadric_finds) {
    Random random(12);
    SceneBuilder builder;
    std::vector<Quadric> quadrics;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 c = random.in_box(glm::vec3(-10.0f), glm::vec3(10.0f));
        Quadric q;
        q.a = random.uniform(1, 20), q.b = random.uniform(1, 20), q.c = random.uniform(1, 20);
        q.d = random.uniform(-0.4f, 0.4f), q.e = random.uniform(-0.4f, 0.4f);
        q.g = -(q.a * c.x + q.d * c.y), q.h = -(q.d * c.x + q.b * c.y + q.e * c.z), q.j = -(q.e * c.y + q.c * c.z);
        q.k = -(q.g * c.x + q.h * c.y + q.j * c.z) - random.uniform(0.1f, 2.0f);
        if (i % 1000 == 0) q = {0, 0, 0, 0, 0, 0, 1, random.uniform(-1, 1), 0, random.uniform(5, 9)}; // planes
        ASSERT_FALSE(quadric_problem(q)) << i;
        Object object{"", nullptr, {}};
        object.quadric = q;
        quadrics.push_back(q);
        builder.add_object(object);
    }
    const auto scene = builder.build();
    ASSERT_TRUE(scene) << scene.error().text();
    const auto accel = Accel::build(*scene);
    EXPECT_EQ(accel->statistics().triangles, 0u);
    EXPECT_EQ(accel->statistics().sah_cost, 0.0);

    constexpr size_t count = 2048;
    std::vector<float> org[3], dir[3], t_max(count), t(count);
    std::vector<uint32_t> id(count);
    std::vector<uint8_t> occluded(count);
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 o = random.in_box(glm::vec3(-12.0f), glm::vec3(12.0f)), d = random.direction();
        for (int axis = 0; axis < 3; ++axis) {
            org[axis].push_back(o[axis]);
            dir[axis].push_back(i % 7 == 0 && axis == 1 ? 0.0f : d[axis]);
        }
        t_max[i] = i % 3 == 0 ? random.uniform(0.5f, 5.0f) : 1e30f;
    }
    const RayBatch rays{count,         org[0].data(), org[1].data(), org[2].data(),
                        dir[0].data(), dir[1].data(), dir[2].data(), t_max.data()};
    const Box bounds{glm::vec3(-20.0f), glm::vec3(20.0f)};

    // Asking every quadric takes far longer than asking the tree with every kernel.
    std::vector<float> nearest = t_max;
    std::vector<uint32_t> found(count, no_triangle);
    std::vector<uint8_t> is_blocked(count, 0);
    for (uint32_t k = 0; k < quadrics.size(); ++k) {
        const PlacedQuadric one = placed(quadrics[k], quadric_shape(quadrics[k]).bounds);
        for (size_t i = 0; i < count; ++i) {
            const PreparedRay ray({{org[0][i], org[1][i], org[2][i]}, {dir[0][i], dir[1][i], dir[2][i]}}, bounds);
            const float distance = quadric_distance(one, ray);
            if (distance < t_max[i]) is_blocked[i] = 1;
            if (distance < nearest[i] || (distance == nearest[i] && k < found[i])) {
                nearest[i] = distance;
                found[i] = k;
            }
        }
    }
    for (const Isa isa : available_isas()) {
        RayQuery(accel, isa).closest_hits(rays, {t.data(), id.data()});
        RayQuery(accel, isa).any_hits(rays, occluded.data());
        for (size_t i = 0; i < count; ++i) {
            ASSERT_EQ(t[i], nearest[i]) << isa_name(isa) << ' ' << i;
            ASSERT_EQ(id[i], found[i]) << isa_name(isa) << ' ' << i;
            ASSERT_EQ(occluded[i], is_blocked[i]) << isa_name(isa) << ' ' << i;
        }
    }
}

} // namespace
} // namespace glint::test
