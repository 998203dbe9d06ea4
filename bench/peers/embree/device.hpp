// Embree's device and scene, owned; and which instruction sets it may use.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <embree3/rtcore.h>

#include <glint/isa.hpp>
#include <glint/result.hpp>

namespace glint::bench::embree {

struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

/// One of Embree's instruction sets.
struct DeviceIsa {
    const char *name;   ///< as Embree's configuration has it
    unsigned max_width; ///< rays in the widest packet it has kernels for
};

/// Those that this machine has, as far as Glint's instruction set allows, slowest first: no wider vectors than ours. No
/// limit for Isa::scalar, which Embree does not have.
[[nodiscard]] std::vector<DeviceIsa> isas_within(Isa isa);

/// A device for one instruction set whose builds use `threads` threads (0 = one a processor). Fails with unsupported
/// and Embree's error code.
[[nodiscard]] Result<Device> open_device(const char *isa, unsigned threads);

/// "Embree 3.13.5"
[[nodiscard]] std::string version_text();

} // namespace glint::bench::embree
