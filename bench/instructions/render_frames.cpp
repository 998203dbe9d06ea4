// glint_render_frames ISA SCENE SIZE DEPTH: renders a square picture twice on the calling thread and prints how many rays
// it took. count.py counts the instructions of the second time, when the kernel knows the scene: those between two calls
// of functions that it knows by name.
#include <cstdio>
#include <cstdlib>

#include <glint/glint.hpp>

namespace {

/// The number of rays; 0 where it failed.
uint64_t render(glint::Renderer &renderer, glint::Framebuffer &picture, const glint::RenderOptions &options) {
    const auto done = renderer.render(picture, options);
    return done ? done->rays() : 0;
}

} // namespace

extern "C" {
[[gnu::noinline]] void glint_count_ends() { asm volatile(""); }
[[gnu::noinline]] uint64_t glint_count(glint::Renderer &renderer, glint::Framebuffer &picture,
                                       const glint::RenderOptions &options) {
    const uint64_t rays = render(renderer, picture, options);
    glint_count_ends();
    return rays;
}
}

int main(int count, char **arguments) {
    if (count != 5) return std::fputs("usage: glint_render_frames ISA SCENE SIZE DEPTH\n", stderr), 2;
    const auto isa = glint::find_isa(arguments[1]);
    if (!isa) return std::fprintf(stderr, "%s\n", isa.error().text().c_str()), 2;
    const auto file = glint::read_scene(arguments[2]);
    if (!file) return std::fprintf(stderr, "%s\n", file.error().text().c_str()), 2;
    const auto size_px = static_cast<uint32_t>(std::strtoul(arguments[3], nullptr, 10));
    auto picture = glint::Framebuffer::create(size_px, size_px);
    if (!picture) return std::fprintf(stderr, "%s\n", picture.error().text().c_str()), 2;

    glint::Renderer renderer(glint::Accel::build(file->scene), {.threads = 1, .isa = *isa});
    glint::RenderOptions options;
    options.max_depth = static_cast<uint32_t>(std::strtoul(arguments[4], nullptr, 10));
    const uint64_t first = render(renderer, *picture, options);
    const uint64_t rays = glint_count(renderer, *picture, options);
    std::printf("%llu\n", static_cast<unsigned long long>(rays));
    return rays > 0 && rays == first ? 0 : 1;
}
