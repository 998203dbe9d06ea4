// Whole frames of Glint and of a peer, in turns: milliseconds for each size, depth and number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glint/accel.hpp>
#include <glint/isa.hpp>
#include <glint/result.hpp>

#include "bench/peers/peer.hpp"
#include "bench/picture_difference.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

struct FrameComparisonOptions {
    std::vector<uint32_t> sizes_px = {128, 256, 512}; ///< pictures are square
    std::vector<uint32_t> depths = {1, 2};            ///< recursive rays
    std::vector<unsigned> threads = {1, 2};           ///< numbers of threads, each measured for itself
    Isa isa = best_isa();
    double min_seconds = 2.0; ///< of timing for each cell, at least 20 frames each
    /// Called before each cell is measured. May be empty.
    std::function<void(uint32_t size_px, uint32_t depth, unsigned threads)> on_cell;
};

/// One size, depth and number of threads. Both render 8-bit pixels and nothing else.
struct FrameCell {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    uint32_t depth = 0;
    unsigned threads = 0;
    std::string peer_kernel; ///< how the peer traced, in its own words
    uint64_t frames = 0;     ///< of each
    Summary glint_ms;
    Summary peer_ms;
    PictureDifference difference;

    /// How many times faster than the peer.
    [[nodiscard]] double ratio() const { return peer_ms.median / glint_ms.median; }
};

struct FrameComparison {
    std::string isa; ///< that Glint ran with
    std::vector<FrameCell> cells;
};

/// Measures every cell: one frame of Glint's, one of the peer's, and so on; the calling thread on a processor of its
/// own. Pictures are compared before a cell is timed. Fails as the peer and the renderer do.
[[nodiscard]] Result<FrameComparison> compare_frames(const std::shared_ptr<const Accel> &accel, const Peer &peer,
                                                     const FrameComparisonOptions &options);

} // namespace glint::bench
