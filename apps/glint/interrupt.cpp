// SIGINT and SIGTERM: stop what can be stopped, and end with the exit code of an interrupted program.
#include "interrupt.hpp"

#include <atomic>
#include <cassert>
#include <csignal>

#include <unistd.h>

#include "exit_code.hpp"

namespace glint::cli {
namespace {

// A signal handler can reach nothing but what is global. Lock-free, so that it may.
std::atomic<RenderControl *> guarded{nullptr};
static_assert(std::atomic<RenderControl *>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void on_interrupt(int) {
    if (RenderControl *control = guarded.load(); control && !control->cancelled()) {
        control->cancel();
        return;
    }
    ::_exit(static_cast<int>(ExitCode::interrupted)); // nothing else may be called from here
}

} // namespace

void handle_interrupts() {
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
}

InterruptGuard::InterruptGuard(RenderControl &control) {
    assert(guarded.load() == nullptr);
    guarded.store(&control);
}

InterruptGuard::~InterruptGuard() {
    guarded.store(nullptr);
}

} // namespace glint::cli
