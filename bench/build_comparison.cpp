// Building the acceleration structure: Glint's and a peer's.
#include "bench/build_comparison.hpp"

#include <glint/accel.hpp>

#include "bench/peers/stopwatch.hpp"

namespace glint::bench {

Result<BuildRow> compare_builds(const std::shared_ptr<const Scene> &scene, const Peer &peer, Isa isa, unsigned threads,
                                double min_seconds) {
    constexpr size_t min_rounds = 3;
    std::vector<double> glint_ms, peer_ms, peer_high_ms;
    uint64_t glint_bytes = 0, peer_bytes = 0, peer_high_bytes = 0;

    const auto build_peer = [&](BuildQuality quality, std::vector<double> &times, uint64_t &bytes) -> Status {
        const Result<PeerBuild> build = peer.build(*scene, isa, threads, quality);
        if (!build) return build.error();
        times.push_back(build->milliseconds);
        bytes = build->bytes;
        return Done{};
    };
    double spent_ms = 0.0;
    while (glint_ms.size() < min_rounds || spent_ms < 1000.0 * min_seconds) {
        Status built = Done{};
        spent_ms += time_ms([&] {
            std::shared_ptr<const Accel> accel;
            glint_ms.push_back(time_ms([&] { accel = Accel::build(scene, {.threads = threads}); }));
            glint_bytes = accel->statistics().bytes;
            accel.reset();
            built = build_peer(BuildQuality::standard, peer_ms, peer_bytes);
            if (built) built = build_peer(BuildQuality::high, peer_high_ms, peer_high_bytes);
        });
        if (!built) return built.error();
    }

    const double triangles = scene->triangle_count();
    BuildRow row;
    row.triangles = scene->triangle_count();
    row.threads = threads;
    row.glint_ms = summarize(std::move(glint_ms));
    row.peer_ms = summarize(std::move(peer_ms));
    row.peer_high_ms = summarize(std::move(peer_high_ms));
    row.glint_bytes_per_triangle = static_cast<double>(glint_bytes) / triangles;
    row.peer_bytes_per_triangle = static_cast<double>(peer_bytes) / triangles;
    row.peer_high_bytes_per_triangle = static_cast<double>(peer_high_bytes) / triangles;
    return row;
}

} // namespace glint::bench
