// Which kernels were built in, and which of them this machine can run.
#include "kernel/kernel.hpp"

#include <array>
#include <string>

namespace glint {

namespace {

constexpr Isa every_isa[] = {Isa::scalar, Isa::sse4, Isa::avx2, Isa::avx512, Isa::neon, Isa::wasm};

// Each names what packet/kernel_<isa>.cpp is compiled with (CMakeLists.txt); the compiler's runtime also asks whether
// the system saves the wide registers.
#if defined(__x86_64__) && defined(__GNUC__)
bool cpu_has_sse4() {
    return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
}
// Not asked: F16C, for which clang 16 has no name. Processors had it before they had AVX2, and the kernel has no use
// for it.
bool cpu_has_avx2() {
    return cpu_has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
}
bool cpu_has_avx512() {
    return cpu_has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
#endif

/// A kernel that was built in, and whether this machine can run it.
struct BuiltIn {
    Isa isa;
    const Kernel *kernel;
    bool runs_here;
};

/// Slowest first. A machine that can run one can run all before it.
auto built_in() {
    return std::array{
        BuiltIn{Isa::scalar, &scalar_kernel, true},
#ifdef GLINT_HAS_sse4
        BuiltIn{Isa::sse4, &sse4_kernel, cpu_has_sse4()},
#endif
#ifdef GLINT_HAS_avx2
        BuiltIn{Isa::avx2, &avx2_kernel, cpu_has_avx2()},
#endif
#ifdef GLINT_HAS_avx512
        BuiltIn{Isa::avx512, &avx512_kernel, cpu_has_avx512()},
#endif
#ifdef GLINT_HAS_neon
        BuiltIn{Isa::neon, &neon_kernel, true}, // part of every AArch64
#endif
#ifdef GLINT_HAS_wasm
        BuiltIn{Isa::wasm, &wasm_kernel, true}, // a module with SIMD does not load elsewhere
#endif
    };
}

/// The names of those in built_in(), as a constant: the library keeps nothing that changes.
constexpr Isa built_in_isas[] = {
    Isa::scalar,
#ifdef GLINT_HAS_sse4
    Isa::sse4,
#endif
#ifdef GLINT_HAS_avx2
    Isa::avx2,
#endif
#ifdef GLINT_HAS_avx512
    Isa::avx512,
#endif
#ifdef GLINT_HAS_neon
    Isa::neon,
#endif
#ifdef GLINT_HAS_wasm
    Isa::wasm,
#endif
};

} // namespace

std::string_view isa_name(Isa isa) {
    switch (isa) {
    case Isa::scalar:
        return "scalar";
    case Isa::sse4:
        return "sse4";
    case Isa::avx2:
        return "avx2";
    case Isa::avx512:
        return "avx512";
    case Isa::neon:
        return "neon";
    case Isa::wasm:
        return "wasm";
    }
    return "unknown";
}

std::span<const Isa> available_isas() {
    size_t count = 0;
    for (const BuiltIn &kernel : built_in()) count += kernel.runs_here ? 1 : 0;
    return std::span(built_in_isas).first(count);
}

Isa best_isa() {
    return available_isas().back();
}

Result<Isa> find_isa(std::string_view name) {
    std::string there;
    for (const Isa isa : available_isas()) {
        if (isa_name(isa) == name) return isa;
        if (!there.empty()) there += ", ";
        there += isa_name(isa);
    }
    bool known = false;
    for (const Isa isa : every_isa) known = known || isa_name(isa) == name;
    return Error(ErrorCode::bad_input,
                 (known ? "instruction set '" : "unknown instruction set '") + std::string(name) +
                     (known ? "' is not available on this machine; there is: " : "'; there is: ") + there);
}

const Kernel &kernel_for(Isa isa) {
    for (const BuiltIn &kernel : built_in()) {
        if (kernel.isa == isa && kernel.runs_here) return *kernel.kernel;
    }
    return scalar_kernel;
}

} // namespace glint
