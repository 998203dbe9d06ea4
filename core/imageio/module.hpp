// Finding and loading the image module.
#pragma once

#include "imageio/module_abi.h"

#include <glint/result.hpp>

namespace glint::imageio {

/// The module's functions; valid until the process ends.
struct Module {
    glint_imageio_library_fn *library = nullptr;
    glint_imageio_encode_fn *encode = nullptr;
    glint_imageio_release_fn *release = nullptr;
    glint_imageio_decode_fn *decode = nullptr;
};

/// Loads the module, or finds it loaded. It is never unloaded: the library behind it keeps threads of its own.
/// Looked for beside the executable, then where `make install` puts it relative to the executable.
/// Fails with unsupported, saying what to install.
[[nodiscard]] Result<Module> load_module();

} // namespace glint::imageio
