// How much time and memory one small text may take.
#include "fuzz/budget.hpp"

#include <atomic>
#include <cstdint>

#include "fuzz/verdict.hpp"

#ifdef GLINT_FUZZERS
#include <sanitizer/allocator_interface.h>
#endif

namespace glint::fuzz {

namespace {

/// Since the input's beginning: less than nothing where more was freed than asked for.
std::atomic<int64_t> bytes_in_use{0}, bytes_at_most{0};

#ifdef GLINT_FUZZERS
void on_malloc(const volatile void *, size_t size) {
    const auto bytes = static_cast<int64_t>(size);
    const int64_t now = bytes_in_use.fetch_add(bytes, std::memory_order_relaxed) + bytes;
    if (now > bytes_at_most.load(std::memory_order_relaxed)) bytes_at_most.store(now, std::memory_order_relaxed);
}

void on_free(const volatile void *memory) {
    if (!memory) return;
    const auto bytes = static_cast<int64_t>(__sanitizer_get_allocated_size(memory));
    bytes_in_use.fetch_sub(bytes, std::memory_order_relaxed);
}

[[maybe_unused]] const int hooks = __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free);
#endif

} // namespace

Budget::Budget() : start_(std::clock()) {
    bytes_in_use = 0;
    bytes_at_most = 0;
}

void Budget::require_kept() const {
    require(static_cast<double>(std::clock() - start_) < most_seconds * CLOCKS_PER_SEC, "this text takes too long");
    require(bytes_at_most < most_bytes, "this text takes too much memory");
}

} // namespace glint::fuzz
