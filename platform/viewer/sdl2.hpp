// libSDL2, looked up at run time: a program starts without it, and can say what is missing.
#pragma once

#include <glint/result.hpp>

// The program's main() stays its own.
#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace glint::viewer {

/// The functions of SDL 2.0.5 that this room calls. Plain data; usable while the process runs.
struct Sdl2 {
    /// Fails with `unsupported`, naming what to install, when there is no such library.
    [[nodiscard]] static Result<Sdl2> load();

    /// The failure of `call`, with what SDL_GetError has to say.
    [[nodiscard]] Error error(const char *call) const;

    decltype(&SDL_CreateWindow) create_window = nullptr;
    decltype(&SDL_DestroyWindow) destroy_window = nullptr;
    decltype(&SDL_GL_CreateContext) gl_create_context = nullptr;
    decltype(&SDL_GL_DeleteContext) gl_delete_context = nullptr;
    decltype(&SDL_GL_GetDrawableSize) gl_get_drawable_size = nullptr;
    decltype(&SDL_GL_GetProcAddress) gl_get_proc_address = nullptr;
    decltype(&SDL_GL_MakeCurrent) gl_make_current = nullptr;
    decltype(&SDL_GL_SetAttribute) gl_set_attribute = nullptr;
    decltype(&SDL_GL_SetSwapInterval) gl_set_swap_interval = nullptr;
    decltype(&SDL_GL_SwapWindow) gl_swap_window = nullptr;
    decltype(&SDL_GetCurrentDisplayMode) get_current_display_mode = nullptr;
    decltype(&SDL_GetCurrentVideoDriver) get_current_video_driver = nullptr;
    decltype(&SDL_GetError) get_error = nullptr;
    decltype(&SDL_GetWindowDisplayIndex) get_window_display_index = nullptr;
    decltype(&SDL_GetWindowSize) get_window_size = nullptr;
    decltype(&SDL_InitSubSystem) init_sub_system = nullptr;
    decltype(&SDL_PollEvent) poll_event = nullptr;
    decltype(&SDL_QuitSubSystem) quit_sub_system = nullptr;
    decltype(&SDL_SetHint) set_hint = nullptr;
    decltype(&SDL_SetWindowSize) set_window_size = nullptr;
    decltype(&SDL_SetWindowTitle) set_window_title = nullptr;
    decltype(&SDL_WaitEventTimeout) wait_event_timeout = nullptr;
};

} // namespace glint::viewer
