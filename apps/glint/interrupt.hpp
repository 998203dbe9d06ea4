// SIGINT and SIGTERM: stop what can be stopped, and end with the exit code of an interrupted program.
#pragma once

#include <glint/renderer.hpp>

namespace glint::cli {

/// From now on SIGINT and SIGTERM end the program at once with exit code 130, unless an InterruptGuard lives.
void handle_interrupts();

/// While it lives, the first SIGINT or SIGTERM cancels `control`, and a second one ends the program at once. The code
/// that it guards notices, cleans up and returns. One at a time.
class InterruptGuard {
public:
    explicit InterruptGuard(RenderControl &control);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard &) = delete;
    InterruptGuard &operator=(const InterruptGuard &) = delete;
};

} // namespace glint::cli
