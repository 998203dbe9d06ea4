// libSDL2, looked up at run time.
#include "viewer/sdl2.hpp"

#include <array>
#include <string>
#include <utility>

#include "gles/dynamic_library.hpp"

namespace glint::viewer {

Result<Sdl2> Sdl2::load() {
    static constexpr std::array<const char *, 2> file_names = {"libSDL2-2.0.so.0", "libSDL2.so"};
    const gles::LibraryNames names{
        file_names,
        "install the package libsdl2-2.0-0 (Debian, Ubuntu), or go on without a window: --surface offscreen"};
    Result<gles::DynamicLibrary> library = gles::DynamicLibrary::open(names);
    if (!library) return std::move(library).error();
    Sdl2 sdl;
    Status status = Done{};
    const auto find = [&](auto &function, const char *name) {
        if (status) status = library->find(function, name);
    };
    find(sdl.create_window, "SDL_CreateWindow");
    find(sdl.destroy_window, "SDL_DestroyWindow");
    find(sdl.gl_create_context, "SDL_GL_CreateContext");
    find(sdl.gl_delete_context, "SDL_GL_DeleteContext");
    find(sdl.gl_get_drawable_size, "SDL_GL_GetDrawableSize");
    find(sdl.gl_get_proc_address, "SDL_GL_GetProcAddress");
    find(sdl.gl_make_current, "SDL_GL_MakeCurrent");
    find(sdl.gl_set_attribute, "SDL_GL_SetAttribute");
    find(sdl.gl_set_swap_interval, "SDL_GL_SetSwapInterval");
    find(sdl.gl_swap_window, "SDL_GL_SwapWindow");
    find(sdl.get_current_display_mode, "SDL_GetCurrentDisplayMode");
    find(sdl.get_current_video_driver, "SDL_GetCurrentVideoDriver");
    find(sdl.get_error, "SDL_GetError");
    find(sdl.get_window_display_index, "SDL_GetWindowDisplayIndex");
    find(sdl.get_window_size, "SDL_GetWindowSize");
    find(sdl.init_sub_system, "SDL_InitSubSystem");
    find(sdl.poll_event, "SDL_PollEvent");
    find(sdl.quit_sub_system, "SDL_QuitSubSystem");
    find(sdl.set_hint, "SDL_SetHint");
    find(sdl.set_window_size, "SDL_SetWindowSize");
    find(sdl.set_window_title, "SDL_SetWindowTitle");
    find(sdl.wait_event_timeout, "SDL_WaitEventTimeout");
    if (!status) return std::move(status).error();
    return sdl;
}

Error Sdl2::error(const char *call) const {
    return Error(ErrorCode::unsupported, std::string(call) + " failed: " + get_error());
}

} // namespace glint::viewer
