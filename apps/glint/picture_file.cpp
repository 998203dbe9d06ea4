// Where the render command writes when the user does not say.
#include "picture_file.hpp"

#include <algorithm>
#include <system_error>

namespace fs = std::filesystem;

namespace glint::cli {
namespace {

/// Absolute, without dots and links, as far as it exists.
fs::path real_path(const fs::path &path) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? fs::absolute(path).lexically_normal() : real;
}

bool is_inside(const fs::path &path, const fs::path &folder) {
    const fs::path inner = real_path(path), outer = real_path(folder);
    return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

} // namespace

Result<fs::path> default_picture_file(const SceneOptions &options, const SceneFile &scene) {
    const fs::path scene_file = options.file;
    if (!scene.output_file) return scene_file.stem().concat(".png");

    fs::path folder = scene_file.parent_path();
    if (folder.empty()) folder = ".";
    const fs::path root = options.scene_root.empty() ? folder : fs::path(options.scene_root);
    const fs::path wanted = folder / *scene.output_file; // an absolute output replaces the folder
    if (!options.allow_outside_root && !is_inside(wanted, root)) {
        return Error(ErrorCode::bad_input,
                     "the scene's output '" + *scene.output_file + "' is outside the scene root '" + root.string() +
                         "'",
                     "choose a file with -o, or pass --allow-outside-root");
    }
    return wanted;
}

} // namespace glint::cli
