// Which kernels were built in, and which of them this machine can run.
#include "kernel/kernel.hpp"

#include <array>
#include <string>

namespace glint {

namespace {

struct NamedIsa {
    Isa isa;
    std::string_view name;
};

constexpr std::array names = {NamedIsa{Isa::scalar, "scalar"}, NamedIsa{Isa::sse4, "sse4"},
                              NamedIsa{Isa::avx2, "avx2"},     NamedIsa{Isa::avx512, "avx512"},
                              NamedIsa{Isa::neon, "neon"},     NamedIsa{Isa::wasm, "wasm"}};

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

/// Kernels that this machine can run, slowest first.
class AvailableKernels {
public:
    AvailableKernels() {
        add(scalar_kernel, true);
#ifdef GLINT_HAS_sse4
        add(sse4_kernel, cpu_has_sse4());
#endif
#ifdef GLINT_HAS_avx2
        add(avx2_kernel, cpu_has_avx2());
#endif
#ifdef GLINT_HAS_avx512
        add(avx512_kernel, cpu_has_avx512());
#endif
#ifdef GLINT_HAS_neon
        add(neon_kernel, true); // part of every AArch64
#endif
#ifdef GLINT_HAS_wasm
        add(wasm_kernel, true); // a module with SIMD does not load elsewhere
#endif
    }

    [[nodiscard]] std::span<const Isa> isas() const { return {isas_.data(), count_}; }
    [[nodiscard]] const Kernel &kernel(Isa isa) const {
        for (size_t i = 0; i < count_; ++i) {
            if (isas_[i] == isa) return *kernels_[i];
        }
        return scalar_kernel;
    }

private:
    void add(const Kernel &kernel, bool runs_here) {
        if (!runs_here) return;
        kernels_[count_] = &kernel;
        isas_[count_++] = kernel.isa;
    }

    size_t count_ = 0;
    std::array<const Kernel *, names.size()> kernels_{};
    std::array<Isa, names.size()> isas_{};
};

const AvailableKernels &available() {
    static const AvailableKernels kernels;
    return kernels;
}

} // namespace

std::string_view isa_name(Isa isa) {
    for (const NamedIsa &named : names) {
        if (named.isa == isa) return named.name;
    }
    return "unknown";
}

std::span<const Isa> available_isas() {
    return available().isas();
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
    for (const NamedIsa &named : names) known = known || named.name == name;
    return Error(ErrorCode::bad_input,
                 (known ? "instruction set '" : "unknown instruction set '") + std::string(name) +
                     (known ? "' is not available on this machine; there is: " : "'; there is: ") + there);
}

const Kernel &kernel_for(Isa isa) {
    return available().kernel(isa);
}

} // namespace glint
