// Embree's device, and which instruction sets it may use.
#include "bench/peers/embree/device.hpp"

namespace glint::bench::embree {
namespace {

constexpr DeviceIsa embree_isas[] = {{"sse4.2", 4}, {"avx2", 8}, {"avx512", 16}};

unsigned widest_for(Isa isa) {
    switch (isa) {
    case Isa::sse4:
    case Isa::neon:
    case Isa::wasm:
        return 4;
    case Isa::avx2:
        return 8;
    case Isa::avx512:
    case Isa::scalar:
        break;
    }
    return 16;
}

} // namespace

std::vector<DeviceIsa> isas_within(Isa isa) {
    std::vector<DeviceIsa> found;
    for (const DeviceIsa &candidate : embree_isas) {
        // Embree knows best what it can run: it opens no device for an instruction set that the processor lacks.
        if (candidate.max_width <= widest_for(isa) && open_device(candidate.name, 1)) found.push_back(candidate);
    }
    return found;
}

Result<Device> open_device(const char *isa, unsigned threads) {
    const std::string config = "threads=" + std::to_string(threads) + ",isa=" + isa;
    Device device(rtcNewDevice(config.c_str()));
    if (device) return device;
    const int code = rtcGetDeviceError(nullptr);
    return Error(ErrorCode::unsupported,
                 "Embree opens no device for '" + config + "' (its error " + std::to_string(code) + ")");
}

std::string version_text() {
    return "Embree " RTC_VERSION_STRING;
}

} // namespace glint::bench::embree
