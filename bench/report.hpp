// A measured table as text: for the terminal, for programs, for spreadsheets, for a page.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glint/result.hpp>

#include "bench/paper.hpp"
#include "bench/table.hpp"

namespace glint::bench {

/// Laid out like the paper's Table 1: a line for each quantity, a column for each size and depth; the paper's figure
/// and the ratio under ours.
[[nodiscard]] std::string to_text(const Table &table);
/// `{"machine": {...}, "scene": ..., "rows": [...]}`, in milliseconds.
[[nodiscard]] std::string to_json(const Table &table);
/// A line for each row, after a line of column names.
[[nodiscard]] std::string to_csv(const Table &table);
/// The text's content as a GitHub-flavoured table.
[[nodiscard]] std::string to_markdown(const Table &table);

/// Makes `text` the content of `file`. Fails with io and the system's own words.
[[nodiscard]] Status write_report(const std::filesystem::path &file, std::string_view text);

/// The paper's figures for this row: only for its own scene, known by the file name cornell.sdl.
[[nodiscard]] std::optional<PaperCell> paper_for(const Table &table, const Row &row);

/// One of Table 1's quantities: how it is called, where it is in a row of ours and in a column of the paper's.
struct Quantity {
    std::string_view name;
    std::string_view unit; ///< "ms" or "1/s"
    /// Median, minimum and 95th percentile; fps has only the first.
    Summary (*ours)(const Row &);
    double (*paper)(const PaperCell &);
    bool has_spread;     ///< whether minimum and 95th percentile mean something
    bool needs_surface;  ///< nothing to report when no surface was there
    bool more_is_better; ///< decides which way round the ratio is: above 1 = better than the paper
};

/// Render, texture upload, OpenGL render, time to image, FPS: the paper's order.
[[nodiscard]] const std::vector<Quantity> &quantities();

/// How many times better than the paper's figure ours is.
[[nodiscard]] double ratio(const Quantity &quantity, const Row &row, const PaperCell &cell);

/// "Scene cornell.sdl, 2 threads, ...": what the figures were taken with, a fact a line.
[[nodiscard]] std::vector<std::string> circumstances(const Table &table);

} // namespace glint::bench
