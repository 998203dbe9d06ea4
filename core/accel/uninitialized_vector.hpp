// A vector whose resize() leaves new elements as they are, for large arrays that are filled right after.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "accel/large_memory.hpp"

namespace glint {

/// Leaves out what std::allocator does for an element that is given no value. Writing one first would touch all memory
/// once more, and from one thread.
template <typename T> struct UninitializedAllocator : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T>, "such objects are there as soon as their memory is");

    template <typename U> struct rebind {
        using other = UninitializedAllocator<U>;
    };

    [[nodiscard]] T *allocate(size_t count) {
        static_assert(alignof(T) <= 64);
        return static_cast<T *>(allocate_large(count * sizeof(T)));
    }
    void deallocate(T *elements, size_t count) noexcept { free_large(elements, count * sizeof(T)); }

    template <typename U> void construct(U *) noexcept {}
    template <typename U, typename... Arguments> void construct(U *place, Arguments &&...arguments) {
        std::construct_at(place, std::forward<Arguments>(arguments)...);
    }
};

template <typename T> using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace glint
