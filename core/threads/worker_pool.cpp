// Threads that wait close by.
#include "threads/worker_pool.hpp"

#include <chrono>
#include <system_error>

namespace glint {

namespace {

/// Waits until the value differs from `old`: yielding for a moment, since the next frame may come at once, then asleep.
void wait_for_change(const std::atomic<uint32_t> &value, uint32_t old) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::microseconds(50);
    while (value.load(std::memory_order_acquire) == old) {
        std::this_thread::yield();
        if (std::chrono::steady_clock::now() > patience) {
            value.wait(old, std::memory_order_acquire);
            return;
        }
    }
}

} // namespace

WorkerPool::WorkerPool(unsigned threads) {
    try {
        for (unsigned worker = 1; worker < threads; ++worker) {
            workers_.start([this, worker] { live(worker); });
        }
    } catch (const std::system_error &) {
        // Fewer threads trace the same picture.
    }
}

WorkerPool::~WorkerPool() {
    stopping_.store(true);
    epoch_.fetch_add(1);
    epoch_.notify_all();
    workers_.join(); // while the atomics are still there
}

void WorkerPool::run(const std::function<void(unsigned)> &work) {
    work_ = &work;
    open_.store(true);
    epoch_.fetch_add(1);
    epoch_.notify_all();
    work(0);
    open_.store(false);
    // A worker counts itself in before it looks whether the job is open, and the job was closed before this looks at
    // the count: in the single order of these operations, whoever got in is seen here, and whoever is not sees a closed
    // job.
    for (uint32_t inside = inside_.load(); inside != 0; inside = inside_.load()) wait_for_change(inside_, inside);
}

void WorkerPool::live(unsigned worker) {
    uint32_t seen = 0;
    while (true) {
        wait_for_change(epoch_, seen);
        seen = epoch_.load();
        if (stopping_.load()) return;
        inside_.fetch_add(1);
        if (open_.load()) (*work_)(worker);
        inside_.fetch_sub(1);
        inside_.notify_all();
    }
}

} // namespace glint
