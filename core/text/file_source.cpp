// Files that do not come from the system.
#include <glint/file_source.hpp>

#include "text/folders.hpp"
#include "text/text_file.hpp"

namespace glint {

namespace {

std::string key_of(std::string_view path) {
    return plain_path(path).generic_string();
}

} // namespace

FileBytes FileBytes::copy_of(std::string_view bytes) {
    FileBytes copy(bytes.size());
    bytes.copy(copy.bytes.get(), bytes.size());
    return copy;
}

FileSource::~FileSource() = default;

bool FileSource::contains(const std::string &path) const {
    const Result<FileBytes> file = read(path, 0);
    return file.ok() || file.error().code != ErrorCode::not_found;
}

MemoryFiles &MemoryFiles::add(std::string_view path, std::string bytes) {
    files_.insert_or_assign(key_of(path), std::move(bytes));
    return *this;
}

Result<FileBytes> MemoryFiles::read(const std::string &path, uint64_t max_bytes) const {
    const auto file = files_.find(key_of(path));
    if (file == files_.end()) return Error(ErrorCode::not_found, "there is no such file");
    if (file->second.size() > max_bytes) return file_too_large(file->second.size(), max_bytes);
    return FileBytes::copy_of(file->second);
}

bool MemoryFiles::contains(const std::string &path) const {
    return files_.contains(key_of(path));
}

} // namespace glint
