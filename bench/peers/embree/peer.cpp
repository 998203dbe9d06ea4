// Embree as a peer: its parts under one roof.
#include "bench/peers/embree/peer.hpp"

#include "bench/peers/embree/build.hpp"
#include "bench/peers/embree/device.hpp"
#include "bench/peers/embree/kernels.hpp"
#include "bench/peers/embree/whitted_renderer.hpp"

namespace glint::bench::embree {
namespace {

class EmbreePeer final : public Peer {
public:
    [[nodiscard]] std::string name() const override { return version_text(); }

    [[nodiscard]] Result<std::unique_ptr<PeerKernels>> kernels(std::shared_ptr<const Scene> scene,
                                                               Isa isa) const override {
        return make_kernels(std::move(scene), isa);
    }
    [[nodiscard]] Result<PeerBuild> build(const Scene &scene, Isa isa, unsigned threads,
                                          BuildQuality quality) const override {
        return measure_build(scene, isa, threads, quality);
    }
    [[nodiscard]] Result<std::unique_ptr<PeerRenderer>> renderer(std::shared_ptr<const Scene> scene, Isa isa,
                                                                 unsigned threads) const override {
        return make_renderer(std::move(scene), isa, threads);
    }
};

} // namespace

const Peer &peer() {
    static const EmbreePeer embree;
    return embree;
}

} // namespace glint::bench::embree
