// Makes a scene without any file, renders it, and prints the library's version and the picture's hash.
#include <cstdint>
#include <cstdio>
#include <memory>

#include <glint/glint.hpp>

namespace {

/// A level square of the given half width, behind the default camera's window.
std::shared_ptr<const glint::Mesh> square(float half_width, float y) {
    auto mesh = std::make_shared<glint::Mesh>();
    mesh->positions = {
        {-half_width, y, -4.0f}, {half_width, y, -4.0f}, {half_width, y, -2.0f}, {-half_width, y, -2.0f}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

int fail(const glint::Error &error) {
    std::fprintf(stderr, "%s\n", error.text().c_str());
    return 1;
}

} // namespace

int main() {
    glint::SceneBuilder builder;
    builder.add_object({"floor", square(1.0f, -0.8f), {.color = {0.9f, 0.5f, 0.2f}}});
    builder.add_light({"lamp", square(0.2f, 0.9f)});
    const auto scene = builder.build();
    if (!scene) return fail(scene.error());

    auto picture = glint::Framebuffer::create(64, 64);
    if (!picture) return fail(picture.error());
    glint::Renderer renderer(glint::Accel::build(*scene));
    if (const auto rendered = renderer.render(*picture); !rendered) return fail(rendered.error());

    const auto red = [&](uint32_t x, uint32_t y) {
        return picture->rgba8()[y * picture->rgba8_stride_bytes() + 4 * x];
    };
    if (red(32, 32) != 0 || red(32, 49) == 0) {
        std::fputs("the floor is not where it should be\n", stderr);
        return 1;
    }
    std::printf("%s %016llx\n", glint::build_info().version.data(),
                static_cast<unsigned long long>(picture->pixel_hash()));
}
