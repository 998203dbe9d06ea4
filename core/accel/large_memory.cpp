// Memory for the large arrays that rays jump about in.
#include "accel/large_memory.hpp"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace glint {

namespace {

/// Of x86-64 and of most AArch64 systems.
constexpr size_t large_page = size_t{2} << 20;
constexpr size_t cache_line = 64;

bool is_large(size_t bytes) {
    return bytes >= 2 * large_page;
}

} // namespace

void *allocate_large(size_t bytes) {
    if (!is_large(bytes)) return ::operator new(bytes, std::align_val_t{cache_line});
    void *const memory = ::operator new(bytes, std::align_val_t{large_page});
#if defined(MADV_HUGEPAGE)
    ::madvise(memory, bytes, MADV_HUGEPAGE); // advice: where it is not taken, small pages do
#endif
    return memory;
}

void free_large(void *memory, size_t bytes) noexcept {
    if (is_large(bytes)) {
        ::operator delete(memory, std::align_val_t{large_page});
    } else {
        ::operator delete(memory, std::align_val_t{cache_line});
    }
}

} // namespace glint
