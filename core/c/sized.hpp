// Structs that grow: read from callers and written to callers who know fewer members than we do, or more.
#pragma once

#include <cstddef>

#include <glint/error.h>

namespace glint {

/// Copies as much of `given` as its size says over `known`, which holds defaults. False where the size is none, or
/// where there is anything but zeroes behind what we know.
[[nodiscard]] bool take_sized(const void *given, void *known, size_t known_size);
/// Copies `known` to `place` as far as the size there goes, and zeroes behind it; the size stays. False where it is
/// none.
[[nodiscard]] bool give_sized(void *place, const void *known, size_t known_size);
/// Whether there is a size to give to.
[[nodiscard]] bool is_sized(const void *place);
/// The same into memory that has no size yet.
[[nodiscard]] glint_error init_sized(void *place, size_t size, const void *known, size_t known_size);

/// `known`, with what the caller has set; `given` may be NULL. False where the struct is not valid.
template <typename T> [[nodiscard]] bool take(const T *given, T &known) {
    if (given && !take_sized(given, &known, sizeof(T))) return false;
    if constexpr (requires { known.reserved; }) return known.reserved == 0;
    return true;
}

/// For functions that only look: the code of `known` for `place`.
template <typename T> [[nodiscard]] glint_error give(T *place, const T &known) {
    return give_sized(place, &known, sizeof(T)) ? GLINT_OK : GLINT_ERROR_INVALID_ARGUMENT;
}

/// For the ..._init functions.
template <typename T> [[nodiscard]] glint_error init(T *place, size_t size, const T &defaults) {
    return init_sized(place, size, &defaults, sizeof(T));
}

} // namespace glint
