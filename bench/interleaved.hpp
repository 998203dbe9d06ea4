// Timing two things in turns, so that whatever disturbs the machine disturbs both.
#pragma once

#include <chrono>
#include <utility>
#include <vector>

#include "bench/statistics.hpp"

namespace glint::bench {

/// Milliseconds that a call takes.
template <typename Call> [[nodiscard]] double time_ms(const Call &call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// What was measured of two things in turns.
struct Turns {
    std::vector<double> glint_ms, peer_ms;

    /// One turn each; every other time the peer begins. A thing is a pair of prepare(), which is not timed, and run().
    template <typename Glint, typename Peer> void take(const Glint &glint, const Peer &peer) {
        const auto turn = [](const auto &thing, std::vector<double> &times) {
            thing.prepare();
            times.push_back(time_ms([&] { thing.run(); }));
        };
        const bool peer_begins = glint_ms.size() % 2 == 1;
        if (peer_begins) turn(peer, peer_ms);
        turn(glint, glint_ms);
        if (!peer_begins) turn(peer, peer_ms);
    }
};

} // namespace glint::bench
