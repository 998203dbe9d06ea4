// Small random damage to a text, for tests that a reader survives anything.
#pragma once

#include <string>
#include <string_view>

#include "support/random.hpp"

namespace glint::test {

/// The text after one to three changes: a byte replaced, inserted or taken out, a piece doubled, moved or cut off.
[[nodiscard]] inline std::string mutated(std::string_view original, Random &random) {
    constexpr std::string_view likely = "0123456789+-.,eE/\\#\r\n\t  \"'xnaif\xff\x80\x01";
    std::string text(original);
    for (uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
        const auto size = static_cast<uint32_t>(text.size());
        if (size < 2) break;
        const size_t at = random.below(size), length = 1 + random.below(8);
        const char byte = random.below(8) == 0 ? static_cast<char>(random.below(256))
                                               : likely[random.below(static_cast<uint32_t>(likely.size()))];
        switch (random.below(6)) {
        case 0:
            text[at] = byte;
            break;
        case 1:
            text.insert(at, 1, byte);
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(at, text.substr(at, length));
            break;
        case 4:
            text.insert(random.below(size), text.substr(at, length));
            break;
        default:
            if (random.below(4) == 0) text.resize(at);
        }
    }
    return text;
}

} // namespace glint::test
