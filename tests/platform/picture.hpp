// Pictures that look different from every side, and comparing them with what a surface shows.
#pragma once

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <glint/framebuffer.hpp>
#include <glint/gles/presenter.hpp>

namespace glint::test {

/// Every byte random, alpha too: flipped, shifted, swapped or blended pixels are sure to show.
[[nodiscard]] Framebuffer random_picture(uint32_t width_px, uint32_t height_px, uint32_t seed);

/// Uploads and draws the picture in its own size, and reads the surface (of the same size) back: same bytes?
[[nodiscard]] testing::AssertionResult shows(gles::Surface &surface, gles::Presenter &presenter,
                                             const Framebuffer &picture);

/// Says where the first differing byte is.
[[nodiscard]] testing::AssertionResult same_bytes(const Framebuffer &picture, const std::vector<uint8_t> &shown);

} // namespace glint::test
