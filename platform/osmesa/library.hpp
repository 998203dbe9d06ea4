// libOSMesa, looked up at run time. Its few function types are written down here, so that building needs no OSMesa.
#pragma once

#include <glint/result.hpp>

#include "gles/dynamic_library.hpp"

namespace glint::osmesa {

/// The functions and constants of <GL/osmesa.h> that this room uses. Plain data; usable while the process runs.
struct OsMesa {
    struct ContextData;
    using Context = ContextData *;
    using Proc = void (*)();

    /// Fails with `unsupported`, naming the package, when there is no such library or it is not libOSMesa.
    [[nodiscard]] static Result<OsMesa> load(const gles::LibraryNames &names = default_names());
    [[nodiscard]] static gles::LibraryNames default_names();

    // Attributes of a context, in pairs with their values, ended by 0.
    static constexpr int format = 0x22;
    static constexpr int depth_bits = 0x30;
    static constexpr int stencil_bits = 0x31;
    static constexpr int profile = 0x33;
    static constexpr int core_profile = 0x34;
    static constexpr int context_major_version = 0x36;
    static constexpr int context_minor_version = 0x37;

    Context (*create_context_attribs)(const int *attributes, Context shared) = nullptr;
    void (*destroy_context)(Context context) = nullptr;
    unsigned char (*make_current)(Context context, void *buffer, unsigned type, int width, int height) = nullptr;
    Context (*get_current_context)() = nullptr;
    Proc (*get_proc_address)(const char *name) = nullptr;
};

} // namespace glint::osmesa
