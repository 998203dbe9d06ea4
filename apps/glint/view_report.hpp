// What glint view has to say when it ends.
#pragma once

#include <string>

#include "viewer/frame_log.hpp"

namespace glint::cli {

struct ViewReport {
    std::string scene, surface, gl_description, isa;
    const viewer::FrameLog &log; ///< outlives the report
};

/// A few lines for a person.
[[nodiscard]] std::string to_text(const ViewReport &report);
/// `{"machine": {...}, "scene", "surface", "gl", "isa", "fps", "interval_ms", "latency_ms", "latency_frames",
/// "scale_changes_per_s", "frames": [...]}`, times in milliseconds.
[[nodiscard]] std::string to_json(const ViewReport &report);

} // namespace glint::cli
