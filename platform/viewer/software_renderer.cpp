#include "viewer/software_renderer.hpp"

#include <algorithm>
#include <iterator>

namespace glint::viewer {

bool is_software(std::string_view gl_renderer) {
    constexpr std::string_view names[] = {"llvmpipe", "softpipe", "swrast", "SwiftShader"};
    return std::any_of(std::begin(names), std::end(names),
                       [&](std::string_view name) { return gl_renderer.find(name) != std::string_view::npos; });
}

} // namespace glint::viewer
