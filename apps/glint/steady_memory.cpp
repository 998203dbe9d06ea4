#include "steady_memory.hpp"

#include <cstdlib> // says whether the library is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace glint::cli {

void keep_memory_steady() {
#ifdef __GLIBC__
    // Its own thresholds rise with every large block that is freed (mallopt(3)); those that were set stay. Heaps for
    // each thread are for programs that allocate all the time.
    mallopt(M_MMAP_THRESHOLD, 128 << 10);
    mallopt(M_ARENA_MAX, 1);
    malloc_trim(0);
#endif
}

} // namespace glint::cli
