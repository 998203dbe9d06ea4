// Checking that the surface shows what was rendered, to the last byte.
#include "bench/shown_picture.hpp"

#include <cstddef>

#include <fmt/format.h>

namespace glint::bench {

Status compare_shown(const Framebuffer &picture, std::span<const uint8_t> shown) {
    const size_t count = picture.rgba8_stride_bytes() * picture.height_px();
    if (shown.size() != count) {
        return Error(ErrorCode::io, fmt::format("the surface holds {} bytes, the picture {}", shown.size(), count));
    }
    size_t first = count;
    size_t differing = 0;
    for (size_t i = count; i-- > 0;) {
        if (shown[i] == picture.rgba8()[i]) continue;
        first = i;
        ++differing;
    }
    if (differing == 0) return Done{};
    const size_t pixel = first / 4;
    return Error(ErrorCode::io,
                 fmt::format("the surface does not show what was rendered: {} of {} bytes differ, the first in channel "
                             "{} of pixel ({}, {}): rendered {}, shown {}",
                             differing, count, first % 4, pixel % picture.width_px(), pixel / picture.width_px(),
                             picture.rgba8()[first], shown[first]));
}

} // namespace glint::bench
