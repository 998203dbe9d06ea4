// Which vector instructions trace: every choice makes the same picture, bit for bit.
#pragma once

#include <span>
#include <string_view>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint {

/// Instruction sets that a kernel may be compiled for.
enum class Isa {
    scalar, ///< one ray at a time, in portable C++: the definition of the picture
    sse4,   ///< SSE4.2, 4 floats
    avx2,   ///< AVX2, 8 floats
    avx512, ///< AVX-512 F, BW, CD, DQ and VL, 16 floats
    neon,   ///< AArch64 NEON, 4 floats
    wasm,   ///< WebAssembly SIMD, 4 floats
};

/// "scalar", "sse4", ...
[[nodiscard]] GLINT_API std::string_view isa_name(Isa isa);
/// Those that were built in and that this machine can run, slowest first; never empty.
[[nodiscard]] GLINT_API std::span<const Isa> available_isas();
/// What is used where nobody chooses: the last of available_isas().
[[nodiscard]] GLINT_API Isa best_isa();
/// The available instruction set of that name. Fails with `bad_input`, and says which there are, when the name is
/// unknown, was not built in, or needs another machine.
[[nodiscard]] GLINT_API Result<Isa> find_isa(std::string_view name);

} // namespace glint
