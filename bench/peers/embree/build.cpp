// What it costs Embree to build a scene: time, and the memory that it keeps.
#include "bench/peers/embree/build.hpp"

#include <atomic>
#include <chrono>

#include "bench/peers/embree/device.hpp"
#include "bench/peers/embree/geometry.hpp"

namespace glint::bench::embree {
namespace {

/// Embree's account of what it allocates; the meshes are shared with it and not part of that.
bool count_bytes(void *held, ssize_t bytes, bool /*after*/) {
    static_cast<std::atomic<int64_t> *>(held)->fetch_add(bytes, std::memory_order_relaxed);
    return true;
}

} // namespace

Result<PeerBuild> measure_build(const Scene &scene, Isa isa, unsigned threads, BuildQuality quality) {
    const std::vector<DeviceIsa> isas = isas_within(isa);
    if (isas.empty()) return Error(ErrorCode::unsupported, "Embree has no kernels for this machine");
    Result<Device> device = open_device(isas.back().name, threads);
    if (!device) return device.error();

    std::atomic<int64_t> held{0};
    rtcSetDeviceMemoryMonitorFunction(device->get(), count_bytes, &held);
    const SharedMeshes meshes(scene);
    const auto start = std::chrono::steady_clock::now();
    SceneHandle tree = meshes.build(device->get(), quality == BuildQuality::high ? high_tree : medium_tree);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    const PeerBuild build{time.count(), static_cast<uint64_t>(std::max<int64_t>(held.load(), 0))};
    tree.reset(); // while what counts its memory is there
    device->reset();
    return build;
}

} // namespace glint::bench::embree
