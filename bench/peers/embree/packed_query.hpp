// A set of rays in one of Embree's layouts, and the call that traces them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/peers/embree/flush_denormals.hpp"
#include "bench/peers/embree/geometry.hpp"
#include "bench/peers/embree/packets.hpp"
#include "bench/peers/peer.hpp"

namespace glint::bench::embree {

/// What rays are traced in, and the hint that Embree gets with them.
struct Target {
    RTCScene scene;
    const SharedMeshes &meshes;
    RTCIntersectContextFlags coherence;

    [[nodiscard]] RTCIntersectContext context() const {
        RTCIntersectContext made;
        rtcInitIntersectContext(&made);
        made.flags = coherence;
        return made;
    }
};

/// Packets of N rays; the last one may hold rays that do not count. `Packet` is Embree's type for the question.
template <int N, typename Packet> class PackedQuery : public PeerQuery {
public:
    PackedQuery(const RaySet &rays, const Target &target)
        : target_(target), rays_(rays), packets_((rays.size() + N - 1) / N) {
        for (size_t i = 0; i < packets_.size() * N; ++i) pack(i, std::min(i, rays.size() - 1));
    }

protected:
    static auto &ray_part(Packet &packet) {
        if constexpr (requires { packet.hit; })
            return packet.ray;
        else
            return packet;
    }

    /// Calls trace_packet(valid, packet) for each packet of these rays.
    template <typename TracePacket> void for_each_packet(size_t first, size_t count, const TracePacket &trace_packet) {
        alignas(64) int valid[N];
        std::fill_n(valid, N, -1);
        const FlushDenormals mode;
        for (size_t ray = first; ray < first + count; ray += N) {
            const size_t rest = first + count - ray;
            for (size_t lane = rest; lane < N; ++lane) valid[lane] = 0;
            trace_packet(valid, packets_[ray / N]);
        }
    }

    void reset_reach(size_t first, size_t count) {
        for (size_t i = first; i < first + count; ++i) lanes(ray_part(packets_[i / N]).tfar)[i % N] = rays_.t_max[i];
    }

    const Target target_;
    const RaySet &rays_;
    std::vector<Packet> packets_;

private:
    void pack(size_t i, size_t source) {
        auto &ray = ray_part(packets_[i / N]);
        const size_t lane = i % N;
        lanes(ray.org_x)[lane] = rays_.org_x[source];
        lanes(ray.org_y)[lane] = rays_.org_y[source];
        lanes(ray.org_z)[lane] = rays_.org_z[source];
        lanes(ray.dir_x)[lane] = rays_.dir_x[source];
        lanes(ray.dir_y)[lane] = rays_.dir_y[source];
        lanes(ray.dir_z)[lane] = rays_.dir_z[source];
        lanes(ray.tnear)[lane] = 0.0f;
        lanes(ray.tfar)[lane] = rays_.t_max[source];
        lanes(ray.time)[lane] = 0.0f;
        lanes(ray.mask)[lane] = ~0u;
        lanes(ray.id)[lane] = 0;
        lanes(ray.flags)[lane] = 0;
    }
};

template <int N> class ClosestHitQuery : public PackedQuery<N, typename Packets<N>::RayHit> {
public:
    using PackedQuery<N, typename Packets<N>::RayHit>::PackedQuery;

    void reset(size_t first, size_t count) override {
        this->reset_reach(first, count);
        for (size_t i = first; i < first + count; ++i) {
            lanes(this->packets_[i / N].hit.geomID)[i % N] = RTC_INVALID_GEOMETRY_ID;
            lanes(this->packets_[i / N].hit.instID[0])[i % N] = RTC_INVALID_GEOMETRY_ID;
        }
    }

    void trace(size_t first, size_t count) override {
        RTCIntersectContext context = this->target_.context();
        this->for_each_packet(first, count, [&](const int *valid, auto &packet) {
            Packets<N>::intersect(valid, this->target_.scene, &context, &packet);
        });
    }

    void read(RayAnswers &answers) const override {
        for (size_t i = 0; i < this->rays_.size(); ++i) {
            auto packet = this->packets_[i / N];
            const uint32_t surface = lanes(packet.hit.geomID)[i % N];
            answers.t[i] = lanes(packet.ray.tfar)[i % N];
            answers.triangle_id[i] = surface == RTC_INVALID_GEOMETRY_ID
                                         ? no_triangle
                                         : this->target_.meshes.triangle_id(surface, lanes(packet.hit.primID)[i % N]);
        }
    }
};

template <int N> class AnyHitQuery : public PackedQuery<N, typename Packets<N>::Ray> {
public:
    using PackedQuery<N, typename Packets<N>::Ray>::PackedQuery;

    void reset(size_t first, size_t count) override { this->reset_reach(first, count); }

    void trace(size_t first, size_t count) override {
        RTCIntersectContext context = this->target_.context();
        this->for_each_packet(first, count, [&](const int *valid, auto &packet) {
            Packets<N>::occluded(valid, this->target_.scene, &context, &packet);
        });
    }

    void read(RayAnswers &answers) const override {
        for (size_t i = 0; i < this->rays_.size(); ++i) {
            auto packet = this->packets_[i / N];
            // Embree marks an occluded ray by a reach of minus infinity.
            answers.occluded[i] = lanes(packet.tfar)[i % N] < 0.0f ? 1 : 0;
        }
    }
};

/// Many single rays in one call.
class ClosestHitStream final : public ClosestHitQuery<1> {
public:
    using ClosestHitQuery<1>::ClosestHitQuery;

    void trace(size_t first, size_t count) override {
        RTCIntersectContext context = target_.context();
        const FlushDenormals mode;
        rtcIntersect1M(target_.scene, &context, &packets_[first], static_cast<unsigned>(count), sizeof(RTCRayHit));
    }
};

class AnyHitStream final : public AnyHitQuery<1> {
public:
    using AnyHitQuery<1>::AnyHitQuery;

    void trace(size_t first, size_t count) override {
        RTCIntersectContext context = target_.context();
        const FlushDenormals mode;
        rtcOccluded1M(target_.scene, &context, &packets_[first], static_cast<unsigned>(count), sizeof(RTCRay));
    }
};

} // namespace glint::bench::embree
