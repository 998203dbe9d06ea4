// Runs tasks that spawn tasks.
#include "accel/task_group.hpp"

#include <system_error>
#include <thread>
#include <utility>

namespace glint {

void TaskGroup::spawn(std::function<void()> task) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(task));
    }
    changed_.notify_one();
}

void TaskGroup::run(unsigned threads) {
    {
        std::vector<std::jthread> others;
        try {
            for (unsigned i = 1; i < threads; ++i) others.emplace_back([this] { work(); });
        } catch (const std::system_error &) {
            // The system gives no more threads: go on with those there are.
        }
        work();
    }
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void TaskGroup::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return !waiting_.empty() || running_ == 0; });
        if (waiting_.empty()) return;
        std::function<void()> task = std::move(waiting_.back());
        waiting_.pop_back();
        ++running_;
        lock.unlock();
        std::exception_ptr failure;
        try {
            task();
            task = nullptr; // what it holds is freed outside the lock
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        --running_;
        if (failure) {
            if (!failure_) failure_ = failure;
            waiting_.clear();
        }
        if (running_ == 0 && waiting_.empty()) changed_.notify_all();
    }
}

} // namespace glint
