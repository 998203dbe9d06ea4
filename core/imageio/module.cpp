// Finding and loading the image module.
#include "imageio/module.hpp"

#include <filesystem>
#include <string>
#include <system_error>

#include <dlfcn.h>

namespace fs = std::filesystem;

namespace glint::imageio {
namespace {

constexpr const char *module_name = "glint_imageio_oiio.so";

Error unavailable(const std::string &why, std::string hint) {
    return {ErrorCode::unsupported, "image files cannot be read or written: " + why, std::move(hint)};
}

/// Where the module lies beside Glint's own programs. Other programs learned its folder when they were linked, as they
/// learn those of libraries: then its bare name is for dlopen() to find.
std::string find_module() {
    std::error_code error;
    const fs::path executable = fs::read_symlink("/proc/self/exe", error);
    if (error) return module_name;

    const fs::path folder = executable.parent_path();
    for (const fs::path &place : {folder / module_name, folder / GLINT_MODULE_FOLDER_FROM_BIN / module_name}) {
        if (fs::exists(place, error)) return place.lexically_normal().string();
    }
    return module_name;
}

template <typename Function> Function *symbol(void *library, const char *name) {
    return reinterpret_cast<Function *>(::dlsym(library, name));
}

} // namespace

Result<Module> load_module() {
    const std::string place = find_module();
    void *library = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!library) {
        const char *said = ::dlerror();
        const std::string reason = said ? said : "the module does not load";
        return unavailable(reason, reason.starts_with(module_name) // it is the module itself that is missing
                                       ? "install glint-imageio; or libopenimageio-dev, and build Glint again"
                                       : "install the OpenImageIO library (a package named like libopenimageio2.4)");
    }
    auto *abi = symbol<glint_imageio_abi_fn>(library, GLINT_IMAGEIO_ABI_NAME);
    Module module;
    module.library = symbol<glint_imageio_library_fn>(library, GLINT_IMAGEIO_LIBRARY_NAME);
    module.encode = symbol<glint_imageio_encode_fn>(library, GLINT_IMAGEIO_ENCODE_NAME);
    module.release = symbol<glint_imageio_release_fn>(library, GLINT_IMAGEIO_RELEASE_NAME);
    module.decode = symbol<glint_imageio_decode_fn>(library, GLINT_IMAGEIO_DECODE_NAME);
    if (!abi || abi() != GLINT_IMAGEIO_ABI || !module.library || !module.encode || !module.release || !module.decode) {
        return unavailable("'" + place + "' belongs to another version of Glint", "install both together");
    }
    return module;
}

} // namespace glint::imageio
