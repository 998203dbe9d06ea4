// A scene on a phone's screen, moved with fingers: all that a view does that is not Android's own.
#include "android/session/view_session.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <thread>
#include <utility>

#include <glint/gles/context_facts.hpp>

#include "viewer/software_renderer.hpp"

namespace glint::android {

namespace {

/// A camera that has not moved for so long is at rest.
constexpr double rest_s = 0.15;
/// While something moves, input comes with every frame of the display: a frame that is asked for so soon follows the
/// one before.
constexpr double most_gap_s = 0.05;
/// While a frame is traced, input is looked for so often.
constexpr auto poll_interval = std::chrono::milliseconds(2);
/// A scene that moves by itself never jumps further, as after a pause.
constexpr double most_step_s = 0.25;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

unsigned thread_count(unsigned asked_for) {
    return asked_for != 0 ? asked_for : std::max(std::thread::hardware_concurrency(), 1u);
}

viewer::ViewChoices choices(uint32_t depth, unsigned threads) {
    viewer::ViewChoices choices;
    choices.depth = depth;
    choices.threads = threads;
    return choices;
}

constexpr uint8_t black[4] = {0, 0, 0, 255};

} // namespace

Result<std::unique_ptr<ViewSession>> ViewSession::create(std::shared_ptr<const Accel> accel,
                                                         std::shared_ptr<const Scene> scene,
                                                         const ViewOptions &options) {
    GovernorOptions governed;
    governed.target_fps = options.target_fps;
    governed.greatest_depth = options.depth.value_or(scene->picture().max_depth);
    Result<Governor> governor = Governor::create(governed);
    if (!governor) return std::move(governor).error();
    Result<egl::Egl> egl = egl::Egl::load();
    if (!egl) return std::move(egl).error();
    return std::unique_ptr<ViewSession>(new ViewSession(std::move(accel), std::move(scene), options, *governor, *egl));
}

ViewSession::ViewSession(std::shared_ptr<const Accel> accel, std::shared_ptr<const Scene> scene,
                         const ViewOptions &options, const Governor &governor, const egl::Egl &egl)
    : options_(options),
      depth_(governor.options().greatest_depth),
      egl_(egl),
      camera_(scene),
      controls_(
          camera_, choices(depth_, thread_count(options.threads)), [](double, double) { return std::nullopt; }, 1, 1),
      governor_(governor),
      playback_(std::move(accel), std::move(scene)),
      presenter_([this](bool is_lost) { return context(is_lost); }) {}

/// The presenter never makes a context; it waits for the view to bring one.
Result<gles::ProcLoader> ViewSession::context(bool is_lost) {
    if (context_ == nullptr || egl_.get_current_context() != context_) {
        return Error(ErrorCode::unsupported, "the view's OpenGL context is not current in this thread");
    }
    if (is_lost && !std::exchange(has_new_context_, false)) {
        return Error(ErrorCode::unsupported, "the OpenGL context is lost, and the view has no new one yet");
    }
    return gles::ProcLoader(
        [get = egl_.get_proc_address](const char *name) { return reinterpret_cast<void *>(get(name)); });
}

void ViewSession::context_created() {
    const std::lock_guard lock(drawing_);
    if (context_ != nullptr) presenter_.context_was_lost();
    has_new_context_ = true;
    context_ = egl_.get_current_context();
    const auto facts = gles::describe_context(
        [get = egl_.get_proc_address](const char *name) { return reinterpret_cast<void *>(get(name)); });
    filter_ = facts && !viewer::is_software(facts->renderer) ? gles::Filter::sharp : gles::Filter::bilinear;
}

void ViewSession::resize(uint32_t width_px, uint32_t height_px) {
    const std::lock_guard lock(drawing_);
    if (width_px == width_px_ && height_px == height_px_) return;
    width_px_ = width_px;
    height_px_ = height_px;
    viewer::InputEvent event;
    event.kind = viewer::InputEvent::Kind::resize;
    event.width_px = width_px;
    event.height_px = height_px;
    handle(event);
}

void ViewSession::handle(const viewer::InputEvent &event) {
    const std::lock_guard lock(input_);
    controls_.handle(event);
}

void ViewSession::trim() {
    const std::lock_guard lock(drawing_);
    pipeline_.reset();
    frame_ = nullptr;
    needs_frame_ = true;
    is_tracing_ = is_refining_ = is_final_ = is_in_motion_ = false;
    const std::lock_guard input_lock(input_);
    figures_.is_final = false;
}

ViewFigures ViewSession::figures() const {
    const std::lock_guard lock(input_);
    return figures_;
}

Result<double> ViewSession::draw() {
    const std::lock_guard lock(drawing_);
    if (width_px_ == 0) return never_again;
    if (!pipeline_) pipeline_ = std::make_unique<viewer::FramePipeline>();
    const Clock::time_point began = Clock::now();
    // In between the view swapped, and waited for the display.
    if (drawn_) waited_s_ += seconds_between(*drawn_, began);

    const auto deadline =
        began + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(most_wait_s));
    bool has_new = false;
    do {
        take_input();
        if (Status played = play(); !played) return played.error();
        request();
        const Result<bool> taken = take_frame(std::min(Clock::now() + poll_interval, deadline));
        if (!taken) return taken.error();
        has_new = *taken;
    } while (!has_new && (is_tracing_ || is_refining_) && Clock::now() < deadline);
    if (has_new) {
        // First let the tracer go on.
        take_input();
        if (Status played = play(); !played) return played.error();
        request();
    }
    if (Status shown = show(); !shown) return shown.error();
    drawn_ = Clock::now();
    return next_draw_s();
}

