// Work that whoever comes in time takes part in, and that nobody is waited for who has not come.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <utility>

#include <glint/host_threads.hpp>

namespace glint {

/// Work that shares out its own parts: work(worker) returns when no part is left to begin, and throws nothing. Whoever
/// may come late must keep this object alive; once closed it touches nothing of the work.
class SharedWork {
public:
    /// At most so many work at it, as workers 0 .. most - 1.
    SharedWork(std::function<void(unsigned)> work, unsigned most) : work_(std::move(work)), most_(most) {}

    /// Works, unless the work is closed or has all its workers, and then closes it, since nothing is left to begin.
    /// Returns whether the work is over with this: true for one of all the calls.
    bool take_part();

    /// The same for work of one's own at it: between the two calls it cannot come to its end.
    void enter() { inside_.fetch_add(1); }
    bool leave();

    /// Lets nobody in any more, and waits for those inside.
    void close();

private:
    const std::function<void(unsigned)> work_;
    const unsigned most_;
    std::atomic<bool> open_{true};
    std::atomic<bool> over_{false};   // whether somebody was told of the end
    std::atomic<uint32_t> inside_{0}; // who looks at the work
    std::atomic<uint32_t> next_{0};   // worker
};

/// Calls work(worker) on the calling thread and in those of the `threads` - 1 tasks handed to the host that begin
/// before it is done; returns when all calls have. `work` is as in SharedWork. Throws std::bad_alloc, before anything
/// is done.
void work_on_host(const SubmitTask &submit, unsigned threads, const std::function<void(unsigned)> &work);

/// Hands out so many tasks; fewer, where the host throws.
void submit_tasks(const SubmitTask &submit, unsigned count, const std::function<void()> &task);

} // namespace glint
