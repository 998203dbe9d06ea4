// Loading libOSMesa.
#include "osmesa/library.hpp"

#include <array>

namespace glint::osmesa {

gles::LibraryNames OsMesa::default_names() {
    static constexpr std::array<const char *, 3> file_names = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    return {file_names, "install the package libosmesa6 (Debian 12, Ubuntu 24.04; Mesa 25.1 and later have none), or "
                        "choose the EGL surface"};
}

Result<OsMesa> OsMesa::load(const gles::LibraryNames &names) {
    Result<gles::DynamicLibrary> library = gles::DynamicLibrary::open(names);
    if (!library) return std::move(library).error();
    OsMesa mesa;
    Status status = Done{};
    const auto find = [&](auto &function, const char *name) {
        if (status) status = library->find(function, name);
    };
    find(mesa.create_context_attribs, "OSMesaCreateContextAttribs");
    find(mesa.destroy_context, "OSMesaDestroyContext");
    find(mesa.make_current, "OSMesaMakeCurrent");
    find(mesa.get_current_context, "OSMesaGetCurrentContext");
    find(mesa.get_proc_address, "OSMesaGetProcAddress");
    if (!status) return std::move(status).error();
    return mesa;
}

} // namespace glint::osmesa
