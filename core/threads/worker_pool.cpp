// Threads that wait close by.
#include "threads/worker_pool.hpp"

#include <algorithm>
#include <exception>

#include "threads/shared_work.hpp"
#include "threads/wait_for_change.hpp"

namespace glint {

WorkerPool::WorkerPool(const Crew &crew) : host_(crew.host), threads_(std::max(1u, crew.threads)) {
    if (host_) return;
    try {
        for (unsigned worker = 1; worker < threads_; ++worker) {
            workers_.start([this, worker] { live(worker); });
        }
    } catch (const std::exception &) {
        // The system gives no more threads: fewer do the same work.
    }
    threads_ = static_cast<unsigned>(workers_.count()) + 1;
}

WorkerPool::~WorkerPool() {
    stopping_.store(true);
    epoch_.fetch_add(1);
    epoch_.notify_all();
    workers_.join(); // while the atomics are still there
}

void WorkerPool::run(const std::function<void(unsigned)> &work) {
    if (host_) return work_on_host(*host_, threads_, work);
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
