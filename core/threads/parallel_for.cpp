// A loop whose turns are shared out among threads.
#include "threads/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

#include "threads/shared_work.hpp"
#include "threads/thread_group.hpp"

namespace glint {

void parallel_for(size_t count, const Crew &crew, const std::function<void(size_t, unsigned)> &body) {
    std::atomic<size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&](unsigned thread) {
        try {
            for (size_t i = next++; i < count; i = next++) body(i, thread);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    };
    const auto wanted = static_cast<unsigned>(std::min<size_t>(crew.threads, count));
    if (crew.host && wanted > 1) {
        work_on_host(*crew.host, wanted, work);
    } else {
        ThreadGroup others;
        try {
            for (unsigned i = 1; i < wanted; ++i) others.start([&work, i] { work(i); });
        } catch (const std::exception &) {
            // The system gives no more threads: go on with those there are.
        }
        work(0);
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace glint
