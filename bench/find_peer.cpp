// The ray tracers that Glint can be measured beside, by name.
#include "bench/find_peer.hpp"

#include <string>

#if GLINT_WITH_EMBREE
#include "bench/peers/embree/peer.hpp"
#endif

namespace glint::bench {

Result<const Peer *> find_peer(std::string_view name) {
    if (name != "embree") {
        return Error(ErrorCode::bad_input, "unknown peer '" + std::string(name) + "'; there is: embree");
    }
#if GLINT_WITH_EMBREE
    return &embree::peer();
#else
    return Error(ErrorCode::unsupported, "built without Embree: install libembree-dev",
                 "then configure and build Glint again");
#endif
}

} // namespace glint::bench
