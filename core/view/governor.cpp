// Holds a frame rate by scale, then depth.
#include <glint/governor.hpp>

#include <algorithm>
#include <cmath>

namespace glint {

namespace {

// Shares of the time that a frame has. It aims a little below the whole, so that a loop that waits for its next turn
// seldom comes late.
constexpr double aim = 0.99;
constexpr double much_too_fast = 0.75, much_too_slow = 1.25;
/// So far from the aim a mean may lie, besides what noise may have done to it: so many times its standard deviation.
constexpr double tolerance = 0.02, noise_margin = 2.5;
/// Depth comes back where it is expected to take so much of what tracing may.
constexpr double deeper_share = 0.85;

/// Frames after which a mean is trusted. Before, only medians are, where they are far off.
constexpr uint32_t settled = 6;
/// What a level of depth costs as long as nobody has seen it, and what is believed of what was seen.
constexpr double guessed_cost = 2.0, least_cost = 1.05, greatest_cost = 16.0;

double median_of(const double (&v)[3]) {
    return std::max(std::min(v[0], v[1]), std::min(std::max(v[0], v[1]), v[2]));
}

bool is_time(double seconds) {
    return seconds >= 0.0 && seconds < 1e6; // false for NaN
}

/// What is wrong with the options, or nullptr. Written so that NaN fails.
const char *problem_of(const GovernorOptions &options) {
    if (!(options.target_fps > 0.0 && options.target_fps <= 1000.0)) {
        return "the frame rate to hold is not above 0 and at most 1000 frames a second";
    }
    if (!(options.least_scale > 0.0f && options.least_scale <= 1.0f)) {
        return "the least resolution scale is not above 0 and at most 1";
    }
    if (options.least_depth > options.greatest_depth) return "the least depth is above the greatest";
    return nullptr;
}

} // namespace

void Governor::Average::add(double value, uint32_t count, uint32_t window) {
    last[0] = last[1];
    last[1] = last[2];
    last[2] = value;
    if (count >= 3) mean += (median() - mean) / std::min(count - 2, window);
}

double Governor::Average::median() const {
    return median_of(last);
}

Governor::Governor(const GovernorOptions &options)
    : options_(options),
      quality_{1.0f, options.greatest_depth},
      window_(static_cast<uint32_t>(std::clamp(options.target_fps / 5.0, 6.0, 120.0))),
      deeper_costs_(guessed_cost) {}

Result<Governor> Governor::create(const GovernorOptions &options) {
    if (const char *problem = problem_of(options)) return Error(ErrorCode::bad_input, problem);
    return Governor(options);
}

void Governor::set_greatest_depth(uint32_t depth) {
    options_.greatest_depth = std::max(depth, options_.least_depth);
    change_to({quality_.scale, options_.greatest_depth});
    deeper_costs_ = guessed_cost;
    given_up_render_s_ = 0.0;
}

void Governor::measured(const FrameQuality &quality, const FrameTimes &times) {
    if (quality != quality_) return;
    if (!is_time(times.render_s) || !is_time(times.present_s) || !is_time(times.frame_s) || !is_time(times.wait_s)) {
        return;
    }
    ++frames_;
    render_.add(times.render_s, frames_, window_);
    const double explained = std::max(times.render_s, times.present_s);
    rest_.add(std::max(0.0, times.frame_s - times.wait_s - explained), frames_, window_);

    if (frames_ < 3) return;
    const double frame_s = 1.0 / options_.target_fps;
    const double lately_s = render_.median() + rest_.median();
    watch_noise(lately_s);
    if (lately_s > much_too_slow * frame_s || lately_s < much_too_fast * frame_s) {
        re_aim(render_.median(), rest_.median());
    }
    if (frames_ < settled || go_deeper()) return;
    const double uncertainty = noise_margin * noise_ / std::sqrt(std::min(frames_, 2 * window_));
    const double off_aim = (render_.mean + rest_.mean) / (aim * frame_s) - 1.0;
    if (std::abs(off_aim) > tolerance + uncertainty) re_aim(render_.mean, rest_.mean);
}

void Governor::watch_noise(double lately_s) {
    // Two numbers with standard deviation s differ by 1.13 s on average. What differs more than that is no noise.
    constexpr double share = 1.0 / 32.0, most = 0.3;
    const double change_s = render_.last[2] + rest_.last[2] - (render_.last[1] + rest_.last[1]);
    const double seen = std::abs(change_s) / (1.13 * std::max(lately_s, 1e-9));
    noise_ += share * (std::min(seen, most) - noise_);
}

double Governor::render_allowed_s(double rest_s) const {
    // Never nothing: what is divided by it stays finite.
    return std::max(aim / options_.target_fps - rest_s, 0.01 / options_.target_fps);
}

bool Governor::go_deeper() {
    if (quality_.depth == options_.greatest_depth) return false;
    const double shrinking = options_.least_scale / quality_.scale;
    const double at_least_s = std::max(render_.mean * shrinking * shrinking, 1e-9);
    if (given_up_render_s_ > 0.0) {
        deeper_costs_ = std::clamp(given_up_render_s_ / at_least_s, least_cost, greatest_cost);
        given_up_render_s_ = 0.0;
    }
    const double deeper_s = at_least_s * deeper_costs_;
    const double allowed_s = render_allowed_s(rest_.mean);
    if (deeper_s > deeper_share * allowed_s) return false;
    const double scale = options_.least_scale * std::sqrt(allowed_s / deeper_s);
    change_to({static_cast<float>(std::min(scale, 1.0)), quality_.depth + 1});
    return true;
}

void Governor::re_aim(double render_s, double rest_s) {
    const double allowed_s = render_allowed_s(rest_s);
    const bool is_least = quality_.scale <= options_.least_scale;
    if (is_least && render_s > allowed_s) {
        if (quality_.depth == options_.least_depth) return;
        change_to({quality_.scale, quality_.depth - 1});
        given_up_render_s_ = render_s;
        return;
    }
    const double scale = quality_.scale * std::sqrt(allowed_s / std::max(render_s, 1e-9));
    change_to({static_cast<float>(std::clamp(scale, double{options_.least_scale}, 1.0)), quality_.depth});
}

void Governor::change_to(const FrameQuality &quality) {
    if (quality == quality_) return;
    quality_ = quality;
    frames_ = 0;
    render_ = rest_ = {};
}

} // namespace glint
