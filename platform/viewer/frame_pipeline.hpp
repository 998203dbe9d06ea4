// Traces frame n + 1 while frame n is being shown.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <glint/accel.hpp>
#include <glint/framebuffer.hpp>
#include <glint/governor.hpp>
#include <glint/refiner.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>

namespace glint::viewer {

using Clock = std::chrono::steady_clock;

/// What the next frame is to show, and how.
struct FrameRequest {
    std::shared_ptr<const Accel> accel;
    RenderOptions how;
    uint32_t width_px = 1, height_px = 1;
    FrameQuality quality; ///< that `how` and the size come from; told again with the frame
    unsigned threads = 1;
    Isa isa = best_isa();
    /// Whether the frame is the first of many of one picture that gets better from pass to pass.
    bool refines = false;
    /// Whether it shows the next moment of the motion that the frame before showed.
    bool follows = false;
    /// When the event happened that this frame is the first to show.
    std::optional<Clock::time_point> input_time;
};

/// A traced picture.
struct Frame {
    std::optional<Framebuffer> picture; ///< always there once the frame was traced
    FrameRequest request;
    RenderStatistics statistics;
    Clock::time_point finished;
    uint32_t samples = 1;  ///< a pixel
    bool is_final = false; ///< no better one will follow
    uint64_t number = 0;   ///< from 1
    /// From the request to where the refinement that it put an end to let go, in seconds; nothing where it met none.
    std::optional<double> stop_s;
};

/// A thread that traces what was requested last. Requests and frames are handed over under a lock that is held for a
/// few instructions: three frames go round, one being traced, one finished, one being shown.
///
/// Everything but the tracing belongs to one thread, that which shows the frames.
class FramePipeline {
public:
    FramePipeline();
    ~FramePipeline();
    FramePipeline(const FramePipeline &) = delete;
    FramePipeline &operator=(const FramePipeline &) = delete;

    /// Takes the place of a request that was not begun yet. A refinement stops within a tile; a frame that was begun
    /// for its own sake is finished.
    void submit(FrameRequest request);
    /// Stops refining after the pass that is being traced.
    void stop_refining();
    /// Whether everything requested was traced, or given up.
    [[nodiscard]] bool is_idle() const;

    /// The newest frame finished since the last call, waiting for one until `deadline`; nullptr where there is none. It
    /// stays as it is until the next call that returns one. Fails with what a render failed with.
    [[nodiscard]] Result<const Frame *> take(Clock::time_point deadline);

private:
    void live();
    Status trace(bool is_next_pass);

    mutable std::mutex mutex_;
    std::condition_variable for_tracer_, for_shower_;
    std::optional<FrameRequest> waiting_;
    std::optional<Clock::time_point> stopped_; // when a refinement in progress was told to stop
    bool refines_ = false, stops_ = false, is_tracing_ = false, has_finished_ = false;
    std::optional<Error> failure_;
    RenderControl control_;
    Frame frames_[3];
    Frame *traced_ = &frames_[0], *finished_ = &frames_[1], *shown_ = &frames_[2];

    // The tracing thread's own.
    FrameRequest request_; // the last one begun
    std::unique_ptr<Renderer> renderer_;
    unsigned renderer_threads_ = 0;
    Refiner refiner_;
    uint64_t number_ = 0;

    std::thread tracer_;
};

} // namespace glint::viewer
