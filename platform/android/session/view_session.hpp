// A scene on a phone's screen, moved with fingers: all that a view does that is not Android's own.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include <glint/accel.hpp>
#include <glint/camera_control.hpp>
#include <glint/gles/reliable_presenter.hpp>
#include <glint/governor.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

#include "egl/library.hpp"
#include "viewer/controls.hpp"
#include "viewer/frame_pipeline.hpp"
#include "viewer/playback.hpp"

namespace glint::android {

using viewer::Clock;

struct ViewOptions {
    double target_fps = 60.0; ///< that the governor holds while something moves: the display's
    /// Recursive rays in a row; unset = what the scene asks for.
    std::optional<uint32_t> depth = std::nullopt;
    unsigned threads = 0; ///< that trace; 0 = one a processor
    Transfer transfer = Transfer::linear;
};

/// What the frame that is on the screen was like.
struct ViewFigures {
    uint64_t frames = 0;         ///< shown so far
    double frames_a_second = 0;  ///< lately, while something moved
    double render_ms = 0.0;      ///< tracing it
    uint32_t width_px = 0;       ///< of the picture, which fills the view
    uint32_t height_px = 0;      ///< likewise
    uint32_t depth = 0;          ///< recursive rays in a row
    uint32_t samples = 0;        ///< a pixel
    bool is_final = false;       ///< at rest, and no better one will follow
    uint64_t context_losses = 0; ///< so far
};

/// Owns camera, governor, tracer and presenter of one view. It has no thread that draws: whoever owns a window and an
/// OpenGL ES context (a GLSurfaceView, a test) calls draw() with the context current and swaps afterwards; frame n + 1
/// is traced while that happens to frame n.
///
/// Any thread may call anything at any time; the drawing thread's calls wait for each other.
class ViewSession {
public:
    /// The scene is the structure's own. Fails with bad_input where the options are out of range, with `unsupported`
    /// where there is no EGL.
    [[nodiscard]] static Result<std::unique_ptr<ViewSession>>
    create(std::shared_ptr<const Accel> accel, std::shared_ptr<const Scene> scene, const ViewOptions &options);
    ViewSession(const ViewSession &) = delete;
    ViewSession &operator=(const ViewSession &) = delete;

    /// There is a new context, current in this thread; what was in the one before is gone.
    void context_created();
    /// The view has another size, in pixels, each at least 1.
    void resize(uint32_t width_px, uint32_t height_px);

    /// Draws the newest picture over the whole of the current framebuffer, and has the next one traced where there is
    /// something to show. While one is being traced, waits for it, at most most_wait_s; then the one before is drawn
    /// again. Returns when to call again, in seconds: 0 at once, never_again = once there was input. Fails where no
    /// context is current or OpenGL does; may be called again after context_created().
    [[nodiscard]] Result<double> draw();
    static constexpr double most_wait_s = 0.1;
    static constexpr double never_again = std::numeric_limits<double>::infinity();

    /// A finger, or a key of the viewer's that means something here (R, F); draw() is to be called afterwards.
    void handle(const viewer::InputEvent &event);
    /// Gives up all memory that the next draw() can make again: pictures and the tracer with its threads.
    void trim();

    [[nodiscard]] ViewFigures figures() const;

private:
    ViewSession(std::shared_ptr<const Accel> accel, std::shared_ptr<const Scene> scene, const ViewOptions &options,
                const Governor &governor, const egl::Egl &egl);

    Result<gles::ProcLoader> context(bool is_lost);
    void take_input();
    Status play();
    void request();
    void submit(const FrameQuality &quality, bool refines, bool follows);
    [[nodiscard]] Camera camera() const;
    Result<bool> take_frame(Clock::time_point deadline);
    Status show();
    void tell(const gles::ShowTimes &times);
    [[nodiscard]] double next_draw_s() const;

    const ViewOptions options_;
    const uint32_t depth_;
    const egl::Egl egl_;

    mutable std::mutex input_; // held for a few instructions
    CameraControl camera_;
    viewer::Controls controls_;
    ViewFigures figures_;

    std::mutex drawing_; // held by draw(), whose all the rest is
    Governor governor_;
    viewer::Playback playback_;
    const void *context_ = nullptr; // that OpenGL's objects are in
    bool has_new_context_ = false;
    gles::Filter filter_ = gles::Filter::bilinear; // where a picture is smaller than the view
    gles::ReliablePresenter presenter_;
    uint32_t width_px_ = 0, height_px_ = 0;
    uint64_t moves_ = 0;           // seen so far
    bool is_camera_taken_ = false; // from the scene, by a person
    bool needs_frame_ = true, is_tracing_ = false, is_refining_ = false, is_final_ = false, is_in_motion_ = false;
    Clock::time_point changed_, taken_, shown_;
    std::optional<Clock::time_point> played_, drawn_; // until when; when draw() ended
    double play_s_ = 0.0, waited_s_ = 0.0, interval_s_ = 0.0;
    const viewer::Frame *frame_ = nullptr; // the newest
    uint64_t version_ = 0;                 // of the picture that is shown
    std::unique_ptr<viewer::FramePipeline> pipeline_;
};

} // namespace glint::android
