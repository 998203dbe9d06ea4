// Sine and cosine from additions and multiplications alone: every machine's models get the same bits, which libm
// does not promise.
#pragma once

#include <cmath>

namespace glint::scenes {

inline constexpr double pi = 3.14159265358979323846;

struct CosSin {
    double cosine = 1.0;
    double sine = 0.0;
};

/// Of an angle in radians, |angle| <= pi / 4; error below 1e-16.
[[nodiscard]] inline CosSin cos_sin_small(double angle_rad) {
    // The Taylor series from its smallest term to its largest; the first term left out is below 1e-19.
    const double x2 = angle_rad * angle_rad;
    double cosine = 1.0;
    double sine = 1.0;
    for (int n = 18; n >= 2; n -= 2) {
        cosine = 1.0 - cosine * x2 / (n * (n - 1));
        sine = 1.0 - sine * x2 / (n * (n + 1));
    }
    return {cosine, sine * angle_rad};
}

/// Of an angle in turns (1 is the whole circle), any size. Quarter turns are exact.
[[nodiscard]] inline CosSin cos_sin_turns(double turns) {
    const double quarter = std::floor(turns * 4.0 + 0.5);
    const CosSin rest = cos_sin_small((turns - quarter / 4.0) * 2.0 * pi);
    switch (static_cast<long long>(quarter) & 3) {
    case 0:
        return rest;
    case 1:
        return {-rest.sine, rest.cosine};
    case 2:
        return {-rest.cosine, -rest.sine};
    default:
        return {rest.sine, -rest.cosine};
    }
}

} // namespace glint::scenes
