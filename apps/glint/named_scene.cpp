// Finding the scenes that come with Glint, by name.
#include "named_scene.hpp"

#include <system_error>

namespace fs = std::filesystem;

namespace glint::cli {

Result<fs::path> find_scene(const std::string &name) {
    std::error_code error;
    const bool bare_word = name.find_first_of("./") == std::string::npos;
    if (!bare_word || (!name.empty() && fs::is_regular_file(name, error))) return fs::path(name);

    const std::string file = (name.empty() ? "cornell" : name) + ".sdl";
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path installed = (folder / GLINT_SCENE_FOLDER_FROM_BIN / file).lexically_normal();
    const fs::path source = fs::path(GLINT_SCENE_SOURCE_FOLDER) / file;
    for (const fs::path &place : {installed, source}) {
        if (fs::is_regular_file(place, error)) return place;
    }
    return Error(ErrorCode::not_found,
                 "no scene to measure: neither '" + installed.string() + "' nor '" + source.string() + "' is there",
                 "name one with --scene");
}

} // namespace glint::cli
