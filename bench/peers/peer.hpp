// Another ray tracer that Glint is measured beside: what it must be able to do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glint/framebuffer.hpp>
#include <glint/isa.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

#include "bench/peers/ray_set.hpp"

namespace glint::bench {

/// A set of rays in the peer's own layout, and one of its ways to trace them. Rays are numbered as in the RaySet.
class PeerQuery {
public:
    virtual ~PeerQuery() = default;

    /// Makes rays first <= i < first + count ready to be traced, for the first time or again. Not timed.
    virtual void reset(size_t first, size_t count) = 0;
    /// Traces these rays on the calling thread; `first` is a multiple of 64. Different rays may be traced at once.
    virtual void trace(size_t first, size_t count) = 0;
    /// The outcome of the latest trace of every ray.
    virtual void read(RayAnswers &answers) const = 0;
};

/// The peer's kernels on one scene.
class PeerKernels {
public:
    virtual ~PeerKernels() = default;

    /// Names of the ways that it has to answer this question, e.g. "avx512 intersect16 coherent, high tree".
    [[nodiscard]] virtual std::vector<std::string> ways(RayQuestion question) const = 0;
    /// `way` counts within ways(rays.question).
    [[nodiscard]] virtual std::unique_ptr<PeerQuery> query(const RaySet &rays, size_t way) const = 0;
};

/// What building its acceleration structure costs the peer.
struct PeerBuild {
    double milliseconds;
    uint64_t bytes; ///< that the structure keeps, without the meshes it was built from
};

enum class BuildQuality {
    standard, ///< what the peer does when it is not told otherwise
    high,     ///< the fastest tree to trace that it can build
};

/// A Whitted ray tracer on the peer's kernels: the same picture as glint::Renderer's, but for rounding.
class PeerRenderer {
public:
    virtual ~PeerRenderer() = default;

    /// Fills the framebuffer's rgba8() with the scene as its own camera sees it.
    virtual void render(Framebuffer &target, uint32_t max_depth) = 0;
    /// How it traces, e.g. "avx512 packets of 16, low tree".
    [[nodiscard]] virtual std::string kernel() const = 0;
};

/// `isa` limits what the peer may use to what Glint uses; Isa::scalar, which no peer has, sets no limit.
class Peer {
public:
    virtual ~Peer() = default;

    /// Name and version.
    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual Result<std::unique_ptr<PeerKernels>> kernels(std::shared_ptr<const Scene> scene,
                                                                       Isa isa) const = 0;
    [[nodiscard]] virtual Result<PeerBuild> build(const Scene &scene, Isa isa, unsigned threads,
                                                  BuildQuality quality) const = 0;
    /// `threads` counts the calling one.
    [[nodiscard]] virtual Result<std::unique_ptr<PeerRenderer>> renderer(std::shared_ptr<const Scene> scene, Isa isa,
                                                                         unsigned threads) const = 0;
};

} // namespace glint::bench
