// Which folders hold which files, by their names alone.
#include "text/folders.hpp"

#include <algorithm>

namespace glint {

namespace fs = std::filesystem;

bool is_within(const fs::path &path, const fs::path &folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

fs::path common_folder(const fs::path &a, const fs::path &b) {
    const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
    fs::path common;
    for (auto part = a.begin(); part != end; ++part) common /= *part;
    return common;
}

} // namespace glint
