// Waiting for what takes microseconds, or long.
#pragma once

#include <atomic>
#include <cstdint>

namespace glint {

/// Waits until the value differs from `old`, of which it must be notified: yielding for a moment, since it may change
/// at once, then asleep.
void wait_for_change(const std::atomic<uint32_t> &value, uint32_t old);

} // namespace glint
