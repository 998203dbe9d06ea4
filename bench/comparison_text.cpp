// Comparisons with a peer, for a terminal.
#include "bench/comparison_report.hpp"

#include <string_view>

#include <fmt/format.h>

namespace glint::bench {
namespace {

std::string class_line(const ClassRow &row) {
    const Agreement &agreement = row.agreement;
    return fmt::format(
        "{:<10}{:>8}{:>10.2f}{:>10.2f}{:>8.2f}x  {:>+5.0f} %{:>+7.0f} %  {:<46} {} ({:.3f} % the same)\n",
        row.ray_class, row.threads, row.glint_mrays, row.peer_mrays, row.ratio(),
        100.0 * (row.glint_ms.p95 / row.glint_ms.median - 1.0), 100.0 * (row.peer_ms.p95 / row.peer_ms.median - 1.0),
        row.peer_kernel, agreement.hits_equal() ? "equal" : "DIFFERENT",
        100.0 * static_cast<double>(agreement.same) / static_cast<double>(agreement.rays));
}

std::string build_line(const BuildRow &row) {
    return fmt::format("{:<8}{:>10.1f}{:>10.1f}{:>10.1f}{:>14.1f}{:>10.1f}{:>10.1f}\n", row.threads,
                       row.glint_ms.median, row.peer_ms.median, row.peer_high_ms.median, row.glint_bytes_per_triangle,
                       row.peer_bytes_per_triangle, row.peer_high_bytes_per_triangle);
}

std::string circumstances(const Machine &machine) {
    return fmt::format("Machine  {}, {} processor{}, {}, {}\nGlint    {}, {}\n", machine.cpu, machine.processors,
                       machine.processors == 1 ? "" : "s", machine.os, machine.kernel, machine.glint, machine.compiler);
}

std::string cell_line(const FrameCell &cell) {
    const PictureDifference &difference = cell.difference;
    return fmt::format("{:<12}{:>6}{:>8}{:>10.3f}{:>9.3f}{:>9.3f}{:>10.3f}{:>9.3f}{:>9.3f}{:>8.2f}x{:>9}  {}\n",
                       fmt::format("{}x{}", cell.width_px, cell.height_px), cell.depth, cell.threads,
                       cell.glint_ms.median, cell.glint_ms.min, cell.glint_ms.p95, cell.peer_ms.median,
                       cell.peer_ms.min, cell.peer_ms.p95, cell.ratio(), cell.frames,
                       difference.same_picture()
                           ? fmt::format("the same ({} pixels differ)", difference.differing)
                           : fmt::format("ANOTHER ({} of {} pixels differ)", difference.differing, difference.pixels));
}

} // namespace

std::string to_text(const FrameReport &report) {
    std::string text = circumstances(report.machine);
    text += fmt::format("Scene    {}\n", report.scene);
    text += fmt::format("Tracing  instruction set {}; peer {}\n\n", report.comparison.isa, report.peer);
    text += fmt::format("{:<12}{:>6}{:>8}{:>10}{:>9}{:>9}{:>10}{:>9}{:>9}{:>9}{:>9}  {}\n", "Render, ms", "depth",
                        "threads", "Glint", "min", "p95", "peer", "min", "p95", "ratio", "frames", "picture");
    std::string_view kernel;
    for (const FrameCell &cell : report.comparison.cells) {
        if (cell.peer_kernel != kernel) text += fmt::format("  peer: {}\n", kernel = cell.peer_kernel);
        text += cell_line(cell);
    }
    return text;
}

std::string to_text(const KernelReport &report) {
    std::string text = circumstances(report.machine);
    text += fmt::format("Mesh     {}, {} triangles\n", report.mesh, report.triangles);
    text += fmt::format("Tracing  instruction set {}; peer {}\n\n", report.isa, report.peer);
    text += fmt::format("{:<10}{:>8}{:>10}{:>10}{:>9}  {:>7}{:>9}  {:<46} {}\n", "Mrays/s", "threads", "Glint", "peer",
                        "ratio", "p95", "p95", "peer's kernel", "hits");
    for (const ClassRow &row : report.classes) text += class_line(row);
    text += fmt::format("\n{:<8}{:>10}{:>10}{:>10}{:>14}{:>10}{:>10}\n", "Build ms", "Glint", "peer", "peer high",
                        "bytes/tri", "peer", "peer high");
    for (const BuildRow &row : report.builds) text += build_line(row);
    return text;
}

} // namespace glint::bench
