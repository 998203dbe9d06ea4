// How a scene file calls the files it names.
#include "sdl/file_names.hpp"

#include <string_view>
#include <system_error>

#include "text/folders.hpp"
#include "text/number.hpp"
#include "text/words.hpp"

namespace glint {

namespace fs = std::filesystem;

namespace {

/// What of a name an SDL file cannot say, or nothing.
const char *unwritable(std::string_view name) {
    for (size_t at = 0; at < name.size();) {
        const char c = name[at];
        if (c == ' ' || c == '\t') return "a blank";
        if (c == '\n' || c == '\r') return "a line break";
        if (c == '#') return "a '#', which starts a comment";
        const size_t length = utf8_length(name.substr(at));
        if (length == 0) return "a byte that is not UTF-8";
        at += length;
    }
    return nullptr;
}

} // namespace

Result<FileNames> FileNames::in_folder(const Files &files, const fs::path &folder) {
    std::error_code missing;
    fs::path real = files.real(folder.empty() ? fs::path(".") : folder, missing);
    if (missing || !files.is_folder(real)) {
        return Error(ErrorCode::not_found, words("there is no folder ", in_quotes(folder.string())));
    }
    return FileNames(files, std::move(real));
}

Result<std::string> FileNames::name_of(const fs::path &file) {
    // The file's own name may be a symbolic link, and stays: what lies beside it, such as materials, is found there.
    const fs::path folder = file.parent_path();
    const fs::path real = real_path(folder.empty() ? fs::path(".") : folder) / file.filename();
    std::string name = real.lexically_relative(folder_).generic_string();
    if (const char *const what = unwritable(name)) {
        return Error(ErrorCode::bad_input,
                     words("from the new file's folder, the mesh is ", in_quotes(name), ", which has ", what),
                     "names in a scene file are single words; move or link the mesh, or choose another folder");
    }
    float number = 0.0f;
    if (!read_number(name, number)) name = "./" + name; // lest it be taken for a coefficient
    reach(real);
    reach(real_path(real));
    return name;
}

fs::path FileNames::real_path(const fs::path &path) const {
    std::error_code problem;
    fs::path real = files_.real(path, problem);
    if (problem) throw fs::filesystem_error("a mesh is gone", path, problem);
    return real;
}

void FileNames::keep(const std::string &name) {
    reach(plain_path(folder_ / name));
    std::error_code unknown;
    const fs::path real = files_.nearly_real(folder_ / name, unknown);
    if (!unknown) reach(real);
}

void FileNames::reach(const fs::path &file) {
    root_ = common_folder(root_, file);
}

std::optional<fs::path> FileNames::scene_root() const {
    return root_ == folder_ ? std::nullopt : std::optional(root_);
}

} // namespace glint
