// Opening shared libraries with dlopen.
#include "gles/dynamic_library.hpp"

#include <dlfcn.h>

namespace glint::gles {

Result<DynamicLibrary> DynamicLibrary::open(const LibraryNames &names) {
    std::string attempts;
    for (const char *file_name : names.file_names) {
        if (void *handle = dlopen(file_name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
            return DynamicLibrary(handle, file_name);
        }
        const char *reason = dlerror();
        attempts += (attempts.empty() ? "" : "; ") + std::string(reason != nullptr ? reason : file_name);
    }
    return Error(ErrorCode::unsupported, "cannot load a library: " + attempts, names.install_hint);
}

void *DynamicLibrary::find_address(const char *symbol_name) const {
    return dlsym(handle_, symbol_name);
}

Error DynamicLibrary::missing(const char *symbol_name) const {
    return Error(ErrorCode::unsupported, file_name_ + " has no function " + symbol_name);
}

} // namespace glint::gles
