// How long a call takes.
#pragma once

#include <chrono>

namespace glint::bench {

/// Milliseconds of wall time.
template <typename Call> [[nodiscard]] double time_ms(const Call &call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace glint::bench
