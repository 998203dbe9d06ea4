// How much time and memory one small text may take.
#pragma once

#include <cstdint>
#include <ctime>

namespace glint::fuzz {

/// Watches one input from here on.
class Budget {
public:
    static constexpr double most_seconds = 1.0; ///< of processor time, which a busy machine does not stretch
    static constexpr int64_t most_bytes = int64_t{64} << 20; ///< of memory asked for, in use at one time

    Budget();
    /// Stops the program where more was used. Memory is watched in the fuzzers' own build only.
    void require_kept() const;

private:
    std::clock_t start_;
};

} // namespace glint::fuzz
