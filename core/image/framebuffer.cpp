// The picture's memory.
#include <glint/framebuffer.hpp>

#include <new>

namespace glint {

Result<Framebuffer> Framebuffer::create(uint32_t width_px, uint32_t height_px, bool with_radiance) {
    const std::string size = std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels";
    if (width_px == 0 || height_px == 0) {
        return Error(ErrorCode::bad_input, "a framebuffer of " + size + ", expected at least 1 x 1");
    }
    // 64-bit size first: 12 bytes a pixel for the floats must be addressable.
    const uint64_t wide = uint64_t{width_px} * height_px;
    if (wide > PTRDIFF_MAX / (3 * sizeof(float))) {
        return Error(ErrorCode::limit_exceeded, "a framebuffer of " + size + " cannot be addressed");
    }
    const auto pixels = static_cast<size_t>(wide);
    Framebuffer framebuffer;
    framebuffer.width_px_ = width_px;
    framebuffer.height_px_ = height_px;
    framebuffer.rgba8_.reset(new (std::nothrow) uint8_t[pixels * 4]());
    if (with_radiance) framebuffer.radiance_.reset(new (std::nothrow) float[pixels * 3]());
    if (!framebuffer.rgba8_ || (with_radiance && !framebuffer.radiance_)) {
        return Error(ErrorCode::limit_exceeded, "no memory for a framebuffer of " + size);
    }
    return framebuffer;
}

} // namespace glint
