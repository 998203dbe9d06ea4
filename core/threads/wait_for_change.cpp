// Waiting for what takes microseconds, or long.
#include "threads/wait_for_change.hpp"

#include <chrono>
#include <thread>

namespace glint {

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

} // namespace glint
