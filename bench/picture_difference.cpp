// How far two pictures of the same scene are from each other.
#include "bench/picture_difference.hpp"

#include <algorithm>
#include <cassert>

namespace glint::bench {

PictureDifference compare_pictures(const Framebuffer &a, const Framebuffer &b) {
    assert(a.width_px() == b.width_px() && a.height_px() == b.height_px());
    PictureDifference difference;
    difference.pixels = uint64_t{a.width_px()} * a.height_px();
    for (uint64_t pixel = 0; pixel < difference.pixels; ++pixel) {
        int largest = 0;
        for (uint64_t byte = 4 * pixel; byte < 4 * pixel + 4; ++byte) {
            largest = std::max(largest, std::abs(int{a.rgba8()[byte]} - int{b.rgba8()[byte]}));
        }
        difference.differing += largest > 1;
        difference.largest = std::max(difference.largest, static_cast<uint8_t>(largest));
    }
    return difference;
}

} // namespace glint::bench
