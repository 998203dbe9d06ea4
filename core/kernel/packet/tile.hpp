#pragma once
#include "kernel/packet/trace.hpp"
#include "kernel/kernel.hpp"
namespace glint::HWY_NAMESPACE {
inline void render_tile(const KernelScene &a, const KernelFrame &b, Tile c, KernelScratch &d) { scalar_kernel.render_tile(a, b, c, d); }
}
