// Whether ray trees are true: that they add up to their pixels, and that their rays hang together.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <glint/glint.hpp>

#include "math/vec.hpp"

namespace glint::test {

inline RayTree tree_of(const Accel &accel, const RenderOptions &options, const Framebuffer &picture, uint32_t x,
                       uint32_t y) {
    Result<RayTree> tree = trace_ray_tree(accel, options, picture.width_px(), picture.height_px(), x, y);
    if (!tree) throw std::runtime_error(tree.error().text());
    return std::move(tree).value();
}

/// The sum that RayTree promises.
inline Color sum_of(const RayTree &tree) {
    Color sum(0.0f);
    for (const TracedRay &ray : tree.rays) {
        for (int channel = 0; channel < 3; ++channel) sum[channel] += ray.local_weight * ray.local_color[channel];
    }
    return sum * (1.0f / static_cast<float>(tree.samples));
}

inline void expect_near(const Color &a, const Color &b, float tolerance, const char *what) {
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(a[channel], b[channel], tolerance * (1.0f + std::abs(b[channel]))) << what << ' ' << channel;
    }
}

inline void expect_is_the_pixel(const RayTree &tree, const Framebuffer &picture) {
    const size_t pixel = size_t{tree.y} * picture.width_px() + tree.x;
    const Color sum = sum_of(tree);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(sum[channel], picture.radiance()[pixel * 3 + channel]) << channel;
        EXPECT_EQ(tree.color[channel], picture.radiance()[pixel * 3 + channel]) << channel;
    }
    for (int channel = 0; channel < 4; ++channel) {
        EXPECT_EQ(tree.rgba8[channel], picture.rgba8()[pixel * 4 + channel]) << channel;
    }
}

inline void expect_names(const TracedRay &ray, const Scene &scene) {
    if (ray.target == RayTarget::background) {
        EXPECT_EQ(ray.target_name, "");
        EXPECT_EQ(ray.distance, std::numeric_limits<float>::infinity());
    } else if (ray.target == RayTarget::object) {
        ASSERT_LT(ray.target_index, scene.objects().size());
        EXPECT_EQ(ray.target_name, scene.objects()[ray.target_index].name);
    } else {
        ASSERT_LT(ray.target_index, scene.lights().size());
        EXPECT_EQ(ray.target_name, scene.lights()[ray.target_index].name);
    }
}

/// Whether of two rays from the same place the first is told first.
inline bool comes_before(RayKind first, RayKind second) {
    if (first == RayKind::shadow) return true;
    return first == RayKind::mirror && second == RayKind::transmitted;
}

/// What leaves a hit begins near it, and is told right after it: shadow rays, the mirrored ray, the transmitted one.
inline void expect_follows_from_its_parent(const RayTree &tree, uint32_t index, bool glass_lets_light_through) {
    const TracedRay &ray = tree.rays[index];
    ASSERT_LT(ray.parent, index);
    const TracedRay &parent = tree.rays[ray.parent];
    EXPECT_NE(parent.kind, RayKind::shadow);
    EXPECT_EQ(parent.target, RayTarget::object);
    EXPECT_EQ(ray.sample, parent.sample);
    EXPECT_EQ(ray.level, parent.level + 1);
    EXPECT_LE(ray.level, tree.max_depth + (ray.kind == RayKind::shadow ? 1 : 0));
    const Point met = parent.origin + parent.direction * parent.distance;
    const float scale = 1.0f + std::abs(met.x) + std::abs(met.y) + std::abs(met.z) + parent.distance;
    expect_near(ray.origin, met, 1e-4f * scale, "where a ray begins");
    for (uint32_t between = ray.parent + 1; between < index; ++between) {
        EXPECT_GT(tree.rays[between].level, parent.level);
        if (tree.rays[between].parent != ray.parent) continue;
        EXPECT_TRUE(comes_before(tree.rays[between].kind, ray.kind)) << ray_kind_name(ray.kind);
    }
    if (ray.kind != RayKind::shadow) {
        EXPECT_LE(ray.weight, parent.weight);
        EXPECT_EQ(ray.light, no_light);
        return;
    }
    EXPECT_EQ(ray.weight, parent.local_weight);
    EXPECT_EQ(ray.local_weight, 0.0f);
    EXPECT_TRUE(ray.light_share >= 0.0f && ray.light_share <= 1.0f);
    const bool ends_at_its_light = ray.target == RayTarget::light && ray.target_index == ray.light;
    EXPECT_EQ(ray.light_share == 1.0f, ends_at_its_light);
    EXPECT_TRUE(!ends_at_its_light || ray.light_name == ray.target_name);
    if (ray.light_share == 0.0f) {
        EXPECT_EQ(ray.local_color, Color(0.0f));
    }
    EXPECT_TRUE(glass_lets_light_through || ray.light_share == 0.0f || ray.light_share == 1.0f);
    for (int channel = 0; channel < 3; ++channel) EXPECT_LE(ray.local_color[channel], parent.local_color[channel]);
}

