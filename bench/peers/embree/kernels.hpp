// Embree's kernels on sets of rays: single rays, packets and streams, coherent or not.
#pragma once

#include <memory>

#include "bench/peers/peer.hpp"

namespace glint::bench::embree {

/// Fails with unsupported where Embree opens no device.
[[nodiscard]] Result<std::unique_ptr<PeerKernels>> make_kernels(std::shared_ptr<const Scene> scene, Isa isa);

} // namespace glint::bench::embree
