// Preloaded into a program that shows pictures with SDL2: at each swap it looks at what is shown, and plays the person
// at the mouse. The first frame goes to shown.0.pam; then the left button drags; the frame after it goes to
// shown.1.pam; then the window is closed.
#include <cstdio>
#include <vector>

#include <GLES2/gl2.h>
#include <SDL2/SDL.h>
#include <dlfcn.h>

namespace {

void save(SDL_Window *window, const char *file) {
    int width = 0, height = 0;
    SDL_GL_GetDrawableSize(window, &width, &height);
    const auto finish = reinterpret_cast<decltype(&glFinish)>(SDL_GL_GetProcAddress("glFinish"));
    const auto read_pixels = reinterpret_cast<decltype(&glReadPixels)>(SDL_GL_GetProcAddress("glReadPixels"));
    std::vector<unsigned char> rgba8(static_cast<size_t>(4) * width * height);
    finish();
    read_pixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba8.data());
    std::FILE *out = std::fopen(file, "wb");
    std::fprintf(out, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", width, height);
    for (int y = height - 1; y >= 0; --y) // OpenGL's first row is the lowest
        std::fwrite(&rgba8[static_cast<size_t>(4) * width * y], 4, static_cast<size_t>(width), out);
    std::fclose(out);
}

void push_drag() {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.state = SDL_BUTTON_LMASK;
    event.motion.xrel = 40;
    SDL_PushEvent(&event);
}

} // namespace

extern "C" __attribute__((visibility("default"))) void SDL_GL_SwapWindow(SDL_Window *window) {
    static int frame = 0;
    if (frame == 0) save(window, "shown.0.pam");
    if (frame == 1) push_drag();
    if (frame == 2) save(window, "shown.1.pam");
    if (frame == 3) {
        SDL_Event event{};
        event.type = SDL_QUIT;
        SDL_PushEvent(&event);
    }
    ++frame;
    reinterpret_cast<void (*)(SDL_Window *)>(dlsym(RTLD_NEXT, "SDL_GL_SwapWindow"))(window);
}
