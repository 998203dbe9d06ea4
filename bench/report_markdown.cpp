// The report for a page.
#include "bench/report.hpp"

#include <fmt/format.h>

namespace glint::bench {
namespace {

/// "1.234 (paper 41.86, 33.9x)", or as much of it as there is.
std::string cell_text(const Table &table, const Quantity &quantity, const Row &row) {
    if (quantity.needs_surface && table.surface == "none") return "-";
    const std::string ours = fmt::format("{:.3f}", quantity.ours(row).median);
    const auto cell = paper_for(table, row);
    if (!cell) return ours;
    return fmt::format("{} (paper {:.2f}, {:.1f}x)", ours, quantity.paper(*cell), ratio(quantity, row, *cell));
}

/// A vertical bar would end a table's cell, so the same escapes serve everywhere.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '|' || c == '\\' || c == '<' || c == '*' || c == '_' || c == '`') result += '\\';
        result += c;
    }
    return result;
}

} // namespace

std::string to_markdown(const Table &table) {
    std::string text;
    for (const std::string &fact : circumstances(table)) text += "- " + escaped(fact) + '\n';
    text += "\n| median |";
    for (const Row &row : table.rows) text += fmt::format(" {}x{} d{} |", row.width_px, row.height_px, row.depth);
    text += "\n|---|";
    for (size_t i = 0; i < table.rows.size(); ++i) text += "---|";
    for (const Quantity &quantity : quantities()) {
        text += fmt::format("\n| {}{} |", quantity.name, quantity.unit == "ms" ? ", ms" : "");
        for (const Row &row : table.rows) text += ' ' + cell_text(table, quantity, row) + " |";
    }
    text += "\n| Loop FPS |";
    for (const Row &row : table.rows) text += fmt::format(" {:.2f} |", row.loop_fps);
    text += "\n| Mrays/s |";
    for (const Row &row : table.rows) text += fmt::format(" {:.2f} |", row.mrays_per_s);
    return text + '\n';
}

} // namespace glint::bench
