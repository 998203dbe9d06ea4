// A Whitted renderer on Embree, for whole frames.
#pragma once

#include <memory>

#include "bench/peers/peer.hpp"

namespace glint::bench::embree {

/// Fails with unsupported where Embree opens no device, and for scenes of more than 31 lights.
[[nodiscard]] Result<std::unique_ptr<PeerRenderer>> make_renderer(std::shared_ptr<const Scene> scene, Isa isa,
                                                                  unsigned threads);

} // namespace glint::bench::embree
