// The arguments of one directive, handed to its handler with checks and places.
#include "sdl/arguments.hpp"

#include <limits>

#include "text/number.hpp"
#include "text/shortest.hpp"
#include "text/words.hpp"

namespace glint {

float Arguments::number(size_t i, float lowest, float highest) const {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    float value = none;
    if (const auto fault = read_number(word(i), value)) {
        error(i, words(form_.argument(i), ": ", fault->message), fault->hint);
        return none;
    }
    if (value >= lowest && value <= highest) return value;
    error(i, words(form_.argument(i), " is ", in_quotes(word(i)), ", expected a number from ", shortest(lowest), " to ",
                   shortest(highest)));
    return none;
}

glm::vec3 Arguments::numbers(size_t i, float lowest, float highest) const {
    const float x = number(i, lowest, highest);
    const float y = number(i + 1, lowest, highest);
    const float z = number(i + 2, lowest, highest);
    return {x, y, z};
}

uint64_t Arguments::whole_number(size_t i, uint64_t otherwise) const {
    uint64_t value = 0;
    const auto fault = read_whole_number(word(i), value);
    if (!fault) return value;
    error(i, words(form_.argument(i), ": ", fault->message), fault->hint);
    return otherwise;
}

uint64_t Arguments::whole_number_in(size_t i, uint64_t lowest, uint64_t highest) const {
    const uint64_t value = whole_number(i, lowest);
    if (value >= lowest && value <= highest) return value;
    error(i, words(form_.argument(i), " is ", in_quotes(word(i)), ", expected a whole number from ", lowest, " to ",
                   highest));
    return lowest;
}

bool Arguments::on_or_off(size_t i) const {
    const std::string lower = lower_case(word(i).substr(0, 8));
    if (lower == "on") return true;
    if (lower != "off") error(i, words("expected 'on' or 'off', found ", in_quotes(word(i))));
    return false;
}

} // namespace glint
