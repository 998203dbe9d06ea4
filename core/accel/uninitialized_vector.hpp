// A vector whose resize() leaves new elements as they are, for arrays that are filled right after.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace glint {

/// Leaves out what std::allocator does for an element that is given no value. Writing one first would touch all memory
/// once more, and from one thread.
template <typename T> struct UninitializedAllocator : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T>, "such objects are there as soon as their memory is");

    template <typename U> struct rebind {
        using other = UninitializedAllocator<U>;
    };

    template <typename U> void construct(U *) noexcept {}
    template <typename U, typename... Arguments> void construct(U *place, Arguments &&...arguments) {
        std::construct_at(place, std::forward<Arguments>(arguments)...);
    }
};

template <typename T> using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace glint
