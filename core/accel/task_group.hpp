// Runs tasks that spawn tasks, on a fixed number of threads, until all are done.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace glint {

class TaskGroup {
public:
    /// Adds a task; from any thread, also from inside a task.
    void spawn(std::function<void()> task);

    /// Works on the tasks with this many threads, the calling one included, until none is left. Rethrows the first
    /// exception that a task threw; the tasks that had not begun by then are dropped.
    void run(unsigned threads);

private:
    void work();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::function<void()>> waiting_; // last in, first out: deep before wide keeps memory low
    unsigned running_ = 0;
    std::exception_ptr failure_;
};

} // namespace glint
