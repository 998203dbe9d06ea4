// A bar on standard error that fills while a picture is rendered.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include <glint/renderer.hpp>

namespace glint::cli {

/// Shows the control's progress from a thread of its own until it goes out of scope, then wipes the line. Appears only
/// on a terminal, and only when there is something to wait for.
class ProgressBar {
public:
    explicit ProgressBar(const RenderControl &control);
    ~ProgressBar();
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;

private:
    void watch();

    const RenderControl &control_;
    std::mutex mutex_;
    std::condition_variable done_changed_;
    bool done_ = false; // guarded by mutex_
    std::thread watcher_;
};

} // namespace glint::cli
