// Whether a file lies inside a folder, whatever links and dots are on the way.
#include "inside.hpp"

#include <algorithm>
#include <system_error>

namespace fs = std::filesystem;

namespace glint::cli {

fs::path real_path(const fs::path &path) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? fs::absolute(path).lexically_normal() : real;
}

bool is_inside(const fs::path &path, const fs::path &folder) {
    const fs::path inner = real_path(path), outer = real_path(folder);
    return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

} // namespace glint::cli
