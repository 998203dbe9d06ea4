// A scene on a screen, moved through: the loop from events to pictures.
#include "viewer/viewer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <utility>
#include <vector>

#include <glint/camera_control.hpp>
#include <glint/gles/reliable_presenter.hpp>
#include <glint/governor.hpp>
#include <glint/imageio.hpp>
#include <glint/ray_query.hpp>
#include <glint/ray_tree.hpp>

#include "viewer/controls.hpp"
#include "viewer/frame_pipeline.hpp"
#include "viewer/overlay.hpp"
#include "viewer/playback.hpp"
#include "viewer/software_renderer.hpp"

namespace glint::viewer {

namespace {

/// Held where nothing else is asked for.
constexpr double usual_fps = 60.0;
/// A camera that has not moved for so long is at rest.
constexpr double rest_s = 0.15;
/// While a frame is traced, events are looked for so often; an input that nobody expected stops a refinement so fast.
constexpr auto poll_interval = std::chrono::milliseconds(2);
/// Input comes this often while something moves: a frame that is asked for so soon follows the one before.
constexpr double most_gap_s = 0.012;
/// While nothing happens at all.
constexpr double idle_wait_s = 0.05;

using Seconds = std::chrono::duration<double>;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return Seconds(to - from).count();
}
Clock::time_point after(Clock::time_point time, double seconds) {
    return time + std::chrono::duration_cast<Clock::duration>(Seconds(seconds));
}

/// What swapping costs, told from what it waits: the shortest of the last swaps waited for nothing.
class SwapCost {
public:
    /// Of a swap that took so long, the part that was waiting for the display.
    double waited_s(double swap_s) {
        last_.push_back(swap_s);
        if (last_.size() > 60) last_.pop_front();
        return swap_s - *std::min_element(last_.begin(), last_.end());
    }

private:
    std::deque<double> last_;
};

/// The distance to what is seen at a place of the window.
std::optional<double> distance_at(const std::shared_ptr<const Accel> &accel, const CameraControl &camera, double x,
                                  double y) {
    const Point eye = camera.camera().eye;
    const Vector direction(camera.direction_to({x, y}));
    const float t_max = max_coordinate;
    RayBatch ray{1, &eye.x, &eye.y, &eye.z, &direction.x, &direction.y, &direction.z, &t_max};
    float t = 0.0f;
    uint32_t triangle = no_triangle;
    RayQuery(accel, Isa::scalar).closest_hits(ray, {&t, &triangle});
    if (triangle == no_triangle) return std::nullopt;
    return t;
}

class Loop {
public:
    Loop(Window &window, ViewOptions options, Governor governor)
        : window_(window),
          options_(std::move(options)),
          governor_(std::move(governor)),
          camera_(options_.scene),
          playback_(options_.accel, options_.scene),
          controls_(
              camera_, first_choices(),
              [this](double x, double y) { return distance_at(playback_.accel(), camera_, x, y); }, window.width_px(),
              window.height_px()),
          presenter_([this](bool is_lost) { return window_.context(is_lost); }),
          began_(Clock::now()) {
        if (options_.fps) interval_s_ = 1.0 / *options_.fps;
        filter_ = is_software(window.gl_description()) ? gles::Filter::bilinear : gles::Filter::sharp;
        camera_.resize(window.width_px(), window.height_px());
    }

    Result<FrameLog> run() {
        while (!is_over()) {
            if (Status status = turn(); !status) return status.error();
        }
        if (options_.screenshot) {
            if (Status status = save(*options_.screenshot); !status) return status.error();
        }
        return std::move(log_);
    }

private:
    [[nodiscard]] ViewChoices first_choices() const {
        ViewChoices choices;
        choices.depth = options_.depth;
        choices.threads = options_.threads;
        choices.shows_figures = options_.shows_figures;
        return choices;
    }

    [[nodiscard]] bool records() const { return options_.record_folder.has_value(); }

