// Which folders hold which files, by their names alone.
#include "text/folders.hpp"

#include <algorithm>

namespace glint {

namespace fs = std::filesystem;

fs::path plain_path(const fs::path &path) {
    fs::path plain = path.lexically_normal();
    if (!plain.has_filename()) plain = plain.parent_path();
    return plain == "." ? fs::path() : plain;
}

bool is_within(const fs::path &path, const fs::path &folder) {
    if (path.is_absolute() != folder.is_absolute()) return false;
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end() && (rest == path.end() || *rest != "..");
}

fs::path common_folder(const fs::path &a, const fs::path &b) {
    const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
    fs::path common;
    for (auto part = a.begin(); part != end; ++part) common /= *part;
    return common;
}

} // namespace glint
