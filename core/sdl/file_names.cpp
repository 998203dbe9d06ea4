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

Result<FileNames> FileNames::in_folder(const fs::path &folder) {
    std::error_code missing;
    fs::path real = fs::canonical(folder.empty() ? fs::path(".") : folder, missing);
    if (missing || !fs::is_directory(real, missing)) {
        return Error(ErrorCode::not_found, words("there is no folder ", in_quotes(folder.string())));
    }
    return FileNames(std::move(real));
}

Result<std::string> FileNames::name_of(const fs::path &file) {
    // The file's own name may be a symbolic link, and stays: what lies beside it, such as materials, is found there.
    const fs::path real = fs::canonical(fs::absolute(file).parent_path()) / file.filename();
    std::string name = real.lexically_relative(folder_).generic_string();
    if (const char *const what = unwritable(name)) {
        return Error(ErrorCode::bad_input,
                     words("from the new file's folder, the mesh is ", in_quotes(name), ", which has ", what),
                     "names in a scene file are single words; move or link the mesh, or choose another folder");
    }
    float number = 0.0f;
    if (!read_number(name, number)) name = "./" + name; // lest it be taken for a coefficient
    reach(real);
    reach(fs::canonical(real));
    return name;
}

void FileNames::keep(const std::string &name) {
    reach((folder_ / name).lexically_normal());
    reach(fs::weakly_canonical(folder_ / name));
}

void FileNames::reach(const fs::path &file) {
    root_ = common_folder(root_, file);
}

std::optional<fs::path> FileNames::scene_root() const {
    return root_ == folder_ ? std::nullopt : std::optional(root_);
}

} // namespace glint
