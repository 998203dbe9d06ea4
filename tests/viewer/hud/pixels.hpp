// Pixels to draw on that notice when something is drawn beside them.
#pragma once

#include <cstdint>
#include <vector>

#include "viewer/hud/canvas.hpp"

namespace glint::test {

class Pixels {
public:
    static constexpr uint8_t untouched = 0xa5;

    /// Rows are `spare_px` pixels longer than the canvas knows; so much lies above and below, too.
    Pixels(uint32_t width_px, uint32_t height_px, uint32_t spare_px = 3)
        : width_(width_px),
          height_(height_px),
          spare_(spare_px),
          bytes_(size_t{width_px + spare_px} * (height_px + 2 * size_t{spare_px}) * 4, untouched) {}

    [[nodiscard]] viewer::Canvas canvas() { return {bytes_.data() + first(), width_, height_, stride()}; }

    [[nodiscard]] bool is_untouched_outside() const {
        for (size_t i = 0; i < bytes_.size(); ++i) {
            const bool above = i < first(), below = i >= first() + size_t{height_} * stride();
            const bool beside = i % stride() >= size_t{width_} * 4;
            if ((above || below || beside) && bytes_[i] != untouched) return false;
        }
        return true;
    }

private:
    [[nodiscard]] size_t stride() const { return size_t{width_ + spare_} * 4; }
    [[nodiscard]] size_t first() const { return spare_ * stride(); }

    uint32_t width_, height_, spare_;
    std::vector<uint8_t> bytes_;
};

} // namespace glint::test
