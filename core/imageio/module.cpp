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

Result<fs::path> find_module() {
    std::error_code error;
    const fs::path executable = fs::read_symlink("/proc/self/exe", error);
    if (error) return unavailable("the program's own place is unknown: " + error.message(), {});

    const fs::path folder = executable.parent_path();
    const fs::path beside = folder / module_name;
    const fs::path installed = (folder / GLINT_MODULE_FOLDER_FROM_BIN / module_name).lexically_normal();
    for (const fs::path &place : {beside, installed}) {
        if (fs::exists(place, error)) return place;
    }
    return unavailable("there is neither '" + beside.string() + "' nor '" + installed.string() + "'",
                       "install libopenimageio-dev, then configure and build Glint again");
}

template <typename Function> Function *symbol(void *library, const char *name) {
    return reinterpret_cast<Function *>(::dlsym(library, name));
}

} // namespace

Result<Module> load_module() {
    const Result<fs::path> place = find_module();
    if (!place) return place.error();

    void *library = ::dlopen(place->c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!library) {
        const char *reason = ::dlerror();
        return unavailable(reason ? reason : "the module does not load",
                           "install the OpenImageIO library (a package named like libopenimageio2.4)");
    }
    auto *abi = symbol<glint_imageio_abi_fn>(library, GLINT_IMAGEIO_ABI_NAME);
    Module module;
    module.library = symbol<glint_imageio_library_fn>(library, GLINT_IMAGEIO_LIBRARY_NAME);
    module.encode = symbol<glint_imageio_encode_fn>(library, GLINT_IMAGEIO_ENCODE_NAME);
    module.release = symbol<glint_imageio_release_fn>(library, GLINT_IMAGEIO_RELEASE_NAME);
    module.decode = symbol<glint_imageio_decode_fn>(library, GLINT_IMAGEIO_DECODE_NAME);
    if (!abi || abi() != GLINT_IMAGEIO_ABI || !module.library || !module.encode || !module.release || !module.decode) {
        return unavailable("'" + place->string() + "' belongs to another version of Glint", "install both together");
    }
    return module;
}

} // namespace glint::imageio
