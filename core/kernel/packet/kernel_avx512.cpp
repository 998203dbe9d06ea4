// The packet kernel for AVX-512.
#include "kernel/packet/batch.hpp"
#include "kernel/packet/tile.hpp"

namespace glint {

const Kernel avx512_kernel = {Isa::avx512, HWY_NAMESPACE::scratch_bytes, HWY_NAMESPACE::render_tile,
                              HWY_NAMESPACE::closest_hits, HWY_NAMESPACE::any_hits};

} // namespace glint
