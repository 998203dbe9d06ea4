// Which Highway the packet kernels were built with.
#include "kernel/highway_version.hpp"

#include <hwy/highway.h>

#define GLINT_TEXT_OF(x) #x
#define GLINT_TEXT(x) GLINT_TEXT_OF(x)

namespace glint {

std::string_view highway_version() {
    return GLINT_TEXT(HWY_MAJOR) "." GLINT_TEXT(HWY_MINOR) "." GLINT_TEXT(HWY_PATCH);
}

} // namespace glint