    /// Seconds since the beginning; while frames are recorded, each lasts as long as it will when they are played.
    [[nodiscard]] double now_s() const {
        if (records()) return static_cast<double>(log_.count()) / options_.fps.value_or(usual_fps);
        return seconds_between(began_, Clock::now());
    }

    [[nodiscard]] bool is_over() const {
        if (controls_.choices().closes || options_.is_interrupted()) return true;
        if (options_.frames && log_.count() >= *options_.frames) return true;
        const bool script_is_over = !options_.script || !options_.script->next_seconds();
        if (!script_is_over || !options_.ends_at_rest) return false;
        if (!playback_.is_over()) return false;
        return records() ? log_.count() > 0 : is_final_ && !needs_frame_;
    }

    // One turn: input, then a finished frame is shown while the next one is being traced.
    Status turn() {
        take_input(wait_s());
        if (Status played = play(); !played) return played;
        request();
        const auto deadline = Clock::now() + (is_tracing_ || is_refining_ ? poll_interval : Clock::duration::zero());
        const Result<const Frame *> taken = pipeline_.take(deadline);
        if (!taken) return taken.error();
        if (const Frame *const frame = *taken) {
            frame_ = frame;
            taken_ = Clock::now();
            if (!frame->request.refines) is_tracing_ = false;
            if (frame->request.refines && frame->is_final) is_refining_ = false;
            is_final_ = frame->request.refines && frame->is_final;
            // First let the tracer go on.
            take_input(0.0);
            if (Status played = play(); !played) return played;
            request();
            return show_new_frame();
        }
        if (needs_show_ && frame_) return show_again();
        return Done{};
    }

    /// How long there is nothing to do but wait for input.
    [[nodiscard]] double wait_s() const {
        if (needs_show_ || is_tracing_ || is_refining_ || records()) return 0.0;
        double wait = idle_wait_s;
        if (needs_frame_ || controls_.is_flying() || (!playback_.is_over() && !controls_.choices().is_paused)) {
            wait = seconds_between(Clock::now(), next_due_);
        } else if (!is_final_ && !controls_.choices().is_paused) {
            wait = std::min(wait, rest_s - seconds_between(changed_, Clock::now()));
        }
        if (options_.script && options_.script->next_seconds()) {
            wait = std::min(wait, *options_.script->next_seconds() - now_s());
        }
        return std::max(wait, 0.0);
    }

    void take_input(double wait) {
        const Clock::time_point before = Clock::now();
        events_.clear();
        window_.take_events(wait, events_);
        if (wait > 0.0) waited_s_ += seconds_between(before, Clock::now());

        const uint64_t moves = controls_.moves();
        const ViewChoices chosen = controls_.choices();
        const Clock::time_point now = Clock::now();
        // The keys that were held until now.
        const double time_s = now_s();
        controls_.advance(std::min(time_s - std::exchange(advanced_s_, time_s), 0.25));
        std::optional<Clock::time_point> input_time;
        if (controls_.moves() != moves) input_time = now;
        for (const InputEvent &event : events_) handle(event);
        if (!events_.empty() && !input_time) input_time = now;
        if (options_.script) {
            scripted_.clear();
            options_.script->take_until(now_s(), scripted_);
            for (const TimedEvent &timed : scripted_) {
                // A script may change the window; what a window tells about itself comes from the window.
                if (timed.event.kind == InputEvent::Kind::resize) {
                    if (Status resized = window_.resize(timed.event.width_px, timed.event.height_px); !resized) {
                        options_.say(resized.error().text());
                    }
                    continue;
                }
                handle(timed.event);
                if (!input_time) input_time = std::min(now, after(began_, timed.seconds));
            }
        }

        const ViewChoices &choices = controls_.choices();
        if (choices.depth != chosen.depth) governor_.set_greatest_depth(choices.depth);
        if (controls_.moves() != moves) is_camera_taken_ = controls_.has_moved_camera();
        if (controls_.moves() != moves || choices.depth != chosen.depth || choices.threads != chosen.threads) {
            needs_frame_ = true;
            is_final_ = false;
            changed_ = now;
            if (!input_time_) input_time_ = input_time;
        }
        if (choices.is_paused && !chosen.is_paused) {
            pipeline_.stop_refining();
            is_refining_ = false;
        }
        if (choices.shows_figures != chosen.shows_figures || choices.shows_help != chosen.shows_help ||
            choices.inspected != chosen.inspected || choices.first_ray != chosen.first_ray ||
            choices.is_paused != chosen.is_paused) {
            needs_show_ = true;
            overlay_.invalidate();
        }
        if (choices.screenshots != chosen.screenshots || overlay_.has_old_message(now)) needs_show_ = true;
    }

