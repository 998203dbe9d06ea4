// Glint's kernels and a peer's on the same rays: millions of rays a second, class by class.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glint/ray_query.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

#include "bench/peers/peer.hpp"
#include "bench/ray_classes.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

struct KernelComparisonOptions {
    uint32_t size_px = 1024;             ///< of the square picture whose pixels make the primary rays
    std::vector<unsigned> threads = {1}; ///< numbers of threads, each measured for itself
    Isa isa = best_isa();
    double min_seconds = 2.0; ///< of timing for each class and number of threads, at least 3 passes over the rays
    /// Called before something is measured, with what it is. May be empty.
    std::function<void(const std::string &)> on_progress;
};

/// Whether two tracers found the same on one set of rays.
struct Agreement {
    uint64_t rays = 0;
    uint64_t glint_hits = 0;
    uint64_t peer_hits = 0;
    uint64_t same = 0; ///< rays with the same triangle, or the same yes or no

    /// Hit counts differ by at most 0.01 % of the rays. Not exactly: Glint decides a hit in double precision, a peer
    /// may do so in float, and then a ray along a silhouette or an edge may end up on either side of it.
    [[nodiscard]] bool hits_equal() const {
        const uint64_t difference = glint_hits > peer_hits ? glint_hits - peer_hits : peer_hits - glint_hits;
        return difference * 10000 <= rays;
    }
};

struct ClassRow {
    std::string ray_class; ///< "primary", ...
    unsigned threads = 0;
    uint64_t passes = 0;      ///< over all rays
    Summary glint_ms;         ///< of all rays
    Summary peer_ms;          ///< likewise
    double glint_mrays = 0.0; ///< millions of rays a second, at the median
    double peer_mrays = 0.0;
    std::string peer_kernel; ///< the fastest of the peer's ways
    Agreement agreement;

    [[nodiscard]] double ratio() const { return glint_mrays / peer_mrays; }
};

/// Measures every class that has rays. Peer and Glint take turns of some ten thousand rays; the peer with the fastest
/// of its ways, found beforehand. Fails as the peer does.
[[nodiscard]] Result<std::vector<ClassRow>> compare_kernels(const std::shared_ptr<const Accel> &accel,
                                                            const Viewpoint &viewpoint, const Peer &peer,
                                                            const KernelComparisonOptions &options);

/// Compares the answers to the same question, ray by ray.
[[nodiscard]] Agreement compare_answers(RayQuestion question, const RayAnswers &glint, const RayAnswers &peer);

} // namespace glint::bench
