// The place that readers' files lie in.
#include "text/files.hpp"

#include "text/folders.hpp"
#include "text/words.hpp"

namespace glint {

namespace fs = std::filesystem;

fs::path Files::real(const fs::path &path, std::error_code &problem) const {
    return source_ ? plain_path(path) : fs::canonical(path, problem);
}

fs::path Files::nearly_real(const fs::path &path, std::error_code &problem) const {
    return source_ ? plain_path(path) : fs::weakly_canonical(path, problem);
}

bool Files::is_folder(const fs::path &path) const {
    std::error_code unknown;
    return source_ || fs::is_directory(path, unknown);
}

bool Files::is_file(const fs::path &path) const {
    std::error_code unknown;
    return source_ ? may_exist(path) : fs::is_regular_file(path, unknown);
}

bool Files::may_exist(const fs::path &path) const {
    if (source_) return source_->contains(plain_path(path).generic_string());
    std::error_code unknown;
    return fs::status(path, unknown).type() != fs::file_type::not_found;
}

Result<TextFile> Files::read(const fs::path &path, uint64_t max_bytes) const {
    if (!source_) return read_text_file(path, max_bytes);
    Result<FileBytes> bytes = source_->read(plain_path(path).generic_string(), max_bytes);
    if (bytes.ok() && bytes->size > max_bytes) return file_too_large(bytes->size, max_bytes);
    return bytes;
}

} // namespace glint
