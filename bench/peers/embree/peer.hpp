// Embree (Wald et al. 2014, "Embree: a kernel framework for efficient CPU ray tracing") as a peer.
#pragma once

#include "bench/peers/peer.hpp"

namespace glint::bench::embree {

/// Lives as long as the program.
[[nodiscard]] const Peer &peer();

} // namespace glint::bench::embree
