// Moves an object of a scene for every frame, without building anything anew: edit FRAMES, which writes edit.0.png, ...
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string>

#include <glint/glint.hpp>
#include <glint/imageio.hpp>

namespace {

/// A level square of the given half width, its middle at the origin.
std::shared_ptr<const glint::Mesh> square(float half_width) {
    auto mesh = std::make_shared<glint::Mesh>();
    const float h = half_width;
    mesh->positions = {{-h, 0.0f, -h}, {h, 0.0f, -h}, {h, 0.0f, h}, {-h, 0.0f, h}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// Standing on the wing's middle, turned by so much about an axis between those of the world.
glint::RigidTransform turned(double angle_rad) {
    return glint::RigidTransform::turned({1.0f, 0.5f, 0.0f}, angle_rad);
}

int fail(const glint::Error &error) {
    std::puts(error.text().c_str());
    return 1;
}

} // namespace

int main(int, char **arguments) {
    const int frame_count = std::atoi(arguments[1]);

    glint::SceneBuilder builder;
    glint::Object wing;
    wing.name = "wing";
    wing.mesh = square(1.0f);
    wing.material.color = {0.9f, 0.5f, 0.2f};
    wing.pose = turned(0.0); // it may move
    builder.add_object(std::move(wing));
    glint::Light sun;
    sun.kind = glint::Light::Kind::directional;
    sun.direction = {-1.0f, -2.0f, -1.5f};
    builder.add_light(std::move(sun));
    auto scene = builder.build();
    if (!scene) return fail(scene.error());

    auto picture = glint::Framebuffer::create(128, 128);
    if (!picture) return fail(picture.error());
    auto accel = glint::Accel::build(*scene);
    glint::Renderer renderer(accel);
    for (int frame = 0; frame < frame_count; ++frame) {
        const glint::ObjectPose pose{0, turned(2.0 * std::numbers::pi * frame / frame_count)};
        scene = glint::with_poses(*scene, {&pose, 1});
        if (!scene) return fail(scene.error());
        accel = glint::Accel::update(accel, *scene);
        renderer.set_accel(accel);
        if (const auto rendered = renderer.render(*picture); !rendered) return fail(rendered.error());
        const auto written = glint::write_image("edit." + std::to_string(frame) + ".png", *picture);
        if (!written) return fail(written.error());
    }
}
