// Which scenes are beside what peers can draw.
#include "bench/unsupported_feature.hpp"

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace glint::bench {
namespace {

/// The parts of a scene that a peer can draw, before a test changes one.
struct Parts {
    Object object;
    Light light;
    PictureSettings picture;
    OpticsSettings optics;

    Parts() {
        auto mesh = std::make_shared<Mesh>();
        mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh->triangles = {{0, 1, 2}};
        object = {"wall", mesh, {.reflection = 0.3f, .transmission = 0.3f}};
        light = {"lamp", mesh};
    }
};

struct Case {
    std::string feature; ///< empty where a peer can draw it
    std::function<void(Parts &)> change;
};

std::ostream &operator<<(std::ostream &out, const Case &one) {
    return out << (one.feature.empty() ? "what peers know" : one.feature);
}

class Features : public testing::TestWithParam<Case> {};

TEST_P(Features, that_peers_lack_are_named) {
    Parts parts;
    GetParam().change(parts);
    SceneBuilder builder;
    builder.add_object(parts.object).add_light(parts.light).set_picture(parts.picture).set_optics(parts.optics);
    const auto scene = builder.build();
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(unsupported_feature(**scene).value_or(""), GetParam().feature);
    const bool has_shape = GetParam().feature.starts_with("quadrics");
    EXPECT_EQ(unsupported_shape(**scene).value_or(""), has_shape ? GetParam().feature : "");
}

constexpr Quadric sphere{.a = 1, .b = 1, .c = 1, .k = -1};

INSTANTIATE_TEST_SUITE_P(
    Of, Features,
    testing::Values(
        Case{"", [](Parts &) {}}, Case{"", [](Parts &parts) { parts.light.position = Point(1, 2, 3); }},
        Case{"",
             [](Parts &parts) {
                 parts.object.material.transmission = 0.0f;
                 parts.object.material.ior = 1.5f;
             }},
        Case{"quadrics (object 'wall')",
             [](Parts &parts) {
                 parts.object.mesh = nullptr;
                 parts.object.quadric = sphere;
             }},
        Case{"quadrics (light 'lamp')",
             [](Parts &parts) {
                 parts.light.mesh = nullptr;
                 parts.light.quadric = sphere;
             }},
        Case{"refraction (object 'wall')", [](Parts &parts) { parts.object.material.ior = 1.5f; }},
        Case{"reflection that adds to the local colour (object 'wall')",
             [](Parts &parts) { parts.object.material.adds_to_local = true; }},
        Case{"coloured highlights (object 'wall')",
             [](Parts &parts) { parts.object.material.highlight_color = Color(1, 0, 0); }},
        Case{"textures (object 'wall')",
             [](Parts &parts) {
                 parts.object.material.texture = std::make_shared<Texture>(Texture{1, 1, {Color(1.0f)}});
             }},
        Case{"smooth normals (object 'wall')",
             [](Parts &parts) {
                 auto mesh = std::make_shared<Mesh>(*parts.object.mesh);
                 mesh->normals = {Vector(0, 0, 1)};
                 mesh->normal_corners = {{0, 0, 0}};
                 parts.object.mesh = mesh;
             }},
        Case{"soft shadows (light 'lamp')", [](Parts &parts) { parts.light.shadow_rays = 2; }},
        Case{"soft shadows (light 'lamp')", [](Parts &parts) { parts.light.grid_width = parts.light.grid_height = 1; }},
        Case{"light that fades with distance (light 'lamp')", [](Parts &parts) { parts.light.has_falloff = true; }},
        Case{"lights without a mesh (light 'lamp')",
             [](Parts &parts) {
                 parts.light.mesh = nullptr;
                 parts.light.kind = Light::Kind::directional;
             }},
        Case{"several samples a pixel", [](Parts &parts) { parts.picture.samples_per_pixel = 4; }},
        Case{"samples at random places", [](Parts &parts) { parts.picture.pattern = SamplePattern::jittered; }},
        Case{"a tone curve", [](Parts &parts) { parts.picture.tone_scale = 0.5f; }},
        Case{"shadows through glass", [](Parts &parts) { parts.optics.shadows_through_glass = true; }}));

} // namespace
} // namespace glint::bench
