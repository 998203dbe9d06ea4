// Facts about this build.
#include <glint/version.hpp>

#include <glm/detail/setup.hpp>

#include <glint/isa.hpp>

#include "kernel/highway_version.hpp"

#define GLINT_TEXT_OF(x) #x
#define GLINT_TEXT(x) GLINT_TEXT_OF(x)

namespace glint {

BuildInfo build_info() {
    BuildInfo info;
    info.version =
        GLINT_TEXT(GLINT_VERSION_MAJOR) "." GLINT_TEXT(GLINT_VERSION_MINOR) "." GLINT_TEXT(GLINT_VERSION_PATCH);
#if defined(__clang__)
    info.compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
    info.compiler = "gcc " __VERSION__;
#else
    info.compiler = "unknown";
#endif
    info.glm_version = GLINT_TEXT(GLM_VERSION_MAJOR) "." GLINT_TEXT(GLM_VERSION_MINOR) "." GLINT_TEXT(
        GLM_VERSION_PATCH) "." GLINT_TEXT(GLM_VERSION_REVISION);
    info.highway_version = highway_version();
    for (const Isa isa : available_isas()) info.isas.push_back(isa_name(isa));
    info.isa = isa_name(best_isa());
    return info;
}

} // namespace glint
