// A shared library that is looked up when it is first needed, so that a program starts without it.
#pragma once

#include <span>
#include <string>

#include <glint/result.hpp>

namespace glint::gles {

/// What to look for, and what to tell a person when it is not there.
struct LibraryNames {
    std::span<const char *const> file_names; ///< tried in order
    const char *install_hint;                ///< "install the package ..."
};

/// An open library. It stays mapped until the process ends: graphics drivers leave threads and thread-local data
/// behind that must not lose their code, so its functions may be called after the DynamicLibrary is gone.
class DynamicLibrary {
public:
    /// Fails with `unsupported`, saying what was tried and what to install.
    [[nodiscard]] static Result<DynamicLibrary> open(const LibraryNames &names);

    /// Sets `function` to the symbol of that name. Fails with `unsupported` when the library does not have it.
    template <typename Function> Status find(Function *&function, const char *symbol_name) const {
        void *address = find_address(symbol_name);
        if (address == nullptr) return missing(symbol_name);
        function = reinterpret_cast<Function *>(address);
        return Done{};
    }

private:
    DynamicLibrary(void *handle, std::string file_name) : handle_(handle), file_name_(std::move(file_name)) {}
    [[nodiscard]] void *find_address(const char *symbol_name) const;
    [[nodiscard]] Error missing(const char *symbol_name) const;

    void *handle_;
    std::string file_name_;
};

} // namespace glint::gles
