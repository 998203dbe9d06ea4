// Threads that are joined at the end of a scope. (std::jthread does as much, but not every C++ library has it: LLVM's
// did not for years, and so no phone.)
#pragma once

#include <thread>
#include <utility>
#include <vector>

namespace glint {

class ThreadGroup {
public:
    ThreadGroup() = default;
    ~ThreadGroup() { join(); }
    ThreadGroup(const ThreadGroup &) = delete;
    ThreadGroup &operator=(const ThreadGroup &) = delete;

    /// Starts a thread; throws std::system_error where the system gives none.
    template <typename Work> void start(Work &&work) { threads_.emplace_back(std::forward<Work>(work)); }

    void join() {
        for (std::thread &thread : threads_) thread.join();
        threads_.clear();
    }
    [[nodiscard]] size_t count() const { return threads_.size(); }

private:
    std::vector<std::thread> threads_;
};

} // namespace glint
