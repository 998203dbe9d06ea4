// Names of the patterns in which a pixel's samples lie.
#pragma once

#include <optional>
#include <string_view>

#include <glint/scene.hpp>

namespace glint {

/// The pattern that sample_pattern_name() calls so.
[[nodiscard]] std::optional<SamplePattern> sample_pattern_named(std::string_view name);

} // namespace glint
