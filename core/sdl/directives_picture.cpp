// The directives for the picture: its size, how deep and how finely it is traced, and what becomes of its colours.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "sdl/arguments.hpp"
#include "sdl/directives.hpp"
#include "sdl/sample_patterns.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// `supersample` and `samples` set the same, so only one of them may.
void check_not_sampled(const Arguments &arguments, SceneDraft &draft) {
    if (draft.has_samples) {
        arguments.problems().error(arguments.keyword_place(),
                                   "'supersample' and 'samples' both set the samples a pixel", "take one of them");
    }
    draft.has_samples = true;
}

} // namespace

/// It has spoken before any other line was read (detect.cpp).
void read_dialect(const Arguments &, SceneDraft &) {}

void read_size(const Arguments &arguments, SceneDraft &draft) {
    const uint64_t width = arguments.whole_number(0, 1), height = arguments.whole_number(1, 1);
    if (width == 0 || height == 0) {
        return arguments.error(width == 0 ? 0 : 1,
                               words("the picture has ", width, " x ", height, " pixels, expected at least 1 x 1"));
    }
    const uint64_t limit = draft.options.limits.max_pixels;
    const uint64_t longest_side = std::numeric_limits<uint32_t>::max();
    if (width > longest_side || height > longest_side || width > limit / height) {
        return arguments.error(0,
                               words("the picture has ", in_quotes(arguments.word(0)), " x ",
                                     in_quotes(arguments.word(1)), " pixels, the limit is ", limit, " in all"),
                               "--max-pixels raises the limit", ErrorCode::limit_exceeded);
    }
    draft.picture.width_px = static_cast<uint32_t>(width);
    draft.picture.height_px = static_cast<uint32_t>(height);
}

void read_background(const Arguments &arguments, SceneDraft &draft) {
    draft.background = arguments.numbers(0, 0.0f, max_intensity);
}

void read_ambient(const Arguments &arguments, SceneDraft &draft) {
    draft.ambient = arguments.number(0, 0.0f, max_intensity);
}

void read_max_depth(const Arguments &arguments, SceneDraft &draft) {
    const uint64_t depth = arguments.whole_number(0, 0);
    const uint32_t limit = draft.options.limits.max_depth;
    if (depth > limit) {
        return arguments.error(0, words("the depth is ", in_quotes(arguments.word(0)), ", the limit is ", limit), {},
                               ErrorCode::limit_exceeded);
    }
    draft.picture.max_depth = static_cast<uint32_t>(depth);
}

void read_output(const Arguments &arguments, SceneDraft &draft) {
    if (auto problem = draft.meshes.paths().output_problem(arguments.word(0))) {
        return arguments.error(0, std::move(*problem));
    }
    draft.output_file = std::string(arguments.word(0));
}

void read_supersample(const Arguments &arguments, SceneDraft &draft) {
    check_not_sampled(arguments, draft);
    draft.picture.samples_per_pixel = arguments.on_or_off(0) ? 4 : 1;
    draft.picture.pattern = SamplePattern::centre;
}

void read_samples(const Arguments &arguments, SceneDraft &draft) {
    check_not_sampled(arguments, draft);
    draft.picture.samples_per_pixel = static_cast<uint32_t>(arguments.whole_number_in(0, 1, max_samples));
    if (arguments.count() < 2) return;
    const auto pattern = sample_pattern_named(arguments.word(1));
    if (!pattern) {
        return arguments.error(1, words("there is no pattern ", in_quotes(arguments.word(1))),
                               "the patterns are centre, stratified and jittered");
    }
    draft.picture.pattern = *pattern;
}

void read_npaths(const Arguments &arguments, SceneDraft &draft) {
    draft.picture.paths_per_pixel =
        static_cast<uint32_t>(arguments.whole_number_in(0, 0, std::numeric_limits<uint32_t>::max()));
    if (draft.picture.paths_per_pixel <= 1) return;
    arguments.problems().warn(arguments.keyword_place(),
                              "'npaths' asks for a path tracer; Glint's rays are Whitted's, and it has no effect",
                              "'samples n' or --spp smooths edges");
}

void read_tonemapping(const Arguments &arguments, SceneDraft &draft) {
    draft.picture.tone_scale = arguments.number(0, 0.0f, max_intensity);
}

void read_seed(const Arguments &arguments, SceneDraft &draft) {
    draft.picture.seed = static_cast<uint32_t>(arguments.whole_number_in(0, 0, std::numeric_limits<uint32_t>::max()));
}

void read_reflection_adds(const Arguments &arguments, SceneDraft &draft) {
    draft.reflection_adds = arguments.on_or_off(0);
}

void read_fresnel(const Arguments &arguments, SceneDraft &draft) {
    draft.optics.fresnel = arguments.on_or_off(0);
}

void read_shadows_through_glass(const Arguments &arguments, SceneDraft &draft) {
    draft.optics.shadows_through_glass = arguments.on_or_off(0);
}

} // namespace glint
