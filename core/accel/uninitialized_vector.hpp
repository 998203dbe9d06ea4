// A vector whose resize() leaves new elements as they are, for arrays that are filled right after.
#pragma once

#include <memory>
#include <vector>

namespace glint {

/// Default-initialises where std::allocator zeroes: nothing is written for plain data. Zeroing first would touch all
/// memory once more, and from one thread.
template <typename T> struct UninitializedAllocator : std::allocator<T> {
    template <typename U> struct rebind {
        using other = UninitializedAllocator<U>;
    };

    template <typename U> void construct(U *place) noexcept { ::new (static_cast<void *>(place)) U; }
    template <typename U, typename... Arguments> void construct(U *place, Arguments &&...arguments) {
        ::new (static_cast<void *>(place)) U(std::forward<Arguments>(arguments)...);
    }
};

template <typename T> using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace glint
