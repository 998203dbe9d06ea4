// A place in a text that is remembered longer than the text.
#pragma once

#include <cstdint>
#include <string>

#include "text/problems.hpp"

namespace glint {

/// A Place with a source line of its own, cut where it is very long.
struct KeptPlace {
    uint32_t line = 0, column = 0;
    std::string source_line;

    KeptPlace() = default;
    explicit KeptPlace(const Place &place)
        : line(place.line), column(place.column), source_line(place.source_line.substr(0, most_bytes)) {}

    /// Points into this object.
    [[nodiscard]] Place place() const { return {line, column, source_line}; }

private:
    static constexpr size_t most_bytes = 1024;
};

} // namespace glint
