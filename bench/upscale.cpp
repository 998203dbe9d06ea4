// Tracing at lower resolutions, enlarging, and comparing with the picture in full.
#include "bench/upscale.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <glint/renderer.hpp>

#include "bench/picture_quality.hpp"
#include "bench/shown_picture.hpp"

namespace glint::bench {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

uint32_t scaled(uint32_t side_px, double scale) {
    return static_cast<uint32_t>(std::max(1L, std::lround(side_px * scale)));
}

/// Draws what was uploaded over the whole of a surface.
class Screen {
public:
    Screen(gles::Surface &surface, gles::Presenter &presenter) : surface_(surface), presenter_(presenter) {}

    Status draw(gles::Filter filter) {
        const auto width = static_cast<int>(surface_.width_px()), height = static_cast<int>(surface_.height_px());
        if (Status drawn = presenter_.draw(0, 0, width, height, {.filter = filter}); !drawn) return drawn;
        surface_.finish();
        return Done{};
    }

    Result<std::vector<uint8_t>> shown(gles::Filter filter) {
        if (Status drawn = draw(filter); !drawn) return drawn.error();
        return surface_.read_back();
    }

    /// Milliseconds of as many draws as it takes.
    Result<std::vector<double>> time(gles::Filter filter, double min_seconds) {
        constexpr size_t min_draws = 5;
        std::vector<double> times_ms;
        const Clock::time_point begin = Clock::now();
        while (times_ms.size() < min_draws || ms_since(begin) < 1000.0 * min_seconds) {
            const Clock::time_point start = Clock::now();
            if (Status drawn = draw(filter); !drawn) return drawn.error();
            times_ms.push_back(ms_since(start));
        }
        return times_ms;
    }

private:
    gles::Surface &surface_;
    gles::Presenter &presenter_;
};

Result<Framebuffer> render(Renderer &renderer, uint32_t width_px, uint32_t height_px, RenderControl *control) {
    Result<Framebuffer> picture = Framebuffer::create(width_px, height_px, /*with_radiance=*/false);
    if (!picture) return picture;
    if (auto rendered = renderer.render(*picture, {}, control); !rendered) return rendered.error();
    return picture;
}

Result<UpscaleCell> measure_cell(Screen &screen, const NamedFilter &filter, const PicturePixels &full,
                                 double min_seconds) {
    const Result<std::vector<uint8_t>> shown = screen.shown(filter.filter);
    if (!shown) return shown.error();
    Result<std::vector<double>> times_ms = screen.time(filter.filter, min_seconds);
    if (!times_ms) return times_ms.error();
    const PicturePixels enlarged{*shown, full.width_px, full.height_px};
    UpscaleCell cell;
    cell.filter = filter.name;
    cell.psnr_db = psnr_db(enlarged, full);
    cell.ssim = ssim(enlarged, full);
    cell.draws = times_ms->size();
    cell.draw_ms = summarize(std::move(*times_ms));
    return cell;
}

} // namespace

const std::vector<NamedFilter> &upscale_filters() {
    static const std::vector<NamedFilter> filters = {
        {gles::Filter::nearest, "nearest"}, {gles::Filter::bilinear, "bilinear"}, {gles::Filter::sharp, "sharp"}};
    return filters;
}

Status measure_upscaling(std::shared_ptr<const Accel> accel, const std::string &scene_name, gles::Surface &surface,
                         const UpscaleOptions &options, UpscaleReport &report, RenderControl *control) {
    if (Status current = surface.make_current(); !current) return current;
    auto presenter = gles::Presenter::create(surface.proc_loader());
    if (!presenter) return presenter.error();
    Screen screen(surface, **presenter);
    Renderer renderer(std::move(accel), {.threads = options.threads});

    const Result<Framebuffer> picture = render(renderer, options.width_px, options.height_px, control);
    if (!picture) return picture.error();
    if (Status uploaded = (*presenter)->upload(*picture); !uploaded) return uploaded;
    for (const NamedFilter &filter : upscale_filters()) {
        const Result<std::vector<uint8_t>> shown = screen.shown(filter.filter);
        if (!shown) return shown.error();
        if (Status same = compare_shown(*picture, *shown); !same) return same;
    }
    const size_t byte_count = picture->rgba8_stride_bytes() * picture->height_px();
    const PicturePixels full{{picture->rgba8(), byte_count}, options.width_px, options.height_px};

    for (const double scale : options.scales) {
        if (options.on_scale) options.on_scale(scene_name, scale);
        UpscaleRow row{scene_name, scale, scaled(options.width_px, scale), scaled(options.height_px, scale), {}};
        const Result<Framebuffer> traced = render(renderer, row.traced_width_px, row.traced_height_px, control);
        if (!traced) return traced.error();
        if (Status uploaded = (*presenter)->upload(*traced); !uploaded) return uploaded;
        for (const NamedFilter &filter : upscale_filters()) {
            Result<UpscaleCell> cell = measure_cell(screen, filter, full, options.min_seconds);
            if (!cell) return cell.error();
            row.cells.push_back(std::move(*cell));
        }
        report.rows.push_back(std::move(row));
    }
    return Done{};
}

} // namespace glint::bench
