// What it costs Embree to build a scene.
#pragma once

#include "bench/peers/peer.hpp"

namespace glint::bench::embree {

/// Builds once, with the widest instruction set that `isa` allows, and measures. Fails with unsupported where Embree
/// opens no device.
[[nodiscard]] Result<PeerBuild> measure_build(const Scene &scene, Isa isa, unsigned threads, BuildQuality quality);

} // namespace glint::bench::embree
