// Finding and reading a file that another file names, with the problems at the place where it is named.
#include "text/asset_file.hpp"

#include <string>
#include <system_error>
#include <utility>

#include "text/words.hpp"

namespace glint {

namespace fs = std::filesystem;

std::optional<fs::path> find_asset(const AssetPaths &paths, std::string_view name, const Place &place,
                                   Problems &problems) {
    Result<fs::path> found = paths.find(name);
    if (found.ok()) return std::move(found).value();
    for (const Diagnostic &diagnostic : found.error().diagnostics) {
        problems.error(place, diagnostic.message, diagnostic.hint, found.error().code);
    }
    return std::nullopt;
}

std::optional<TextFile> read_asset(const Files &files, const fs::path &file, std::string_view kind, uint64_t max_bytes,
                                   const Place &place, Problems &problems) {
    Result<TextFile> text = files.read(file, max_bytes);
    if (text.ok()) return std::move(text).value();
    for (const Diagnostic &diagnostic : text.error().diagnostics) {
        problems.error(place, words(kind, ' ', path_in_quotes(file.string()), ": ", diagnostic.message),
                       diagnostic.hint, text.error().code);
    }
    return std::nullopt;
}

fs::path real_path(const Files &files, const fs::path &file) {
    std::error_code unknown;
    fs::path real = files.real(file, unknown);
    return unknown ? file : real;
}

} // namespace glint
