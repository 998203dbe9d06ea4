// Timing two things in turns, so that whatever disturbs the machine disturbs both.
#pragma once

#include <vector>

#include "bench/peers/stopwatch.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

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
