// The packet kernel for NEON.
#include "kernel/packet/batch.hpp"
#include "kernel/packet/tile.hpp"

namespace glint {

const Kernel neon_kernel = {Isa::neon, HWY_NAMESPACE::scratch_bytes, HWY_NAMESPACE::render_tile,
                            HWY_NAMESPACE::closest_hits, HWY_NAMESPACE::any_hits};

} // namespace glint
