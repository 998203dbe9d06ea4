// Memory that runs out when a test wants it to. Only for programs that link failing_memory.cpp, which replaces operator
// new and pthread_create for the whole program.
#pragma once

#include <cstdint>

namespace glint::test {

/// While it lives, allocation number `first` from its making on fails, on whichever thread; with `for_good` all after
/// it as well.
class FailingMemory {
public:
    explicit FailingMemory(int64_t first, bool for_good);
    ~FailingMemory();
    FailingMemory(const FailingMemory &) = delete;
    FailingMemory &operator=(const FailingMemory &) = delete;

    /// Whether one failed.
    [[nodiscard]] static bool has_failed();
};

/// Allocations that were not given back yet.
[[nodiscard]] int64_t live_allocations();

#ifndef GLINT_SANITIZED // sanitizers have a pthread_create of their own

/// While it lives, the system gives so many threads and no more.
class FewThreads {
public:
    explicit FewThreads(int64_t count);
    ~FewThreads();
    FewThreads(const FewThreads &) = delete;
    FewThreads &operator=(const FewThreads &) = delete;
};

#endif

} // namespace glint::test
