// Memory for the large arrays that rays jump about in.
#pragma once

#include <cstddef>

namespace glint {

/// At least `bytes` bytes, not initialised, from the beginning of a cache line on (64 bytes); in large pages where it
/// is worth it and the system has them: a ray's jumps then miss the processor's address cache less often. Throws
/// std::bad_alloc.
[[nodiscard]] void *allocate_large(size_t bytes);
/// Gives back what allocate_large(bytes) gave.
void free_large(void *memory, size_t bytes) noexcept;

} // namespace glint
