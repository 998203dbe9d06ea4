// Which Glint this is, for C.
#include <glint/version.h>

#include <glint/isa.hpp>
#include <glint/version.hpp>

#include "c/sized.hpp"

glint_error glint_get_version(glint_version *version) {
    try {
        const glint::BuildInfo info = glint::build_info();
        // Literals all of them, which end with 0.
        return glint::give(version, glint_version{sizeof(glint_version), info.version.data(), info.compiler.data(),
                                                  info.isa.data(), GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR,
                                                  GLINT_VERSION_PATCH, 0});
    } catch (...) {
        return GLINT_ERROR_OUT_OF_MEMORY;
    }
}
