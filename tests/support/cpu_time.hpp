// Time that a busy machine does not stretch, for tests that tell linear from quadratic.
#pragma once

#include <ctime>

namespace glint::test {

/// Processor time that this process has used since the object was made, in seconds as a build without sanitizers would
/// use them, roughly.
class CpuTime {
public:
    [[nodiscard]] double seconds() const {
#ifdef GLINT_SANITIZED
        constexpr double slower = 20.0;
#else
        constexpr double slower = 1.0;
#endif
        return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC / slower;
    }

private:
    std::clock_t start_ = std::clock();
};

} // namespace glint::test
