// Building the acceleration structure: Glint's kd-tree and what a peer builds, on the same meshes.
#pragma once

#include <memory>
#include <vector>

#include <glint/isa.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

#include "bench/peers/peer.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

struct BuildRow {
    uint32_t triangles = 0;
    unsigned threads = 0;
    Summary glint_ms;
    Summary peer_ms;      ///< at the peer's standard quality
    Summary peer_high_ms; ///< at its highest
    double glint_bytes_per_triangle = 0.0;
    double peer_bytes_per_triangle = 0.0;
    double peer_high_bytes_per_triangle = 0.0;
};

/// Builds in turns: at least three times each, and for `min_seconds` in all. Fails as the peer does.
[[nodiscard]] Result<BuildRow> compare_builds(const std::shared_ptr<const Scene> &scene, const Peer &peer, Isa isa,
                                              unsigned threads, double min_seconds);

} // namespace glint::bench
