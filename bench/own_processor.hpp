// Keeping threads apart: unpinned, a system may leave two busy threads on one processor and so double a timing.
#pragma once

#include <sched.h>

namespace glint::bench {

/// While it lives, the calling thread has a processor of its own; threads that it starts through start_others() have
/// the rest of those that the process may use. Does nothing where there is only one, or where the system does not let
/// it: a timing then has more spread, but is no less true.
class OwnProcessor {
public:
    OwnProcessor();
    ~OwnProcessor();
    OwnProcessor(const OwnProcessor &) = delete;
    OwnProcessor &operator=(const OwnProcessor &) = delete;

    /// Calls start(), which may start threads; they inherit the other processors.
    template <typename Start> auto start_others(const Start &start) const {
        const Elsewhere elsewhere(*this);
        return start();
    }

private:
    class Elsewhere {
    public:
        explicit Elsewhere(const OwnProcessor &home) : home_(home) { move_to(home.others_); }
        ~Elsewhere() { move_to(home_.own_); }
        Elsewhere(const Elsewhere &) = delete;
        Elsewhere &operator=(const Elsewhere &) = delete;

    private:
        const OwnProcessor &home_;
    };

    static void move_to(const cpu_set_t &set);

    cpu_set_t all_, own_, others_;
};

} // namespace glint::bench
