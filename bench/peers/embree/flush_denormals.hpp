// The floating-point mode that Embree's manual asks for.
#pragma once

#include <immintrin.h>

namespace glint::bench::embree {

/// While it lives, denormal numbers count as zero on the calling thread ("MXCSR control and status register" in
/// Embree's manual); Glint, which runs on the same thread, never sees the mode.
class FlushDenormals {
public:
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); } // flush to zero, denormals are zero
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals &) = delete;
    FlushDenormals &operator=(const FlushDenormals &) = delete;

private:
    unsigned before_;
};

} // namespace glint::bench::embree
