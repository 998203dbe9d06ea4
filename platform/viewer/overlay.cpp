// The heads-up display as it stands.
#include "viewer/overlay.hpp"

#include <utility>

namespace glint::viewer {

namespace {

constexpr auto refresh_interval = std::chrono::milliseconds(100);
constexpr auto message_time = std::chrono::seconds(4);

/// The mean of what the frames say.
HudFigures figures_of(const std::deque<ShownFrame> &frames, HudFigures figures) {
    if (frames.empty()) return figures;
    double render_s = 0.0, upload_s = 0.0, gl_s = 0.0, interval_s = 0.0, rays = 0.0;
    size_t intervals = 0;
    for (const ShownFrame &frame : frames) {
        render_s += frame.render_s;
        upload_s += frame.upload_s;
        gl_s += frame.gl_s;
        rays += static_cast<double>(frame.rays);
        interval_s += frame.interval_s;
        intervals += frame.interval_s > 0.0 ? 1 : 0;
    }
    const auto count = static_cast<double>(frames.size());
    figures.render_ms = 1000.0 * render_s / count;
    figures.upload_ms = 1000.0 * upload_s / count;
    figures.gl_ms = 1000.0 * gl_s / count;
    figures.fps = interval_s > 0.0 ? static_cast<double>(intervals) / interval_s : 0.0;
    figures.mrays_per_s = render_s > 0.0 ? rays / render_s / 1e6 : 0.0;
    const ShownFrame &last = frames.back();
    figures.depth = last.depth;
    figures.scale = last.scale;
    figures.samples = last.samples;
    figures.width_px = last.width_px;
    figures.height_px = last.height_px;
    return figures;
}

} // namespace

void Overlay::add(const ShownFrame &frame) {
    // Frames in motion and passes at rest tell of different things.
    if (!frames_.empty() && frames_.back().refines != frame.refines) frames_.clear();
    frames_.push_back(frame);
    if (frames_.size() > HudContent::most_frame_times) frames_.pop_front();
    if (frame.interval_s > 0.0) {
        times_ms_.push_back(static_cast<float>(1000.0 * frame.interval_s));
        if (times_ms_.size() > HudContent::most_frame_times) times_ms_.erase(times_ms_.begin());
    }
    has_new_frames_ = true;
}

void Overlay::say(std::string message) {
    message_ = std::move(message);
    is_new_message_ = is_stale_ = true;
}

bool Overlay::has_old_message(Clock::time_point now) const {
    return !message_.empty() && !is_new_message_ && now - said_ > message_time;
}

Overlay::Pixels Overlay::draw(HudContent content, uint32_t width_px, uint32_t height_px, uint32_t scale,
                              Clock::time_point now) {
    if (std::exchange(is_new_message_, false)) said_ = now;
    if (has_old_message(now)) {
        message_.clear();
        is_stale_ = true;
    }
    const bool is_old = has_new_frames_ && now - drawn_ > refresh_interval && content.shows_figures;
    if (!is_stale_ && !is_old && width_px == width_px_ && height_px == height_px_) return pixels_;

    width_px_ = width_px;
    height_px_ = height_px;
    is_stale_ = has_new_frames_ = false;
    drawn_ = now;
    const size_t stride_bytes = size_t{width_px} * 4;
    canvas_.resize(stride_bytes * height_px);
    content.figures = figures_of(frames_, std::move(content.figures));
    if (content.shows_figures) content.frame_times_ms = times_ms_;
    content.message = message_;
    const Rectangle drawn = draw_hud(Canvas(canvas_.data(), width_px, height_px, stride_bytes), content, scale);
    const uint64_t version = pixels_.version + 1;
    pixels_ = {};
    pixels_.version = version;
    if (!drawn.empty()) {
        pixels_.x = drawn.x0;
        pixels_.y = drawn.y0;
        pixels_.pixels = gles::PixelView(
            canvas_.data() + static_cast<size_t>(drawn.y0) * stride_bytes + static_cast<size_t>(drawn.x0) * 4,
            static_cast<uint32_t>(drawn.width()), static_cast<uint32_t>(drawn.height()), stride_bytes);
    }
    return pixels_;
}

} // namespace glint::viewer
