// Memory and threads that run out when a test wants them to.
#include "host/failing_memory.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

#include <dlfcn.h>
#include <pthread.h>

namespace glint::test {

namespace {

constexpr int64_t never = std::numeric_limits<int64_t>::max();

std::atomic<int64_t> left_to_failure{never};
std::atomic<bool> fails_for_good{false}, failed{false};
std::atomic<int64_t> live{0};
std::atomic<int64_t> threads_left{never};

void *allocate(size_t bytes, size_t alignment) {
    if (left_to_failure.load(std::memory_order_relaxed) != never) {
        const int64_t left = left_to_failure.fetch_sub(1) - 1;
        if (left == 0 || (left < 0 && fails_for_good.load())) {
            failed = true;
            throw std::bad_alloc();
        }
    }
    void *const memory = alignment > alignof(std::max_align_t)
                             ? std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)
                             : std::malloc(bytes > 0 ? bytes : 1);
    if (!memory) throw std::bad_alloc();
    live.fetch_add(1, std::memory_order_relaxed);
    return memory;
}

void release(void *memory) {
    if (memory) live.fetch_sub(1, std::memory_order_relaxed);
    std::free(memory);
}

} // namespace

FailingMemory::FailingMemory(int64_t first, bool for_good) {
    failed = false;
    fails_for_good = for_good;
    left_to_failure = first;
}
FailingMemory::~FailingMemory() {
    left_to_failure = never;
}
bool FailingMemory::has_failed() {
    return failed;
}

int64_t live_allocations() {
    return live;
}

#ifndef GLINT_SANITIZED
FewThreads::FewThreads(int64_t count) {
    threads_left = count;
}
FewThreads::~FewThreads() {
    threads_left = never;
}
#endif

} // namespace glint::test

// The library's other forms of new and delete come to these.
void *operator new(size_t bytes) {
    return glint::test::allocate(bytes, 0);
}
void *operator new(size_t bytes, std::align_val_t alignment) {
    return glint::test::allocate(bytes, static_cast<size_t>(alignment));
}
void operator delete(void *memory) noexcept {
    glint::test::release(memory);
}
void operator delete(void *memory, size_t) noexcept {
    glint::test::release(memory);
}
void operator delete(void *memory, std::align_val_t) noexcept {
    glint::test::release(memory);
}
void operator delete(void *memory, size_t, std::align_val_t) noexcept {
    glint::test::release(memory);
}

#ifdef GLINT_SANITIZED
// Sanitizers bring all forms, which would not come to those above.
void *operator new[](size_t bytes) {
    return glint::test::allocate(bytes, 0);
}
void *operator new(size_t bytes, const std::nothrow_t &) noexcept {
    try {
        return glint::test::allocate(bytes, 0);
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}
void *operator new[](size_t bytes, const std::nothrow_t &) noexcept {
    return operator new(bytes, std::nothrow);
}
void operator delete[](void *memory) noexcept {
    glint::test::release(memory);
}
void operator delete[](void *memory, size_t) noexcept {
    glint::test::release(memory);
}
#else
extern "C" __attribute__((visibility("default"))) int
pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*begin)(void *), void *with) {
    using Create = int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    if (glint::test::threads_left.fetch_sub(1) <= 0) return EAGAIN;
    return create(thread, attributes, begin, with);
}
#endif
