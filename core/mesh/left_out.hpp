// Lines of a file that are left out, told of together.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "text/kept_place.hpp"

namespace glint {

/// Lines of one kind that are left out, told of by one warning at the first of them. Keeps copies, because the text
/// changes.
struct LeftOut {
    uint64_t lines = 0;
    KeptPlace first;
    std::string keyword; ///< of the first

    void add(const Place &place, std::string_view keyword_) {
        if (lines++ > 0) return;
        first = KeptPlace(place);
        keyword = std::string(keyword_);
    }
};

} // namespace glint
