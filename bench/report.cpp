// What every form of the report shares: the quantities, the comparison with the paper, the circumstances.
#include "bench/report.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>

namespace glint::bench {

const std::vector<Quantity> &quantities() {
    static const std::vector<Quantity> table_1 = {
        {"Render", "ms", [](const Row &r) { return r.render_ms; }, [](const PaperCell &c) { return c.render_ms; },
         /*has_spread=*/true, /*needs_surface=*/false, /*more_is_better=*/false},
        {"Texture upload", "ms", [](const Row &r) { return r.upload_ms; },
         [](const PaperCell &c) { return c.upload_ms; }, true, true, false},
        {"OpenGL render", "ms", [](const Row &r) { return r.gl_ms; }, [](const PaperCell &c) { return c.gl_ms; }, true,
         true, false},
        {"Time to image", "ms", [](const Row &r) { return r.time_to_image_ms; },
         [](const PaperCell &c) { return c.time_to_image_ms; }, true, false, false},
        {"FPS", "1/s",
         [](const Row &r) {
             return Summary{r.fps, r.fps, r.fps};
         },
         [](const PaperCell &c) { return c.fps; }, false, false, true},
    };
    return table_1;
}

std::optional<PaperCell> paper_for(const Table &table, const Row &row) {
    if (std::filesystem::path(table.scene).filename() != "cornell.sdl") return std::nullopt;
    return paper_cell(row.width_px, row.height_px, row.depth);
}

double ratio(const Quantity &quantity, const Row &row, const PaperCell &cell) {
    const double ours = quantity.ours(row).median, paper = quantity.paper(cell);
    return quantity.more_is_better ? ours / paper : paper / ours;
}

std::vector<std::string> circumstances(const Table &table) {
    const Machine &machine = table.machine;
    std::vector<std::string> lines;
    lines.push_back(fmt::format("Machine  {}, {} processor{}, {}, {}", machine.cpu, machine.processors,
                                machine.processors == 1 ? "" : "s", machine.os, machine.kernel));
    lines.push_back(fmt::format("Glint    {}, {}", machine.glint, machine.compiler));
    lines.push_back(fmt::format("Scene    {}", table.scene));
    lines.push_back(fmt::format("Tracing  {} thread{}, instruction set {}", table.threads,
                                table.threads == 1 ? "" : "s", table.isa));
    lines.push_back(
        fmt::format("Surface  {}{}{}", table.surface, table.gl_description.empty() ? "" : ", ", table.gl_description));
    return lines;
}

Status write_report(const std::filesystem::path &file, std::string_view text) {
    const auto failure = [&](int error) {
        return Error(ErrorCode::io, "cannot write '" + file.string() +
                                        "': " + std::error_code(error, std::generic_category()).message());
    };
    std::FILE *out = std::fopen(file.c_str(), "we");
    if (!out) return failure(errno);
    int error = std::fwrite(text.data(), 1, text.size(), out) == text.size() ? 0 : errno;
    if (std::fclose(out) != 0 && error == 0) error = errno; // the disk may be full only now
    if (error != 0) return failure(error);
    return Done{};
}

} // namespace glint::bench
