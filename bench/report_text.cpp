// The report for a terminal, laid out like the paper's Table 1.
#include "bench/report.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

namespace glint::bench {
namespace {

constexpr size_t name_width = 20, label_width = 8, cell_width = 10;

/// As many digits as a figure of this magnitude has to say.
std::string number(double value) {
    if (value >= 1000.0) return fmt::format("{:.0f}", value);
    return value >= 100.0 ? fmt::format("{:.1f}", value) : fmt::format("{:.3f}", value);
}

using CellText = std::function<std::string(const Row &)>;

std::string line(const Table &table, std::string_view name, std::string_view label, const CellText &cell) {
    std::string text = fmt::format("{:<{}}{:<{}}", name, name_width, label, label_width);
    for (const Row &row : table.rows) text += fmt::format("{:>{}}", cell(row), cell_width);
    return text + '\n';
}

std::string paper_lines(const Table &table, const Quantity &quantity) {
    std::string text = line(table, "", "paper", [&](const Row &row) {
        const auto cell = paper_for(table, row);
        return cell ? fmt::format("{:.2f}", quantity.paper(*cell)) : std::string("-");
    });
    text += line(table, "", "ratio", [&](const Row &row) {
        const auto cell = paper_for(table, row);
        return cell ? fmt::format("{:.2f}x", ratio(quantity, row, *cell)) : std::string("-");
    });
    return text;
}

std::string quantity_lines(const Table &table, const Quantity &quantity, bool with_paper) {
    const bool missing = quantity.needs_surface && table.surface == "none";
    const auto figure = [&](double Summary::*part) {
        return [&quantity, missing, part](const Row &row) {
            return missing ? std::string("-") : number(quantity.ours(row).*part);
        };
    };
    const std::string name = fmt::format("{}{}", quantity.name, quantity.unit == "ms" ? ", ms" : "");
    std::string text = line(table, name, "median", figure(&Summary::median));
    if (quantity.has_spread) {
        text += line(table, "", "min", figure(&Summary::min));
        text += line(table, "", "p95", figure(&Summary::p95));
    }
    if (with_paper && !missing) text += paper_lines(table, quantity);
    return text;
}

} // namespace

std::string to_text(const Table &table) {
    const bool with_paper = std::any_of(table.rows.begin(), table.rows.end(),
                                        [&](const Row &row) { return paper_for(table, row).has_value(); });
    std::string text;
    for (const std::string &fact : circumstances(table)) text += fact + '\n';
    if (with_paper) {
        text += fmt::format("Paper    {}; ratio above 1 = better than the paper\n", paper_machine);
    }
    text += '\n';
    text += line(table, "Size", "", [](const Row &row) { return fmt::format("{}x{}", row.width_px, row.height_px); });
    text += line(table, "Recursive rays", "", [](const Row &row) { return fmt::format("{}", row.depth); });
    text += std::string(name_width + label_width + cell_width * table.rows.size(), '-') + '\n';
    for (const Quantity &quantity : quantities()) text += quantity_lines(table, quantity, with_paper);
    text += line(table, "Loop FPS", "", [](const Row &row) { return number(row.loop_fps); });
    text += line(table, "Frames", "", [](const Row &row) { return fmt::format("{}", row.frames); });
    text += line(table, "Rays a frame", "", [](const Row &row) { return fmt::format("{}", row.rays); });
    text += line(table, "Mrays/s", "", [](const Row &row) { return number(row.mrays_per_s); });
    return text;
}

} // namespace glint::bench
