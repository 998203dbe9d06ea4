// The packet kernel for SSE4.2.
#include "kernel/packet/batch.hpp"
#include "kernel/packet/tile.hpp"

namespace glint {

const Kernel sse4_kernel = {Isa::sse4, HWY_NAMESPACE::scratch_bytes, HWY_NAMESPACE::render_tile,
                            HWY_NAMESPACE::closest_hits, HWY_NAMESPACE::any_hits};

} // namespace glint
