// The options that may stand before the name of a texture's file in an MTL file.
#include "mesh/map_options.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "mesh/obj_words.hpp"
#include "text/number.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// An option and its arguments.
struct MapOption {
    std::string_view name;
    enum class Kind { numbers, word } kind;
    size_t least, most; ///< arguments
    /// Numbers, or a word, that leave the picture as it is; arguments that are missing do so, too. Empty: all do.
    std::array<std::string_view, 3> neutral = {};
};

using Kind = MapOption::Kind;

constexpr MapOption options[] = {
    {"-s", Kind::numbers, 1, 3, {"1", "1", "1"}},
    {"-o", Kind::numbers, 1, 3, {"0", "0", "0"}},
    {"-t", Kind::numbers, 1, 3, {"0", "0", "0"}},
    {"-mm", Kind::numbers, 2, 2, {"0", "1"}},
    {"-clamp", Kind::word, 1, 1, {"off"}},
    {"-cc", Kind::word, 1, 1, {"off"}},
    {"-imfchan", Kind::word, 1, 1},    // which channel a map of single numbers takes
    {"-type", Kind::word, 1, 1},       // of reflection maps
    {"-blendu", Kind::word, 1, 1},     // how a texture is filtered
    {"-blendv", Kind::word, 1, 1},     //
    {"-boost", Kind::numbers, 1, 1},   //
    {"-texres", Kind::numbers, 1, 1},  //
    {"-bm", Kind::numbers, 1, 1},      // of bump maps
    {"-colorspace", Kind::word, 1, 1}, // texels are taken as they are
};

bool is_neutral(std::string_view word, std::string_view neutral) {
    float value = 0.0f, wanted = 0.0f;
    if (neutral.empty() || word == neutral) return true;
    return !read_number(neutral, wanted) && !read_number(word, value) && value == wanted;
}

} // namespace

char *check_map_options(char *at, const ObjLines &lines, Problems &problems) {
    // Unlike elsewhere, '#' is part of a word: the name that follows may well have one.
    const auto word_from = [&](char *begin) { return Word{begin, std::find_if(begin, lines.end(), is_blank)}; };
    at = skip_blanks(at, lines.end());
    while (at != lines.end() && *at == '-') {
        const Word word = word_from(at);
        const auto *const option = std::find_if(std::begin(options), std::end(options),
                                                [&](const MapOption &known) { return known.name == word.text(); });
        if (option == std::end(options)) return at; // a file may begin with '-'
        at = skip_blanks(word.end, lines.end());
        size_t count = 0;
        bool is_effective = false;
        for (; count < option->most && at != lines.end(); ++count) {
            const Word argument = word_from(at);
            float value = 0.0f;
            if (option->kind == Kind::numbers && read_number(argument.text(), value)) break;
            is_effective = is_effective || !is_neutral(argument.text(), option->neutral[count]);
            at = skip_blanks(argument.end, lines.end());
        }
        if (count < option->least) {
            problems.error(
                lines.place(word.begin),
                words("the option ", in_quotes(word.text()), " takes ", option->least < option->most ? "1 to " : "",
                      counted(option->most, option->kind == Kind::numbers ? "number" : "word"), ", found ", count));
            return nullptr;
        }
        if (is_effective) {
            problems.warn(lines.place(word.begin), words("the option ", in_quotes(word.text()),
                                                         " is left aside: the texture shows as if it were not there"));
        }
    }
    return at;
}

} // namespace glint
