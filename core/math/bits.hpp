// std::bit_cast, for C++ libraries that do not have it yet.
#pragma once

#include <type_traits>

namespace glint {

template <typename To, typename From> [[nodiscard]] constexpr To bit_cast(const From &from) noexcept {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    return __builtin_bit_cast(To, from);
}

} // namespace glint
