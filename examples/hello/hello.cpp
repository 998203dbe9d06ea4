// Reads a scene, renders it, writes the picture: hello SCENE PICTURE
#include <cstdio>
#include <glint/glint.hpp>
#include <glint/imageio.hpp>

int main(int, char **arguments) {
    const auto fail = [](const glint::Error &error) { return std::puts(error.text().c_str()), 1; };
    const auto file = glint::read_scene(arguments[1]);
    if (!file) return fail(file.error());
    glint::Renderer renderer(glint::Accel::build(file->scene));
    auto picture = glint::Framebuffer::create(512, 512);
    if (!picture || !renderer.render(*picture)) return 1;
    const auto written = glint::write_image(arguments[2], *picture);
    return written ? 0 : fail(written.error());
}