void ViewSession::take_input() {
    const std::lock_guard lock(input_);
    if (controls_.moves() == moves_) return;
    moves_ = controls_.moves();
    is_camera_taken_ = controls_.has_moved_camera();
    needs_frame_ = true;
    is_final_ = figures_.is_final = false;
    changed_ = Clock::now();
}

/// Lets time pass in a scene that moves by itself: one moment for each frame.
Status ViewSession::play() {
    if (playback_.is_over() || is_tracing_) return Done{};
    const Clock::time_point now = Clock::now();
    if (played_) play_s_ += std::min(seconds_between(*played_, now), most_step_s);
    played_ = now;
    const Result<bool> has_changed = playback_.go_to(play_s_);
    if (!has_changed) return has_changed.error();
    if (*has_changed) {
        needs_frame_ = true;
        is_final_ = false;
        changed_ = now;
    }
    return Done{};
}

/// Gives the tracer its next frame, where one is wanted and it has time.
void ViewSession::request() {
    if (is_tracing_) return;
    const Clock::time_point now = Clock::now();
    if (needs_frame_) {
        const bool follows = is_in_motion_ && seconds_between(taken_, now) < most_gap_s;
        submit(governor_.quality(), false, follows);
        is_tracing_ = is_in_motion_ = true;
        needs_frame_ = is_refining_ = false;
        return;
    }
    if (is_refining_ || is_final_ || seconds_between(changed_, now) < rest_s) return;
    {
        const std::lock_guard lock(input_);
        if (controls_.is_moving()) return;
    }
    submit({1.0f, depth_}, true, false);
    is_refining_ = true;
    is_in_motion_ = false;
}

void ViewSession::submit(const FrameQuality &quality, bool refines, bool follows) {
    const PictureSize size = scaled_size(width_px_, height_px_, quality.scale);
    viewer::FrameRequest request;
    request.accel = playback_.accel();
    request.how.max_depth = quality.depth;
    request.how.camera = camera();
    request.how.samples_per_pixel = 1;
    request.how.pattern = SamplePattern::centre;
    request.how.transfer = options_.transfer;
    request.width_px = size.width_px;
    request.height_px = size.height_px;
    request.quality = quality;
    request.threads = thread_count(options_.threads);
    request.refines = refines;
    request.follows = follows;
    pipeline_->submit(std::move(request));
}

