// "Did you mean": the known word that a mistyped one is nearest to.
#include "text/suggest.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace glint {

namespace {

constexpr size_t longest_word = 32;
constexpr size_t most_edits = 2;

} // namespace

size_t edit_distance(std::string_view a, std::string_view b) {
    if (a.size() > longest_word || b.size() > longest_word) return std::numeric_limits<size_t>::max();
    // Row i holds the distances from the first i letters of a to each beginning of b.
    std::array<std::array<size_t, longest_word + 1>, longest_word + 1> distance{};
    for (size_t j = 0; j <= b.size(); ++j) distance[0][j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        distance[i][0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t change = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            distance[i][j] = std::min({change, distance[i - 1][j] + 1, distance[i][j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
            }
        }
    }
    return distance[a.size()][b.size()];
}

std::optional<std::string_view> nearest_word(std::string_view word, const std::vector<std::string_view> &known) {
    std::optional<std::string_view> nearest;
    size_t least = most_edits + 1;
    for (const std::string_view candidate : known) {
        const size_t edits = edit_distance(word, candidate);
        if (edits < least && edits < candidate.size()) {
            least = edits;
            nearest = candidate;
        }
    }
    return nearest;
}

} // namespace glint
