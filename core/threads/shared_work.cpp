// Work that whoever comes in time takes part in.
#include "threads/shared_work.hpp"

#include <memory>

#include "threads/wait_for_change.hpp"

namespace glint {

// One counts oneself in before one looks whether the work is open, and it is closed before the count is looked at: in
// the single order of these operations, whoever got in is seen in the count, and whoever is not sees closed work.

bool SharedWork::take_part() {
    enter();
    if (open_.load()) {
        const unsigned worker = next_.fetch_add(1);
        if (worker < most_) {
            work_(worker);
            open_.store(false);
        }
    }
    return leave();
}

bool SharedWork::leave() {
    const bool is_last = inside_.fetch_sub(1) == 1 && !open_.load();
    inside_.notify_all();
    return is_last && !over_.exchange(true);
}

void SharedWork::close() {
    open_.store(false);
    for (uint32_t inside = inside_.load(); inside != 0; inside = inside_.load()) wait_for_change(inside_, inside);
}

void submit_tasks(const SubmitTask &submit, unsigned count, const std::function<void()> &task) {
    try {
        for (unsigned i = 0; i < count; ++i) submit(task);
    } catch (...) {
        // Fewer threads do the same work.
    }
}

void work_on_host(const SubmitTask &submit, unsigned threads, const std::function<void(unsigned)> &work) {
    const auto shared = std::make_shared<SharedWork>([&work](unsigned worker) { work(worker); }, threads);
    submit_tasks(submit, threads - 1, [shared] { shared->take_part(); });
    shared->take_part();
    shared->close();
}

} // namespace glint
