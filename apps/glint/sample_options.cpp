// The options that say how a pixel comes to its colour, where a command has them.
#include "sample_options.hpp"

#include "choice_option.hpp"
#include "number_options.hpp"

namespace glint::cli {

RenderOptions SampleOptions::render_options() const {
    RenderOptions how;
    how.max_depth = depth;
    how.samples_per_pixel = samples_per_pixel;
    how.pattern = pattern;
    how.transfer = transfer;
    return how;
}

void add_sample_options(CLI::App &parser, SampleOptions &options) {
    add_number(parser, "--depth", options.depth, depth_bounds, "Most recursive rays in a row (default: the scene's)");
    add_number(parser, "--spp", options.samples_per_pixel, {1, max_samples}, "Samples a pixel (default: the scene's)");
    Choices<SamplePattern> patterns;
    for (const SamplePattern pattern : {SamplePattern::centre, SamplePattern::stratified, SamplePattern::jittered}) {
        patterns.emplace_back(sample_pattern_name(pattern), pattern);
    }
    add_choice(parser, "--pattern", options.pattern, patterns,
               "Where in a pixel its samples lie: in the middles of a grid, at random in its cells, or at random "
               "(default: the scene's)");
    add_choice(parser, "--transfer", options.transfer, {{"linear", Transfer::linear}, {"srgb", Transfer::srgb}},
               "How colours become 8 bits: as they are, like the SDL renderers (linear, the default), or "
               "as displays expect them (srgb)");
}

} // namespace glint::cli
