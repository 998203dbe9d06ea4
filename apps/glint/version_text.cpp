// What `glint --version` prints: everything a bug report should say about the build.
#include "command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glint/imageio.hpp>
#include <glint/version.hpp>

namespace glint::cli {
namespace {

std::string image_library() {
    const Result<std::string> version = image_library_version();
    if (!version) return "OpenImageIO not available: " + version.error().diagnostics.front().message;
    return *version;
}

} // namespace

std::string version_text() {
    const BuildInfo build = build_info();
    return fmt::format("glint {}\n"
                       "compiler          {}\n"
                       "instruction sets  {} (in use: {})\n"
                       "libraries         GLM {}, Highway {}, {}",
                       build.version, build.compiler, fmt::join(build.isas, ", "), build.isa, build.glm_version,
                       build.highway_version, image_library());
}

} // namespace glint::cli
