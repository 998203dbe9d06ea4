// Names of the patterns in which a pixel's samples lie.
#include "sdl/sample_patterns.hpp"

namespace glint {

std::string_view sample_pattern_name(SamplePattern pattern) {
    switch (pattern) {
    case SamplePattern::centre:
        return "centre";
    case SamplePattern::stratified:
        return "stratified";
    case SamplePattern::jittered:
        return "jittered";
    }
    return "";
}

std::optional<SamplePattern> sample_pattern_named(std::string_view name) {
    for (const SamplePattern pattern : {SamplePattern::centre, SamplePattern::stratified, SamplePattern::jittered}) {
        if (sample_pattern_name(pattern) == name) return pattern;
    }
    return std::nullopt;
}

} // namespace glint
