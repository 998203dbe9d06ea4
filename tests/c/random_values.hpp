// Arguments as a careless program would bring them: mostly right, sometimes at an edge, sometimes nonsense.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>

#include "support/random.hpp"

namespace glint::test {

class RandomValues {
public:
    explicit RandomValues(uint64_t seed) : engine_(seed) {}

    [[nodiscard]] uint32_t below(uint32_t count) { return engine_.below(count); }
    /// True once in so many times.
    [[nodiscard]] bool once_in(uint32_t times) { return below(times) == 0; }
    template <typename T> [[nodiscard]] T one_of(std::initializer_list<T> values) {
        return values.begin()[below(static_cast<uint32_t>(values.size()))];
    }

    /// Mostly in [-1, 1].
    [[nodiscard]] double number() {
        const double even = static_cast<double>(below(1u << 24)) / (1 << 23) - 1.0;
        if (!once_in(20)) return even;
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return one_of({0.0, -0.0, infinity, -infinity, std::nan(""), 1e-300, 1e-42, 1e12, -1e13, 1e38, 1e300});
    }
    /// The same in float; what is too large is infinite there.
    [[nodiscard]] float real() {
        const double wide = number();
        if (std::abs(wide) > 3e38)
            return std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(wide > 0 ? 1 : -1));
        return static_cast<float>(wide);
    }
    template <size_t count> void fill(float (&values)[count]) {
        for (float &value : values) value = real();
    }
    /// Mostly from 1 to `usual`.
    [[nodiscard]] uint32_t count(uint32_t usual) {
        return once_in(16) ? one_of({0u, UINT32_MAX, 1u << 31, 65536u, 1025u}) : 1 + below(usual);
    }
    /// Mostly a value of an enum with so many.
    [[nodiscard]] int32_t choice(uint32_t values) {
        return once_in(16) ? one_of({-2, -1, INT32_MAX, INT32_MIN, static_cast<int32_t>(values)})
                           : static_cast<int32_t>(below(values));
    }

private:
    Random engine_;
};

/// A struct with a size and much room behind it, so that sizes may be wrong.
template <typename T> class Roomy {
public:
    Roomy() { std::memset(bytes_, 0, sizeof bytes_); }
    T *operator->() { return get(); }
    T *get() { return reinterpret_cast<T *>(bytes_); }

    /// Gives it a size, mostly its own, and now and then something behind its end.
    T *sized(RandomValues &random) {
        size_t size = sizeof(T);
        if (random.once_in(16)) {
            size = random.one_of<size_t>(
                {0, 4, 8, 12, sizeof(T) - 8, sizeof(T) + 8, sizeof(T) + 64, 4096, 4104, SIZE_MAX});
        }
        std::memcpy(bytes_, &size, sizeof size);
        if (random.once_in(32)) bytes_[sizeof(T) + random.below(64)] = 1;
        return get();
    }

    void remember() { std::memcpy(before_, bytes_, sizeof before_); }
    /// Whether nothing was written since.
    [[nodiscard]] bool is_untouched() const { return std::memcmp(before_, bytes_, sizeof before_) == 0; }

private:
    alignas(16) unsigned char bytes_[sizeof(T) + 4096];
    unsigned char before_[sizeof(T) + 64];
};

} // namespace glint::test
