// Names of the patterns in which a pixel's samples lie.
#include "sdl/sample_patterns.hpp"

namespace glint {

std::optional<SamplePattern> sample_pattern_named(std::string_view name) {
    for (const SamplePattern pattern : {SamplePattern::centre, SamplePattern::stratified, SamplePattern::jittered}) {
        if (sample_pattern_name(pattern) == name) return pattern;
    }
    return std::nullopt;
}

} // namespace glint
