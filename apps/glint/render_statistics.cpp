// What `glint render --stats` prints.
#include "render_statistics.hpp"

#include <fmt/format.h>

namespace glint::cli {

std::string tree_text(const Accel &accel) {
    const AccelStatistics &tree = accel.statistics();
    const double triangles = tree.triangles == 0 ? 1.0 : tree.triangles;
    const double bytes_each = static_cast<double>(tree.bytes) / triangles;
    if (accel.kind() == AccelKind::brute) {
        return fmt::format("brute, {} triangles, {:.1f} bytes/triangle", tree.triangles, bytes_each);
    }
    return fmt::format("{}, {} triangles, {} nodes, {} leaves ({} empty), {:.2f} references/triangle, depth {}, "
                       "SAH cost {:.1f}, {:.1f} bytes/triangle",
                       accel_kind_name(accel.kind()), tree.triangles, tree.nodes, tree.leaves, tree.empty_leaves,
                       static_cast<double>(tree.references) / triangles, tree.depth, tree.sah_cost, bytes_each);
}

std::string render_statistics_text(const Renderer &renderer, const RenderStatistics &render, double read_seconds) {
    const Accel &accel = renderer.accel();
    const double mrays_per_s = render.seconds > 0.0 ? 1e-6 * static_cast<double>(render.rays()) / render.seconds : 0.0;
    std::string text;
    text += fmt::format("read     {:.3f} ms\n", 1e3 * read_seconds);
    text += fmt::format("build    {:.3f} ms\n", 1e3 * accel.statistics().build_seconds);
    text += fmt::format("render   {:.3f} ms\n", 1e3 * render.seconds);
    text += fmt::format("rays     {} ({} primary, {} shadow, {} secondary), {:.2f} Mrays/s\n", render.rays(),
                        render.primary_rays, render.shadow_rays, render.secondary_rays, mrays_per_s);
    text += fmt::format("threads  {}\n", renderer.threads());
    text += fmt::format("isa      {}\n", isa_name(renderer.isa()));
    text += fmt::format("tree     {}\n", tree_text(accel));
    return text;
}

} // namespace glint::cli
