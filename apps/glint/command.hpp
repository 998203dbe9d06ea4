// A subcommand: its parser, and what it does once the command line is understood.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "exit_code.hpp"

namespace glint::cli {

struct Command {
    CLI::App *parser; ///< owned by the parser it was added to
    std::function<ExitCode()> run;
};

// Each adds its subcommand to `parser`.
[[nodiscard]] Command add_render_command(CLI::App &parser);
[[nodiscard]] Command add_view_command(CLI::App &parser);
[[nodiscard]] Command add_info_command(CLI::App &parser);
[[nodiscard]] Command add_inspect_command(CLI::App &parser);
[[nodiscard]] Command add_convert_command(CLI::App &parser);
[[nodiscard]] Command add_surfaces_command(CLI::App &parser);

// Each adds its subcommand to `glint bench`.
[[nodiscard]] Command add_bench_table_command(CLI::App &bench);
[[nodiscard]] Command add_bench_frame_command(CLI::App &bench);
[[nodiscard]] Command add_bench_kernels_command(CLI::App &bench);
[[nodiscard]] Command add_bench_moving_command(CLI::App &bench);
[[nodiscard]] Command add_bench_read_command(CLI::App &bench);
[[nodiscard]] Command add_bench_present_command(CLI::App &bench);
[[nodiscard]] Command add_bench_upscale_command(CLI::App &bench);

/// What `glint --version` prints, without a newline at the end.
[[nodiscard]] std::string version_text();

} // namespace glint::cli
