// Any text as an SDL file that is rewritten: what comes out is the same scene, and rewritten once more the same text.
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "fuzz/budget.hpp"
#include "fuzz/same_scene.hpp"
#include "fuzz/scene_place.hpp"
#include "fuzz/verdict.hpp"
#include "sdl/read_scene.hpp"
#include "support/text_in_memory.hpp"

namespace {

using namespace glint;

Result<ConvertedScene> convert(std::string_view text) {
    const fuzz::Budget budget;
    Result<ConvertedScene> converted =
        convert_scene_text(test::text_in_memory(text), fuzz::scene_file(), fuzz::scene_folder(), fuzz::scene_options());
    budget.require_kept();
    return converted;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const Result<ConvertedScene> first = convert({reinterpret_cast<const char *>(data), size});
    if (!first.ok()) {
        fuzz::require_reasons(first.error());
        return 0;
    }
    const Result<ConvertedScene> second = convert(first->text);
    if (!second.ok()) std::fprintf(stderr, "%s\n", second.error().text().c_str());
    fuzz::require(second.ok(), "what was converted is refused");
    fuzz::require(second->source.dialect == "glint", "what was converted is in another dialect");
    fuzz::require(second->source.output_file == first->source.output_file, "the output became another");
    fuzz::require_same(*first->source.scene, *second->source.scene);
    if (second->text != first->text)
        std::fprintf(stderr, "%s\nbecame\n%s\n", first->text.c_str(), second->text.c_str());
    fuzz::require(second->text == first->text, "what was converted changes when it is converted again");
    return 0;
}
