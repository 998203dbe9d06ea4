// Looking through the lists of extensions that OpenGL ES and EGL answer with.
#pragma once

#include <string_view>

namespace glint::gles {

/// Whether a list of names, separated by spaces, has this one. A part of a longer name does not count.
[[nodiscard]] constexpr bool lists_extension(std::string_view list, std::string_view name) {
    while (!list.empty()) {
        const size_t end = list.find(' ');
        if (list.substr(0, end) == name) return true;
        list = end == std::string_view::npos ? std::string_view() : list.substr(end + 1);
    }
    return false;
}

static_assert(lists_extension("GL_A GL_AB GL_C", "GL_AB"));
static_assert(!lists_extension("GL_A GL_AB GL_C", "GL_B"));

} // namespace glint::gles
