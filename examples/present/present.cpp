// Shows a scene in a window, traced anew for every frame; a drag goes around it: present SCENE
#include <SDL2/SDL.h>
#include <glint/gles/presenter.hpp>
#include <glint/glint.hpp>

int main(int, char **arguments) {
    const int width_px = 512, height_px = 512;
    SDL_SetHint(SDL_HINT_OPENGL_ES_DRIVER, "1");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return SDL_Log("%s", SDL_GetError()), 1;
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 2);
    SDL_Window *window = SDL_CreateWindow("Glint", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, width_px,
                                          height_px, SDL_WINDOW_OPENGL);
    if (!window || !SDL_GL_CreateContext(window)) return SDL_Log("%s", SDL_GetError()), 1;

    const auto file = glint::read_scene(arguments[1]);
    if (!file) return SDL_Log("%s", file.error().text().c_str()), 1;
    glint::Renderer renderer(glint::Accel::build(file->scene));
    glint::CameraControl camera(file->scene);
    auto picture = glint::Framebuffer::create(width_px, height_px, false);
    auto presenter = glint::gles::Presenter::create(SDL_GL_GetProcAddress);
    if (!picture || !presenter) return 1;

    glint::RenderOptions options;
    for (bool running = true; running;) {
        for (SDL_Event event; SDL_PollEvent(&event);) {
            if (event.type == SDL_QUIT) running = false;
            if (event.type == SDL_MOUSEMOTION && (event.motion.state & SDL_BUTTON_LMASK))
                camera.orbit({double(event.motion.xrel) / width_px, double(event.motion.yrel) / height_px});
        }
        options.camera = camera.camera();
        if (!renderer.render(*picture, options)) return 1;
        if (!(*presenter)->upload(*picture) || !(*presenter)->draw(0, 0, width_px, height_px)) return 1;
        SDL_GL_SwapWindow(window);
    }
    presenter->reset(); // while its context is there
    SDL_Quit();
}
