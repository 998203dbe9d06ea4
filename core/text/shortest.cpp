// Numbers as text.
#include "text/shortest.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include <fast_float/fast_float.h>

namespace glint {

std::string shortest(float value) {
    // Most numbers of a scene are these: nothing is shorter than their digits, and looking for it takes a while.
    if (std::abs(value) < 10000.0f && value == std::trunc(value)) {
        return (std::signbit(value) ? "-" : "") + std::to_string(static_cast<int>(std::abs(value)));
    }
    // Behind the point. Numbers that take more have a shorter form with an exponent.
    constexpr int most_digits = std::numeric_limits<float>::max_digits10 + 4;
    std::string best;
    for (const auto format : {std::ios::fixed, std::ios::scientific}) {
        for (int digits = 0; digits < most_digits; ++digits) {
            std::ostringstream out;
            out.imbue(std::locale::classic());
            out.setf(format, std::ios::floatfield);
            out.precision(digits);
            out << value;
            const std::string text = out.str();
            float back = 0.0f;
            fast_float::from_chars(text.data(), text.data() + text.size(), back);
            if (back != value) continue;
            if (best.empty() || text.size() < best.size()) best = text;
            break;
        }
    }
    return best;
}

} // namespace glint