/// The person's camera; while nobody has moved it, that of a scene whose eye moves by itself.
Camera ViewSession::camera() const {
    if (playback_.moves_eye() && !is_camera_taken_) {
        CameraControl moved(playback_.scene());
        moved.resize(width_px_, height_px_);
        return moved.camera();
    }
    const std::lock_guard lock(input_);
    return camera_.camera();
}

/// Whether there is a new frame.
Result<bool> ViewSession::take_frame(Clock::time_point deadline) {
    const Result<const viewer::Frame *> taken =
        pipeline_->take(is_tracing_ || is_refining_ ? deadline : Clock::time_point{});
    if (!taken) {
        is_tracing_ = is_refining_ = false;
        return taken.error();
    }
    if (*taken == nullptr) return false;
    frame_ = *taken;
    ++version_;
    taken_ = Clock::now();
    if (frame_->request.refines) {
        // Of a refinement that was given up, a pass may still have come.
        if (is_refining_) is_refining_ = !frame_->is_final;
        is_final_ = frame_->is_final && !needs_frame_ && !is_tracing_;
    } else {
        is_tracing_ = false;
    }
    return true;
}

Status ViewSession::show() {
    gles::Layer layer;
    layer.picture = frame_ != nullptr ? gles::PixelView(*frame_->picture) : gles::PixelView(black, 1, 1, 4);
    layer.width_px = static_cast<int>(width_px_);
    layer.height_px = static_cast<int>(height_px_);
    layer.how.filter = filter_;
    layer.version = frame_ != nullptr ? version_ : 0;
    const Result<gles::ShowTimes> times = presenter_.show(std::span(&layer, 1));
    if (!times) return times.error();
    if (frame_ != nullptr) tell(*times);
    return Done{};
}

/// Tells the governor and the app what the newest frame took, once.
void ViewSession::tell(const gles::ShowTimes &times) {
    const std::lock_guard lock(input_);
    figures_.context_losses = presenter_.losses();
    if (figures_.frames == version_) return;
    const Clock::time_point now = Clock::now();
    const viewer::FrameRequest &request = frame_->request;
    const double render_s = frame_->statistics.seconds;
    if (request.refines) {
        // A pass at rest costs what a frame in motion would: so the first one of those is in time already.
        governor_.measured(request.quality, {render_s, 0.0, render_s, 0.0});
    } else if (request.follows) {
        // Nobody worked while the view waited for the display and the tracer had nothing to do.
        const double frame_s = seconds_between(shown_, now);
        const double wait_s = std::clamp(waited_s_, 0.0, std::max(frame_s - render_s, 0.0));
        governor_.measured(request.quality, {render_s, times.upload_s + times.draw_s, frame_s, wait_s});
        interval_s_ = interval_s_ == 0.0 ? frame_s : interval_s_ + 0.1 * (frame_s - interval_s_);
        figures_.frames_a_second = 1.0 / interval_s_;
    }
    waited_s_ = 0.0;
    shown_ = now;

    figures_.frames = version_;
    figures_.render_ms = 1000.0 * render_s;
    figures_.width_px = request.width_px;
    figures_.height_px = request.height_px;
    figures_.depth = request.quality.depth;
    figures_.samples = frame_->samples;
    figures_.is_final = is_final_;
}

double ViewSession::next_draw_s() const {
    if (needs_frame_ || is_tracing_ || is_refining_ || !playback_.is_over()) return 0.0;
    if (is_final_) return never_again;
    {
        const std::lock_guard lock(input_);
        if (controls_.is_moving()) return never_again; // the finger will move, or be lifted
    }
    return std::max(rest_s - seconds_between(changed_, Clock::now()), 0.0);
}

} // namespace glint::android
