// The options that say how a pixel comes to its colour, where a command has them.
#pragma once

#include <cstdint>
#include <optional>

#include <CLI/CLI.hpp>

#include <glint/renderer.hpp>

namespace glint::cli {

struct SampleOptions {
    std::optional<uint32_t> depth;
    std::optional<uint32_t> samples_per_pixel;
    std::optional<SamplePattern> pattern;
    Transfer transfer = Transfer::linear;

    [[nodiscard]] RenderOptions render_options() const;
};

/// Adds --depth, --spp, --pattern and --transfer. `options` must live as long as the parser.
void add_sample_options(CLI::App &parser, SampleOptions &options);

} // namespace glint::cli
