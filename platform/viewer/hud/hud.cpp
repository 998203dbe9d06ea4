// Lays the display's panels out and draws them.
#include "viewer/hud/hud.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viewer/hud/frame_graph.hpp"
#include "viewer/hud/panel.hpp"
#include "viewer/hud/ray_list.hpp"
#include "viewer/hud/text.hpp"

namespace glint::viewer {

namespace {

constexpr int figure_columns = 20; // as wide as a graph of most_frame_times
constexpr int figure_rows = 8;
constexpr int graph_px = 36;
constexpr int most_scale = 16;

std::string format(const char *how, double value) {
    char text[64];
    const int length = std::snprintf(text, sizeof text, how, value);
    return {text, static_cast<size_t>(std::clamp(length, 0, static_cast<int>(sizeof text) - 1))};
}

/// Three digits, more where the number is large.
std::string short_number(double value) {
    const double size = std::abs(value);
    return format(size < 9.995 ? "%.2f" : size < 99.95 ? "%.1f" : "%.0f", value);
}

Rectangle moved(const Rectangle &area, int x, int y) {
    return {area.x0 + x, area.y0 + y, area.x1 + x, area.y1 + y};
}

class Display {
public:
    Display(const Canvas &canvas, const HudContent &content, int scale)
        : canvas_(canvas), content_(content), scale_(scale), room_(canvas.bounds().inset(margin_px * scale)) {}

    Rectangle draw() {
        if (content_.shows_figures || !content_.frame_times_ms.empty()) draw_figures();
        if (!content_.message.empty()) draw_message();
        if (content_.ray_tree) draw_rays(*content_.ray_tree);
        if (!content_.help.empty()) draw_help();
        return drawn_;
    }

private:
    Panel panel(const Rectangle &area) {
        const Panel made(canvas_, area.within(room_), scale_);
        drawn_ = drawn_.with(made.area());
        return made;
    }

    void draw_figures() {
        const bool has_graph = !content_.frame_times_ms.empty();
        const int rows = content_.shows_figures ? figure_rows + (content_.figures.is_paused ? 1 : 0) : 0;
        const int graph_rows = has_graph ? 1 : 0; // for its scale
        Rectangle size = Panel::size(figure_columns, rows + graph_rows, has_graph ? graph_px : 0, scale_);
        size.x1 += scale_; // which makes room for the graph's last bar
        const Panel made = panel(moved(size, room_.x0, room_.y0));
        figures_ = made.area();
        if (content_.shows_figures) write_figures(made);
        if (has_graph) draw_graph(made, rows);
    }

    void write_figures(const Panel &panel) const {
        const HudFigures &f = content_.figures;
        int row = 0;
        const auto write = [&](const std::string &left, const std::string &right) {
            panel.ends(row++, left, ink::dim, right, ink::bright);
        };
        const std::string target = content_.target_ms > 0.0f ? format("of %.0f", 1000.0 / content_.target_ms) : "";
        panel.ends(row++, short_number(f.fps) + " fps", ink::bright, target, ink::dim);
        write("render", short_number(f.render_ms) + " ms");
        write("upload", short_number(f.upload_ms) + " ms");
        write("GL", short_number(f.gl_ms) + " ms");
        write("rays", short_number(f.mrays_per_s) + " M/s");
        write(std::to_string(f.width_px) + "x" + std::to_string(f.height_px), format("%.0f%%", 100.0 * f.scale));
        write("depth " + std::to_string(f.depth),
              std::to_string(f.samples) + (f.samples == 1 ? " sample" : " samples"));
        write(std::to_string(f.threads) + (f.threads == 1 ? " thread" : " threads"), f.isa);
        if (f.is_paused) panel.text(row, "paused", ink::slow);
    }

    void draw_graph(const Panel &panel, int rows) const {
        const std::span<const float> times = content_.frame_times_ms.last(
            std::min<size_t>(content_.frame_times_ms.size(), HudContent::most_frame_times));
        const float top_ms = graph_top_ms(times, content_.target_ms);
        panel.ends(rows, "frames", ink::dim, short_number(top_ms) + " ms", ink::dim);
        draw_frame_graph(canvas_, panel.below(rows + 1), times, content_.target_ms, scale_);
    }

    /// Beside the figures where there is room for a useful list, else along the lower edge.
    void draw_rays(const RayTree &tree) {
        constexpr int useful_columns = 36;
        const Rectangle wanted = Panel::size(ray_list_columns, ray_list_rows(tree), 0, scale_);
        const int gap = margin_px * scale_;
        const int beside = room_.x1 - (figures_.empty() ? room_.x0 : figures_.x1 + gap);
        Rectangle area;
        if (beside >= Panel::size(useful_columns, 1, 0, scale_).width()) {
            const int width = std::min(beside, wanted.width());
            area = {room_.x1 - width, room_.y0, room_.x1, room_.y0 + std::min(wanted.height(), room_.height())};
        } else {
            const int below = room_.y1 - (figures_.empty() ? room_.y0 : figures_.y1 + gap);
            const int height = std::min(wanted.height(), std::max(below, room_.height() / 2));
            area = {room_.x0, room_.y1 - height, room_.x0 + std::min(wanted.width(), room_.width()), room_.y1};
        }
        draw_ray_list(panel(area), tree, content_.first_ray);
    }

    void draw_message() {
        const Rectangle size = Panel::size(columns_of(content_.message), 1, 0, scale_);
        const Panel made = panel(moved(size, room_.x0, room_.y1 - size.height()));
        made.text(0, content_.message, ink::bright);
        room_.y1 = made.area().y0 - margin_px * scale_; // the list of rays may lie along the same edge
    }

    void draw_help() {
        int key_columns = 0, columns = 0;
        for (const HudKey &key : content_.help) key_columns = std::max(key_columns, columns_of(key.keys));
        for (const HudKey &key : content_.help) {
            columns = std::max(columns, key_columns + 2 + columns_of(key.meaning));
        }
        const int rows = static_cast<int>(content_.help.size());
        const Rectangle size = Panel::size(columns, rows, 0, scale_);
        const Rectangle all = canvas_.bounds();
        const Panel made = panel(moved(size, std::max(room_.x0, (all.width() - size.width()) / 2),
                                       std::max(room_.y0, (all.height() - size.height()) / 2)));
        for (int row = 0; row < rows; ++row) {
            const HudKey &key = content_.help[static_cast<size_t>(row)];
            made.text(row, key.keys, ink::bright);
            made.text(row, key.meaning, ink::dim, key_columns + 2);
        }
    }

    const Canvas &canvas_;
    const HudContent &content_;
    int scale_;
    Rectangle room_;    ///< that panels may lie in
    Rectangle figures_; ///< where that panel lies
    Rectangle drawn_;
};

} // namespace

Rectangle draw_hud(const Canvas &canvas, const HudContent &content, uint32_t scale) {
    canvas.clear();
    return Display(canvas, content, static_cast<int>(std::clamp<uint32_t>(scale, 1, most_scale))).draw();
}

} // namespace glint::viewer
