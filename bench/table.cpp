// The timing table of the 2013 paper, measured on this machine: one row for each size and depth.
#include "bench/table.hpp"

#include <chrono>
#include <utility>

#include <glint/gles/presenter.hpp>

#include "bench/shown_picture.hpp"

namespace glint::bench {
namespace {

using Clock = std::chrono::steady_clock;

double ms_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

struct FrameTimes {
    double render_ms = 0.0;
    double upload_ms = 0.0;
    double gl_ms = 0.0;
};

/// Every frame's times of one row.
struct Samples {
    std::vector<double> render_ms, upload_ms, gl_ms, time_to_image_ms;

    void add(const FrameTimes &frame) {
        render_ms.push_back(frame.render_ms);
        upload_ms.push_back(frame.upload_ms);
        gl_ms.push_back(frame.gl_ms);
        time_to_image_ms.push_back(frame.render_ms + frame.upload_ms + frame.gl_ms);
    }
};

/// Renders, uploads and draws one picture after another; the paper's Application and Renderer in one.
class FrameLoop {
public:
    FrameLoop(Renderer &renderer, gles::Surface *surface, gles::Presenter *presenter, RenderControl *control)
        : renderer_(renderer), surface_(surface), presenter_(presenter), control_(control) {}

    /// One frame into `picture` and onto the surface.
    Result<FrameTimes> frame(Framebuffer &picture, const RenderOptions &options) {
        FrameTimes times;
        const Clock::time_point start = Clock::now();
        Result<RenderStatistics> rendered = renderer_.render(picture, options, control_);
        if (!rendered) return rendered.error();
        const Clock::time_point traced = Clock::now();
        times.render_ms = ms_between(start, traced);
        rays_ = rendered->rays();
        if (!surface_) return times;

        if (Status uploaded = presenter_->upload(picture); !uploaded) return uploaded.error();
        surface_->finish();
        const Clock::time_point uploaded_at = Clock::now();
        times.upload_ms = ms_between(traced, uploaded_at);

        const int width = static_cast<int>(picture.width_px()), height = static_cast<int>(picture.height_px());
        if (Status drawn = presenter_->draw(0, 0, width, height); !drawn) return drawn.error();
        surface_->finish();
        times.gl_ms = ms_between(uploaded_at, Clock::now());
        return times;
    }

    /// Of the latest frame.
    [[nodiscard]] uint64_t rays() const { return rays_; }

private:
    Renderer &renderer_;
    gles::Surface *surface_;
    gles::Presenter *presenter_;
    RenderControl *control_;
    uint64_t rays_ = 0;
};

/// Fills caches, wakes threads, lets the driver compile: frames that would not be like those that follow.
Status warm_up(FrameLoop &loop, Framebuffer &picture, const RenderOptions &render, double seconds) {
    constexpr int min_frames = 3;
    const Clock::time_point start = Clock::now();
    for (int frame = 0; frame < min_frames || ms_between(start, Clock::now()) < 1000.0 * seconds; ++frame) {
        if (Result<FrameTimes> times = loop.frame(picture, render); !times) return times.error();
    }
    return Done{};
}

Result<Row> measure_row(FrameLoop &loop, Framebuffer &picture, uint32_t depth, const TableOptions &options) {
    const RenderOptions render{.max_depth = depth, .camera = {}};
    if (Status warm = warm_up(loop, picture, render, 0.1 * options.min_seconds); !warm) return warm.error();

    Samples samples;
    Row row;
    row.width_px = picture.width_px();
    row.height_px = picture.height_px();
    row.depth = depth;
    const Clock::time_point start = Clock::now();
    double loop_ms = 0.0;
    while (row.frames < options.min_frames || loop_ms < 1000.0 * options.min_seconds) {
        const Result<FrameTimes> times = loop.frame(picture, render);
        if (!times) return times.error();
        samples.add(*times);
        ++row.frames;
        loop_ms = ms_between(start, Clock::now());
    }
    row.render_ms = summarize(std::move(samples.render_ms));
    row.upload_ms = summarize(std::move(samples.upload_ms));
    row.gl_ms = summarize(std::move(samples.gl_ms));
    row.time_to_image_ms = summarize(std::move(samples.time_to_image_ms));
    row.fps = 1000.0 / row.time_to_image_ms.median;
    row.loop_fps = 1000.0 * static_cast<double>(row.frames) / loop_ms;
    row.rays = loop.rays();
    row.mrays_per_s = static_cast<double>(row.rays) / (1000.0 * row.render_ms.median);
    return row;
}

Status check_surface(gles::Surface &surface, const Framebuffer &picture) {
    const Result<std::vector<uint8_t>> shown = surface.read_back();
    if (!shown) return shown.error();
    return compare_shown(picture, *shown);
}

} // namespace

Result<Table> measure_table(std::shared_ptr<const Accel> accel, std::string scene_name, gles::Surface *surface,
                            const TableOptions &options, RenderControl *control) {
    Renderer renderer(std::move(accel), {.threads = options.threads, .isa = options.isa});
    Table table{.machine = describe_machine(),
                .scene = std::move(scene_name),
                .threads = renderer.threads(),
                .isa = std::string(isa_name(renderer.isa())),
                .surface = surface ? surface->kind() : "none",
                .gl_description = {},
                .rows = {}};

    std::unique_ptr<gles::Presenter> presenter;
    if (surface) {
        if (Status current = surface->make_current(); !current) return current.error();
        table.gl_description = surface->gl_description();
        auto created = gles::Presenter::create(surface->proc_loader());
        if (!created) return created.error();
        presenter = std::move(*created);
    }

    FrameLoop loop(renderer, surface, presenter.get(), control);
    for (const uint32_t size_px : options.sizes_px) {
        Result<Framebuffer> picture = Framebuffer::create(size_px, size_px, /*with_radiance=*/false);
        if (!picture) return picture.error();
        if (surface) {
            if (Status resized = surface->resize(size_px, size_px); !resized) return resized.error();
        }
        for (const uint32_t depth : options.depths) {
            if (options.on_row) options.on_row(size_px, depth);
            Result<Row> row = measure_row(loop, *picture, depth, options);
            if (!row) return row.error();
            if (surface) {
                if (Status same = check_surface(*surface, *picture); !same) return same.error();
            }
            table.rows.push_back(std::move(*row));
        }
    }
    return table;
}

} // namespace glint::bench
