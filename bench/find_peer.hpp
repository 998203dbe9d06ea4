// The ray tracers that Glint can be measured beside, by name.
#pragma once

#include <string_view>

#include <glint/result.hpp>

#include "bench/peers/peer.hpp"

namespace glint::bench {

/// "embree" is all there is. Fails with bad_input for any other name, and with unsupported, saying what to install,
/// where Glint was built without it. The peer lives as long as the program.
[[nodiscard]] Result<const Peer *> find_peer(std::string_view name);

} // namespace glint::bench
