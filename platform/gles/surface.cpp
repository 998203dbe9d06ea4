// The one place where Surface's virtual table lives.
#include <glint/gles/surface.hpp>

namespace glint::gles {

Surface::~Surface() = default;

} // namespace glint::gles
