// What the frames took.
#include "viewer/frame_log.hpp"

#include <algorithm>

namespace glint::viewer {

Quantiles quantiles_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
    };
    return {at(0.5), at(0.95), values.back(), values.size()};
}

FrameLog::FrameLog() {
    frames_.resize(most_frames); // touches it: memory that is only reserved comes page by page
    frames_.clear();
}

void FrameLog::add(const ShownFrame &frame) {
    ++count_;
    if (frames_.size() == most_frames) frames_.erase(frames_.begin(), frames_.begin() + most_frames / 2);
    frames_.push_back(frame);
}

std::vector<double> FrameLog::intervals_s() const {
    std::vector<double> values;
    for (const ShownFrame &frame : frames_) {
        if (frame.interval_s > 0.0) values.push_back(frame.interval_s);
    }
    return values;
}

std::vector<double> FrameLog::latencies_s() const {
    std::vector<double> values;
    for (const ShownFrame &frame : frames_) {
        if (frame.latency_s >= 0.0) values.push_back(frame.latency_s);
    }
    return values;
}

std::vector<double> FrameLog::latencies_in_frames() const {
    std::vector<double> values;
    for (size_t i = 0; i < frames_.size(); ++i) {
        if (frames_[i].latency_s < 0.0) continue;
        const double event_s = frames_[i].shown_s - frames_[i].latency_s;
        size_t first = i;
        while (first > 0 && frames_[first - 1].shown_s > event_s) --first;
        values.push_back(static_cast<double>(i - first + 1));
    }
    return values;
}

std::vector<double> FrameLog::stops_s() const {
    std::vector<double> values;
    for (const ShownFrame &frame : frames_) {
        if (frame.stop_s >= 0.0) values.push_back(frame.stop_s);
    }
    return values;
}

double FrameLog::fps() const {
    double seconds = 0.0;
    uint64_t frames = 0;
    for (const ShownFrame &frame : frames_) {
        if (frame.interval_s <= 0.0) continue;
        seconds += frame.interval_s;
        ++frames;
    }
    return seconds > 0.0 ? static_cast<double>(frames) / seconds : 0.0;
}

double FrameLog::scale_changes_per_s() const {
    double seconds = 0.0;
    uint64_t changes = 0;
    for (size_t i = 1; i < frames_.size(); ++i) {
        if (frames_[i].interval_s <= 0.0) continue;
        seconds += frames_[i].interval_s;
        changes += frames_[i].scale != frames_[i - 1].scale ? 1 : 0;
    }
    return seconds > 0.0 ? static_cast<double>(changes) / seconds : 0.0;
}

} // namespace glint::viewer
