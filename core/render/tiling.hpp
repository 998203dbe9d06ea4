// Divides a picture into tiles.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "kernel/kernel.hpp"

namespace glint {

/// Square tiles in rows from the top left; those at the right and lower edge may be smaller.
class Tiling {
public:
    static constexpr uint32_t tile_px = 16;

    Tiling(uint32_t width_px, uint32_t height_px)
        : width_px_(width_px),
          height_px_(height_px),
          columns_((width_px - 1) / tile_px + 1),
          rows_((height_px - 1) / tile_px + 1) {}

    /// Fits 32 bits for any picture that fits memory.
    [[nodiscard]] uint32_t count() const { return columns_ * rows_; }

    [[nodiscard]] Tile tile(uint32_t index) const {
        const uint32_t x0 = index % columns_ * tile_px, y0 = index / columns_ * tile_px;
        return {x0, y0, std::min(x0 + tile_px, width_px_), std::min(y0 + tile_px, height_px_)};
    }

private:
    uint32_t width_px_, height_px_;
    uint32_t columns_, rows_;
};

/// Gives tiles to workers: short runs of neighbours at first, so that workers seldom meet at the counter, single tiles
/// towards the end, so that all finish together (guided self-scheduling, Polychronopoulos & Kuck 1987).
class TileQueue {
public:
    struct Run {
        uint32_t begin, end;
    };

    static constexpr uint32_t longest_run = 8;

    TileQueue(uint32_t count, unsigned workers) : count_(count), share_(16 * workers) {}

    /// An empty run when all tiles are given away.
    [[nodiscard]] Run next() {
        uint32_t begin = next_.load(std::memory_order_relaxed);
        while (begin < count_) {
            const uint32_t end = begin + std::clamp((count_ - begin) / share_, 1u, longest_run);
            if (next_.compare_exchange_weak(begin, end, std::memory_order_relaxed)) return {begin, end};
        }
        return {count_, count_};
    }

    /// Gives no more.
    void close() { next_.store(count_, std::memory_order_relaxed); }

private:
    const uint32_t count_, share_;
    alignas(128) std::atomic<uint32_t> next_{0};
};

} // namespace glint
