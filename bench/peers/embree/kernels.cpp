// Embree's kernels on sets of rays: every instruction set, packet width and hint that the machine has for them.
#include "bench/peers/embree/kernels.hpp"

#include "bench/peers/embree/device.hpp"
#include "bench/peers/embree/geometry.hpp"
#include "bench/peers/embree/packed_query.hpp"

namespace glint::bench::embree {
namespace {

constexpr unsigned stream = 0; ///< stands for a packet width

struct Way {
    DeviceIsa isa;
    RTCScene scene;
    const char *tree;
    unsigned width;
    bool coherent;

    [[nodiscard]] std::string name(RayQuestion question) const {
        std::string text = isa.name;
        text += question == RayQuestion::any_hit ? " occluded" : " intersect";
        text += width == stream ? "1M" : std::to_string(width);
        if (coherent) text += " coherent";
        return text + ", " + tree + " tree";
    }
};

template <template <int> class Query>
std::unique_ptr<PeerQuery> packets_of(unsigned width, const RaySet &rays, const Target &target) {
    switch (width) {
    case 4:
        return std::make_unique<Query<4>>(rays, target);
    case 8:
        return std::make_unique<Query<8>>(rays, target);
    case 16:
        return std::make_unique<Query<16>>(rays, target);
    default:
        return std::make_unique<Query<1>>(rays, target);
    }
}

class Kernels final : public PeerKernels {
public:
    Kernels(std::shared_ptr<const Scene> scene, Isa limit) : scene_(std::move(scene)), meshes_(*scene_) {
        std::vector<DeviceIsa> isas = isas_within(limit);
        // The narrowest of three never wins, and trying takes time.
        if (isas.size() > 2) isas.erase(isas.begin());
        for (const DeviceIsa &isa : isas) {
            Result<Device> device = open_device(isa.name, 0);
            if (!device) continue;
            devices_.push_back(std::move(*device));
            for (const TreeKind &tree : {low_tree, medium_tree, high_tree, robust_tree}) {
                scenes_.push_back(meshes_.build(devices_.back().get(), tree));
                add_ways(isa, scenes_.back().get(), tree.name);
            }
        }
    }

    [[nodiscard]] std::vector<std::string> ways(RayQuestion question) const override {
        std::vector<std::string> names;
        for (const Way &way : ways_) names.push_back(way.name(question));
        return names;
    }

    [[nodiscard]] std::unique_ptr<PeerQuery> query(const RaySet &rays, size_t index) const override {
        const Way &way = ways_[index];
        const Target target{way.scene, meshes_,
                            way.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT};
        if (rays.question == RayQuestion::any_hit) {
            if (way.width == stream) return std::make_unique<AnyHitStream>(rays, target);
            return packets_of<AnyHitQuery>(way.width, rays, target);
        }
        if (way.width == stream) return std::make_unique<ClosestHitStream>(rays, target);
        return packets_of<ClosestHitQuery>(way.width, rays, target);
    }

private:
    void add_ways(const DeviceIsa &isa, RTCScene scene, const char *tree) {
        for (const unsigned width : {stream, 1u, 4u, 8u, 16u}) {
            if (width > isa.max_width) continue;
            for (const bool coherent : {false, true}) {
                if (width == 1 && coherent) continue; // a lone ray has nothing to be coherent with
                ways_.push_back({isa, scene, tree, width, coherent});
            }
        }
    }

    std::shared_ptr<const Scene> scene_;
    SharedMeshes meshes_;
    std::vector<Device> devices_;
    std::vector<SceneHandle> scenes_; // released before their devices
    std::vector<Way> ways_;
};

} // namespace

Result<std::unique_ptr<PeerKernels>> make_kernels(std::shared_ptr<const Scene> scene, Isa isa) {
    auto kernels = std::make_unique<Kernels>(std::move(scene), isa);
    if (kernels->ways(RayQuestion::closest_hit).empty()) {
        return Error(ErrorCode::unsupported, "Embree has no kernels for this machine");
    }
    return std::unique_ptr<PeerKernels>(std::move(kernels));
}

} // namespace glint::bench::embree