    /// Lets time pass in a scene that moves by itself.
    Status play() {
        const double time_s = now_s(), passed_s = time_s - std::exchange(played_s_, time_s);
        // One moment for each frame: what is being traced is shown first.
        if (controls_.choices().is_paused || playback_.is_over()) return Done{};
        play_s_ += passed_s;
        if (is_tracing_ || Clock::now() < next_due_) return Done{};
        const Result<bool> has_changed = playback_.go_to(play_s_);
        if (!has_changed) return has_changed.error();
        if (*has_changed) {
            needs_frame_ = true;
            is_final_ = false;
            changed_ = Clock::now();
        }
        return Done{};
    }

    void handle(const InputEvent &event) {
        if (event.kind == InputEvent::Kind::context_lost) presenter_.context_was_lost();
        if (event.kind == InputEvent::Kind::context_lost || event.kind == InputEvent::Kind::redraw) needs_show_ = true;
        controls_.handle(event);
    }

    /// Gives the tracer its next frame, where one is wanted, it has time, and it is time.
    void request() {
        if (is_tracing_) return;
        const ViewChoices &choices = controls_.choices();
        const Clock::time_point now = Clock::now();
        if (needs_frame_ || records()) {
            if (!records() && now < next_due_) return;
            const bool follows = seconds_between(std::max(next_due_, taken_), now) < most_gap_s;
            // A frame that came late may be made up for by the next one.
            next_due_ = std::max(after(next_due_, interval_s_), after(now, -interval_s_));
            const FrameQuality quality = records() ? FrameQuality{1.0f, choices.depth} : governor_.quality();
            submit(quality, false, follows && is_in_motion_);
            is_in_motion_ = true;
            needs_frame_ = false;
            is_tracing_ = true;
            is_refining_ = false;
        } else if (!is_refining_ && !is_final_ && !choices.is_paused && !controls_.is_moving() &&
                   seconds_between(changed_, now) >= rest_s) {
            submit({1.0f, choices.depth}, true, false);
            is_refining_ = true;
            is_in_motion_ = false;
        }
    }

    void submit(const FrameQuality &quality, bool refines, bool follows) {
        const PictureSize size = scaled_size(window_.width_px(), window_.height_px(), quality.scale);
        FrameRequest request;
        request.accel = playback_.accel();
        request.how = how(quality.depth);
        request.width_px = size.width_px;
        request.height_px = size.height_px;
        request.quality = quality;
        request.threads = controls_.choices().threads;
        request.isa = options_.isa;
        request.refines = refines;
        request.follows = follows;
        request.input_time = std::exchange(input_time_, std::nullopt);
        pipeline_.submit(std::move(request));
    }

    [[nodiscard]] RenderOptions how(uint32_t depth) const {
        RenderOptions how;
        how.max_depth = depth;
        how.camera = camera();
        how.samples_per_pixel = 1;
        how.pattern = SamplePattern::centre;
        how.transfer = options_.transfer;
        return how;
    }

    /// The person's camera; while nobody has moved it, that of a scene whose eye moves by itself.
    [[nodiscard]] Camera camera() const {
        if (!playback_.moves_eye() || is_camera_taken_) return camera_.camera();
        CameraControl moved(playback_.scene());
        moved.resize(window_.width_px(), window_.height_px());
        return moved.camera();
    }

