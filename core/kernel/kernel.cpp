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

/// Kernels that this machine can run, slowest first.
class AvailableKernels {
public:
    AvailableKernels() { add(scalar_kernel, true); }

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
    return Error(ErrorCode::bad_input, (known ? "instruction set '" : "unknown instruction set '") + std::string(name) +
                                           (known ? "' is not available on this machine; there is: " : "'; there is: ") +
                                           there);
}

const Kernel &kernel_for(Isa isa) {
    return available().kernel(isa);
}

} // namespace glint
