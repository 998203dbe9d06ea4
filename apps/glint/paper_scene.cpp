// Finding the scene of the paper, which `glint bench table` measures when no other is named.
#include "paper_scene.hpp"

#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace glint::cli {

Result<fs::path> find_paper_scene() {
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path installed = (folder / GLINT_SCENE_FOLDER_FROM_BIN / "cornell.sdl").lexically_normal();
    const fs::path source = fs::path(GLINT_SCENE_SOURCE_FOLDER) / "cornell.sdl";
    for (const fs::path &place : {installed, source}) {
        if (fs::is_regular_file(place, error)) return place;
    }
    return Error(ErrorCode::not_found,
                 "no scene to measure: neither '" + installed.string() + "' nor '" + source.string() + "' is there",
                 "name one with --scene");
}

} // namespace glint::cli