    Status show_new_frame() {
        const FrameRequest &request = frame_->request;
        Result<gles::ShowTimes> times = draw(!records());
        if (!times) return times.error();
        if (Status saved = save_what_was_asked_for(); !saved) return saved;
        const Clock::time_point before_swap = Clock::now();
        swap();
        const Clock::time_point now = Clock::now();
        const double swap_s = seconds_between(before_swap, now), swap_wait_s = swap_cost_.waited_s(swap_s);

        ShownFrame shown;
        shown.shown_s = records() ? now_s() : seconds_between(began_, now);
        shown.interval_s = request.follows ? seconds_between(shown_, now) : 0.0;
        shown.render_s = frame_->statistics.seconds;
        shown.upload_s = times->upload_s;
        shown.gl_s = times->draw_s + swap_s - swap_wait_s;
        shown.wait_s = std::exchange(waited_s_, 0.0) + swap_wait_s;
        if (request.input_time && !records()) shown.latency_s = seconds_between(*request.input_time, now);
        if (frame_->stop_s) shown.stop_s = *frame_->stop_s;
        shown.rays = frame_->statistics.rays();
        shown.width_px = request.width_px;
        shown.height_px = request.height_px;
        shown.depth = request.quality.depth;
        shown.samples = frame_->samples;
        shown.scale = request.quality.scale;
        shown.refines = request.refines;
        log_.add(shown);
        overlay_.add(shown);
        tell_governor(shown, request.quality);
        shown_ = now;
        return Done{};
    }

    void tell_governor(const ShownFrame &shown, const FrameQuality &quality) {
        if (records()) return;
        if (shown.refines) {
            // A pass at rest costs what a frame in motion would: so the first one of those is in time already.
            governor_.measured(quality, {shown.render_s, 0.0, shown.render_s, 0.0});
        } else if (shown.interval_s > 0.0) {
            governor_.measured(quality, {shown.render_s, shown.upload_s + shown.gl_s, shown.interval_s, shown.wait_s});
        }
    }

    Status show_again() {
        if (const auto times = draw(true); !times) return times.error();
        if (Status saved = save_what_was_asked_for(); !saved) return saved;
        swap();
        return Done{};
    }

    void swap() {
        if (!window_.swap()) {
            presenter_.context_was_lost();
            needs_show_ = true;
        }
    }

    /// Draws the frame, and over it what there is to say.
    Result<gles::ShowTimes> draw(bool with_overlay) {
        needs_show_ = false;
        const auto width_px = static_cast<int>(window_.width_px()), height_px = static_cast<int>(window_.height_px());
        std::array<gles::Layer, 2> layers;
        layers[0] = {*frame_->picture, 0, 0, width_px, height_px, {filter_, gles::Blend::replace}, frame_->number};
        size_t count = 1;
        if (with_overlay) {
            const Overlay::Pixels overlay = overlay_of_this_frame();
            if (overlay.pixels.width_px > 0) {
                layers[1] = {overlay.pixels,
                             overlay.x,
                             height_px - overlay.y - static_cast<int>(overlay.pixels.height_px),
                             static_cast<int>(overlay.pixels.width_px),
                             static_cast<int>(overlay.pixels.height_px),
                             {gles::Filter::nearest, gles::Blend::straight},
                             overlay.version};
                count = 2;
            }
        }
        return presenter_.show(std::span(layers).first(count), {.finish = false});
    }

    Overlay::Pixels overlay_of_this_frame() {
        const ViewChoices &choices = controls_.choices();
        if (choices.inspected != inspected_) {
            inspected_ = choices.inspected;
            ray_tree_.reset();
            if (inspected_) {
                auto tree = trace_ray_tree(*playback_.accel(), how(choices.depth), window_.width_px(),
                                           window_.height_px(), inspected_->x, inspected_->y);
                if (tree) {
                    ray_tree_ = std::move(*tree);
                } else {
                    overlay_.say(tree.error().text());
                }
            }
        }
        HudContent content;
        content.shows_figures = choices.shows_figures;
        if (choices.shows_help) content.help = help_lines();
        content.ray_tree = ray_tree_ ? &*ray_tree_ : nullptr;
        content.first_ray = choices.first_ray;
        content.target_ms = static_cast<float>(1000.0 / governor_.options().target_fps);
        content.figures.threads = choices.threads;
        content.figures.isa = isa_name(options_.isa);
        content.figures.is_paused = choices.is_paused;
        return overlay_.draw(content, window_.width_px(), window_.height_px(),
                             std::max(1u, static_cast<uint32_t>(std::lround(window_.density()))), Clock::now());
    }

