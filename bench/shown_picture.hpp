// Checking that the surface shows what was rendered, to the last byte.
#pragma once

#include <cstdint>
#include <span>

#include <glint/framebuffer.hpp>
#include <glint/result.hpp>

namespace glint::bench {

/// Compares the surface's RGBA8 bytes, top row first, with the picture. Fails with io, naming the first differing
/// pixel and how many bytes differ, or that the sizes do.
[[nodiscard]] Status compare_shown(const Framebuffer &picture, std::span<const uint8_t> shown);

} // namespace glint::bench
