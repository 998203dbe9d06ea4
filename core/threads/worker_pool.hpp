// Threads that wait close by: a frame takes a fraction of a millisecond, so waking them must take less.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "threads/crew.hpp"
#include "threads/thread_group.hpp"

namespace glint {

/// A fixed set of threads that work on one job at a time together with the thread that brings it. On the host's threads
/// it has none of its own, and hands out tasks for each job.
///
/// Between jobs a worker first spins for some microseconds, then sleeps. The caller never waits for a worker that has
/// not begun: one that wakes late finds the job closed and goes back to sleep.
class WorkerPool {
public:
    /// The crew's number of threads counts the caller: 1 starts no thread. Starts fewer where the system gives no more.
    explicit WorkerPool(const Crew &crew);
    ~WorkerPool();
    WorkerPool(const WorkerPool &) = delete;
    WorkerPool &operator=(const WorkerPool &) = delete;

    /// Threads that work on a job, the caller included.
    [[nodiscard]] unsigned threads() const { return threads_; }
    [[nodiscard]] bool is_own() const { return !host_; }

    /// Calls work(worker) at once on the calling thread and on those others that are awake in time, worker being a
    /// different number below threads() for each; returns when all calls have. `work` shares out its own parts and must
    /// not throw. One call of run() at a time. Throws std::bad_alloc, on the host's threads, before anything is done.
    void run(const std::function<void(unsigned worker)> &work);

private:
    void live(unsigned worker);

    const SubmitTask *host_;
    unsigned threads_;
    std::atomic<uint32_t> epoch_{0};  // counts jobs; changing it wakes the workers
    std::atomic<bool> open_{false};   // whether the current job takes more workers
    std::atomic<uint32_t> inside_{0}; // workers that look at the job
    std::atomic<bool> stopping_{false};
    const std::function<void(unsigned)> *work_ = nullptr; // valid while open_ or inside_ > 0
    ThreadGroup workers_;
};

} // namespace glint