    Status save_what_was_asked_for() {
        if (records()) {
            char name[32];
            std::snprintf(name, sizeof name, "frame.%04llu.png", static_cast<unsigned long long>(log_.count()));
            if (Status saved = write_shown(*options_.record_folder / name); !saved) return saved;
        }
        while (screenshots_ < controls_.choices().screenshots) {
            ++screenshots_;
            const std::filesystem::path file = free_name();
            const Status saved = save(file);
            // A full disk is no reason to end; the person sees it.
            overlay_.say(saved ? "saved " + file.filename().string() : saved.error().text());
            needs_show_ = true;
        }
        return Done{};
    }

    /// The first name that no file has.
    [[nodiscard]] std::filesystem::path free_name() const {
        for (unsigned number = 1;; ++number) {
            char name[32];
            std::snprintf(name, sizeof name, "glint-%04u.png", number);
            std::filesystem::path file = options_.screenshot_folder / name;
            std::error_code error;
            if (!std::filesystem::exists(file, error)) return file;
        }
    }

    /// What is shown, without what is said over it.
    Status save(const std::filesystem::path &file) {
        if (!frame_) return Error(ErrorCode::cancelled, "no frame was shown, so there is nothing to save");
        if (const auto times = draw(false); !times) return times.error();
        return write_shown(file);
    }

    Status write_shown(const std::filesystem::path &file) {
        const Result<std::vector<uint8_t>> pixels = window_.read_back();
        if (!pixels) return pixels.error();
        Result<Framebuffer> picture = Framebuffer::create(window_.width_px(), window_.height_px(), false);
        if (!picture) return picture.error();
        std::memcpy(picture->rgba8(), pixels->data(), pixels->size());
        return write_image(file, *picture);
    }

    Window &window_;
    ViewOptions options_;
    Governor governor_;
    CameraControl camera_;
    Playback playback_;
    Controls controls_;
    gles::ReliablePresenter presenter_;
    FramePipeline pipeline_;
    Overlay overlay_;
    FrameLog log_;
    SwapCost swap_cost_;

    Clock::time_point began_, taken_, shown_, changed_, next_due_;
    gles::Filter filter_ = gles::Filter::bilinear; // where a picture is smaller than the window
    double interval_s_ = 0.0;                      // between frames, at least
    double advanced_s_ = 0.0, played_s_ = 0.0, play_s_ = 0.0, waited_s_ = 0.0;
    bool is_camera_taken_ = false;                // from the scene, by a person
    std::optional<Clock::time_point> input_time_; // of the first event that no frame shows yet
    bool needs_frame_ = true, needs_show_ = false, is_tracing_ = false, is_refining_ = false, is_final_ = false;
    bool is_in_motion_ = false; // whether the last frame asked for was one in motion
    const Frame *frame_ = nullptr;
    std::optional<PixelPlace> inspected_;
    std::optional<RayTree> ray_tree_;
    uint32_t screenshots_ = 0;
    std::vector<InputEvent> events_;
    std::vector<TimedEvent> scripted_;
};

} // namespace

Result<FrameLog> view(Window &window, ViewOptions options) {
    const double display_fps = window.refresh_rate() > 0.0 ? window.refresh_rate() : usual_fps;
    GovernorOptions governed;
    governed.target_fps = options.fps.value_or(display_fps);
    governed.greatest_depth = options.depth;
    Result<Governor> governor = Governor::create(governed);
    if (!governor) return governor.error();
    window.set_title(options.name + " - Glint");
    return Loop(window, std::move(options), std::move(*governor)).run();
}

} // namespace glint::viewer