/// A surface without texture shows its ambient light and what its shadow rays bring, to the last bit.
inline void expect_light_adds_up(const RayTree &tree, uint32_t index, const Scene &scene) {
    const TracedRay &ray = tree.rays[index];
    if (ray.kind == RayKind::shadow || ray.target != RayTarget::object || !(ray.local_weight > 0.0f)) return;
    const Material &material = scene.objects()[ray.target_index].material;
    if (material.texture) return;
    Color sum = material.color * (material.ambient * scene.ambient());
    for (uint32_t i = index + 1; i < tree.rays.size() && tree.rays[i].kind == RayKind::shadow; ++i) {
        sum += tree.rays[i].local_color;
    }
    EXPECT_EQ(sum, ray.local_color);
}

inline void expect_makes_sense(const RayTree &tree, const Scene &scene) {
    uint32_t primaries = 0;
    Color brought(0.0f);
    for (uint32_t i = 0; i < tree.rays.size(); ++i) {
        const TracedRay &ray = tree.rays[i];
        expect_names(ray, scene);
        expect_light_adds_up(tree, i, scene);
        EXPECT_NEAR(dot(ray.direction, ray.direction), 1.0f, 1e-5f);
        EXPECT_GE(ray.distance, 0.0f);
        EXPECT_LE(ray.local_weight, ray.weight);
        if (ray.parent == no_ray) {
            EXPECT_EQ(ray.kind, RayKind::primary);
            EXPECT_EQ(ray.weight, 1.0f);
            EXPECT_EQ(ray.level, 0u);
            EXPECT_EQ(ray.sample, primaries++);
            brought += ray.contribution;
        } else {
            EXPECT_NE(ray.kind, RayKind::primary);
            expect_follows_from_its_parent(tree, i, scene.optics().shadows_through_glass);
        }
    }
    EXPECT_EQ(primaries, tree.samples);
    expect_near(brought * (1.0f / static_cast<float>(tree.samples)), tree.color, 1e-4f, "contributions");
}

/// About so many pixels, spread over the picture.
inline void check_pixels(const std::shared_ptr<const Accel> &accel, const Framebuffer &picture,
                         const RenderOptions &options, uint32_t count) {
    const uint64_t all = uint64_t{picture.width_px()} * picture.height_px();
    const uint64_t step = std::max<uint64_t>(1, all / count) | 1;
    for (uint64_t i = 0; i < all && !testing::Test::HasFailure(); i += step) {
        const auto x = static_cast<uint32_t>(i % picture.width_px()), y = static_cast<uint32_t>(i / picture.width_px());
        SCOPED_TRACE("pixel " + std::to_string(x) + "," + std::to_string(y));
        const RayTree tree = tree_of(*accel, options, picture, x, y);
        expect_is_the_pixel(tree, picture);
        expect_makes_sense(tree, accel->scene());
    }
}

inline Framebuffer picture_of(Renderer &renderer, const RenderOptions &options, uint32_t width, uint32_t height) {
    Result<Framebuffer> picture = Framebuffer::create(width, height);
    if (!picture) throw std::runtime_error(picture.error().text());
    const auto done = renderer.render(*picture, options);
    if (!done) throw std::runtime_error(done.error().text());
    return std::move(picture).value();
}

} // namespace glint::test
