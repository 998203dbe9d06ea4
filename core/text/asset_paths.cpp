// Where the files that a scene names are looked for, and where they may not be.
#include "text/asset_paths.hpp"

#include <system_error>
#include <utility>

#include "text/folders.hpp"
#include "text/words.hpp"

namespace glint {

namespace fs = std::filesystem;

namespace {

fs::path or_here(fs::path folder) {
    return folder.empty() ? fs::path(".") : folder;
}

} // namespace

Result<AssetPaths> AssetPaths::create(const fs::path &scene_file, const ReadOptions &options) {
    AssetPaths paths{Files(options.files.get())};
    const Files &files = paths.files_;
    paths.allow_outside_root_ = options.allow_outside_root;
    const fs::path shown = scene_file.parent_path();
    const fs::path root = options.scene_root.empty() ? or_here(shown) : options.scene_root;
    std::error_code no_root, no_folder;
    paths.root_ = files.real(root, no_root);
    fs::path folder = files.real(or_here(shown), no_folder);
    if (no_root || !files.is_folder(paths.root_)) {
        return Error(ErrorCode::not_found, words("the scene root ", path_in_quotes(root.string()), " is not a folder"));
    }
    if (no_folder) {
        return Error(ErrorCode::not_found,
                     words("the folder ", path_in_quotes(shown.string()), " cannot be entered: ", no_folder.message()));
    }
    if (!is_within(folder, paths.root_) && !options.allow_outside_root) {
        return Error(ErrorCode::bad_input,
                     words("the scene file is not inside the scene root ", path_in_quotes(root.string())));
    }
    paths.look_from(shown, std::move(folder));
    return paths;
}

void AssetPaths::look_from(const fs::path &shown, fs::path real) {
    folders_.push_back({shown, real});
    if (!is_within(real, root_)) return;
    while (real != root_) {
        real = real.parent_path();
        folders_.push_back({real, real});
    }
}

AssetPaths AssetPaths::beside(const fs::path &file, std::string_view kind) const {
    AssetPaths paths(files_);
    paths.root_ = root_;
    paths.allow_outside_root_ = allow_outside_root_;
    paths.kind_ = kind;
    std::error_code unknown;
    const fs::path shown = file.parent_path();
    fs::path real = files_.real(or_here(shown), unknown);
    paths.look_from(shown, unknown ? shown : std::move(real));
    return paths;
}

bool AssetPaths::holds(const fs::path &real) const {
    return is_within(real, root_);
}

std::string AssetPaths::outside_message(std::string_view name) const {
    return words("the path ", path_in_quotes(name), " leaves the scene root ", path_in_quotes(or_here(root_).string()));
}

Result<fs::path> AssetPaths::find(std::string_view name) const {
    const fs::path relative(name); // which replaces the folder in "folder / relative" when it is absolute
    std::string tried;
    for (const Folder &folder : folders_) {
        const fs::path candidate = folder.shown / relative;
        if (!allow_outside_root_) {
            const bool written_inside = holds(plain_path(folder.real / relative));
            std::error_code unknown;
            const fs::path real = files_.nearly_real(folder.real / relative, unknown);
            const bool really_inside = unknown ? written_inside : holds(real);
            if (written_inside && !really_inside) {
                return Error(ErrorCode::bad_input, outside_message(name) + " through a symbolic link");
            }
            if (!really_inside) continue;
        }
        if (files_.may_exist(candidate)) return candidate;
        if (!tried.empty()) tried += ", ";
        tried += candidate.lexically_normal().string();
        if (relative.is_absolute()) break;
    }
    if (tried.empty()) {
        return Error(ErrorCode::bad_input, outside_message(name),
                     words("files are named relative to the ", kind_) + wider_root_hint(relative));
    }
    std::string hint = "looked for " + tried;
    if (name.find('\\') != std::string_view::npos) hint += "; folders are separated by '/'";
    hint += wider_root_hint(relative);
    return Error(ErrorCode::not_found, words("there is no file ", path_in_quotes(name)), std::move(hint));
}

/// "; --scene-root DIR would find X", where a folder above the scene has the file and the root keeps it from being
/// found; else nothing.
std::string AssetPaths::wider_root_hint(const fs::path &relative) const {
    if (relative.is_absolute() || allow_outside_root_ || !files_.are_of_system()) return {};
    for (fs::path folder = folders_.front().real;; folder = folder.parent_path()) {
        const fs::path candidate = folder / relative;
        if (files_.is_file(candidate)) {
            std::error_code unknown;
            // The root must hold the folder that was looked in, the name as written and what it leads to.
            fs::path root = common_folder(common_folder(root_, folder), candidate.lexically_normal());
            root = common_folder(root, files_.nearly_real(candidate, unknown));
            return words("; --scene-root ", root.string(), " would find ", candidate.lexically_normal().string());
        }
        if (folder == folder.root_path()) return {};
    }
}

std::optional<std::string> AssetPaths::output_problem(std::string_view name) const {
    if (allow_outside_root_) return std::nullopt;
    std::error_code unknown;
    const fs::path real = files_.nearly_real(folders_.front().real / fs::path(name), unknown);
    if (!unknown && holds(real)) return std::nullopt;
    return outside_message(name);
}

} // namespace glint
