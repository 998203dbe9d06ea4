// Chooses among the kernels that were built in.
#include "kernel/kernel.hpp"

namespace glint {

Kernel best_kernel() {
    return {"scalar", render_tile_scalar};
}

} // namespace glint
