// Table 1 of the 2013 paper, to be set beside our own.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace glint::bench {

/// One column of the table; milliseconds, and frames per second as the paper's display loop reached them.
/// Source: R. Aroxa, "Photorealistic 3D Rendering for VW in Mobile Devices", University of Arkansas, 2013, Table 1
/// (MacBook Pro 15 of mid-2012, iOS Simulator 6.1).
struct PaperCell {
    double render_ms;
    double upload_ms;
    double gl_ms;
    double time_to_image_ms;
    double fps;
};

inline constexpr std::string_view paper_machine = "MacBook Pro 15 (mid-2012), iOS Simulator 6.1";

/// The paper's figures for its own scene at this size and number of recursive rays, where it has them.
[[nodiscard]] constexpr std::optional<PaperCell> paper_cell(uint32_t width_px, uint32_t height_px, uint32_t depth) {
    struct Column {
        uint32_t size_px;
        uint32_t depth;
        PaperCell cell;
    };
    constexpr Column columns[] = {
        {128, 1, {41.86, 0.02, 0.47, 42.35, 20.01}},  {128, 2, {63.66, 0.03, 0.48, 64.17, 15.01}},
        {256, 1, {165.81, 0.05, 1.72, 167.58, 5.45}}, {256, 2, {249.92, 0.05, 1.71, 251.68, 3.75}},
        {512, 1, {657.24, 0.16, 6.69, 664.08, 1.46}}, {512, 2, {989.92, 0.16, 6.51, 996.58, 1.00}},
    };
    for (const Column &column : columns) {
        if (column.size_px == width_px && column.size_px == height_px && column.depth == depth) return column.cell;
    }
    return std::nullopt;
}

} // namespace glint::bench
