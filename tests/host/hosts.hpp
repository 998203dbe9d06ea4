// Hosts that lend their threads in all the ways they may.
#pragma once

#include <condition_variable>
#include <list>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <glint/host_threads.hpp>

namespace glint::test {

/// A pool of so many threads that take tasks from a queue.
class HostPool {
public:
    explicit HostPool(unsigned threads) {
        for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { live(); });
    }
    /// Runs what is left.
    ~HostPool() {
        {
            const std::lock_guard lock(mutex_);
            closing_ = true;
        }
        changed_.notify_all();
        for (std::thread &thread : threads_) thread.join();
    }
    HostPool(const HostPool &) = delete;
    HostPool &operator=(const HostPool &) = delete;

    void enqueue(std::function<void()> task) {
        {
            const std::lock_guard lock(mutex_);
            tasks_.push_back(std::move(task));
        }
        changed_.notify_all();
    }
    [[nodiscard]] SubmitTask submit() {
        return [this](std::function<void()> task) { enqueue(std::move(task)); };
    }
    /// Waits until all tasks have run.
    void drain() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return tasks_.empty() && busy_ == 0; });
    }

private:
    void live() {
        while (true) {
            std::function<void()> task;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return closing_ || !tasks_.empty(); });
                if (tasks_.empty()) return;
                task = std::move(tasks_.front());
                tasks_.pop_front();
                ++busy_;
            }
            task();
            task = nullptr;
            const std::lock_guard lock(mutex_);
            --busy_;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::list<std::function<void()>> tasks_; // keeps no memory when it is empty
    size_t busy_ = 0;
    bool closing_ = false;
    std::vector<std::thread> threads_;
};

/// Keeps tasks until somebody wants them run.
class LazyHost {
public:
    [[nodiscard]] SubmitTask submit() {
        return [this](std::function<void()> task) { tasks_.push_back(std::move(task)); };
    }
    [[nodiscard]] size_t count() const { return tasks_.size(); }
    /// One after another, on the calling thread.
    void run_all() {
        for (auto &task : std::exchange(tasks_, {})) task();
    }

private:
    std::vector<std::function<void()>> tasks_;
};

/// A hook, by its name.
struct NamedHost {
    std::string name;
    SubmitTask submit;
};

/// Every way that needs no thread: within the call, twice, never, not even taken.
[[nodiscard]] inline std::vector<NamedHost> hosts_without_threads() {
    return {{"at once", [](const std::function<void()> &task) { task(); }},
            {"twice", [](const std::function<void()> &task) { task(), task(); }},
            {"never", [](const std::function<void()> &) {}},
            {"refused", [](const std::function<void()> &) { throw std::runtime_error("the host has no time"); }}};
}

} // namespace glint::test
