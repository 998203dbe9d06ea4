// A bar on standard error that fills while a picture is rendered.
#include "progress_bar.hpp"

#include <chrono>
#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "console.hpp"

namespace glint::cli {
namespace {

constexpr auto patience = std::chrono::milliseconds(300);
constexpr auto interval = std::chrono::milliseconds(100);
constexpr int bar_width = 40;

std::string bar(double progress) {
    const int filled = static_cast<int>(progress * bar_width);
    return fmt::format("\r[{:#<{}}{:.<{}}] {:3.0f} %", "", filled, "", bar_width - filled, 100.0 * progress);
}

} // namespace

ProgressBar::ProgressBar(const RenderControl &control) : control_(control) {
    if (someone_watches()) watcher_ = std::thread([this] { watch(); });
}

ProgressBar::~ProgressBar() {
    if (!watcher_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    done_changed_.notify_one();
    watcher_.join();
}

void ProgressBar::watch() {
    std::unique_lock lock(mutex_);
    if (done_changed_.wait_for(lock, patience, [this] { return done_; })) return;
    do {
        std::fputs(bar(control_.progress()).c_str(), stderr);
        std::fflush(stderr);
    } while (!done_changed_.wait_for(lock, interval, [this] { return done_; }));
    std::fputs("\r\033[K", stderr); // back to the line's start, and clear it
    std::fflush(stderr);
}

} // namespace glint::cli
