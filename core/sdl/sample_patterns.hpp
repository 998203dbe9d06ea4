// Names of the patterns in which a pixel's samples lie.
#pragma once

#include <optional>
#include <string_view>

#include <glint/scene.hpp>

namespace glint {

/// "centre", "stratified" or "jittered".
[[nodiscard]] std::string_view sample_pattern_name(SamplePattern pattern);
[[nodiscard]] std::optional<SamplePattern> sample_pattern_named(std::string_view name);

} // namespace glint
