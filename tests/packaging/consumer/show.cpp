// Shows an empty picture on whatever surface this machine has, and prints what reads and writes image files.
#include <cstdio>

#include <glint/egl/surface.hpp>
#include <glint/gles/presenter.hpp>
#include <glint/glint.hpp>
#include <glint/imageio.hpp>
#include <glint/osmesa/surface.hpp>

int main() {
    auto surface = glint::egl::create_surfaceless(8, 8);
    if (!surface) surface = glint::osmesa::create(8, 8);
    if (surface) {
        const auto picture = glint::Framebuffer::create(8, 8);
        const auto presenter = glint::gles::Presenter::create((*surface)->proc_loader());
        if (!picture || !presenter || !(*presenter)->upload(*picture) || !(*presenter)->draw(0, 0, 8, 8)) return 1;
    }
    const auto library = glint::image_library_version();
    std::puts((library ? *library : library.error().text()).c_str());
}
