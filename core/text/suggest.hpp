// "Did you mean": the known word that a mistyped one is nearest to.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace glint {

/// Insertions, deletions, changes and swaps of neighbours that turn one word into the other (Damerau 1964, each letter
/// edited once). Words longer than 32 bytes are infinitely far from any other.
[[nodiscard]] size_t edit_distance(std::string_view a, std::string_view b);

/// The first of the nearest known words, if it is within two edits and is not a wholly different word for that.
[[nodiscard]] std::optional<std::string_view> nearest_word(std::string_view word,
                                                           const std::vector<std::string_view> &known);

} // namespace glint
