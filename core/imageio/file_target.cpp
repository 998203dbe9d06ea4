// Putting bytes into a file so that the file is never seen half written.
#include "imageio/file_target.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace glint::imageio {
namespace {

// Small enough that cancelling is prompt on a slow disk.
constexpr size_t chunk_bytes = size_t{1} << 20;

Error system_error(const fs::path &file, int error) {
    return {ErrorCode::io,
            "cannot write '" + file.string() + "': " + std::error_code(error, std::generic_category()).message()};
}

Error folder_error(const fs::path &file) {
    return {ErrorCode::io, "cannot write '" + file.string() + "': it is a folder"};
}

/// An open file that is closed at the end of the scope; close() tells what the system says about it.
class OpenFile {
public:
    OpenFile(const fs::path &file, int flags) : descriptor_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {}
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    OpenFile(const OpenFile &) = delete;
    OpenFile &operator=(const OpenFile &) = delete;

    [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// False, with errno set, when bytes written earlier were lost after all (network file systems tell only now).
    [[nodiscard]] bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

private:
    int descriptor_;
};

/// Removes a file at the end of the scope, unless it was given another name.
class TemporaryName {
public:
    explicit TemporaryName(fs::path name) : name_(std::move(name)) {}
    ~TemporaryName() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }
    TemporaryName(const TemporaryName &) = delete;
    TemporaryName &operator=(const TemporaryName &) = delete;

    [[nodiscard]] bool rename_to(const fs::path &target) {
        if (::rename(name_.c_str(), target.c_str()) != 0) return false;
        name_.clear();
        return true;
    }

private:
    fs::path name_;
};

Status write_all(const fs::path &file, int descriptor, std::span<const uint8_t> bytes, const RenderControl *control) {
    while (!bytes.empty()) {
        if (control && control->cancelled()) return Error(ErrorCode::cancelled, "writing was cancelled");
        const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), chunk_bytes));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return system_error(file, errno);
        bytes = bytes.subspan(static_cast<size_t>(written));
    }
    return Done{};
}

Status write_into(const fs::path &file, std::span<const uint8_t> bytes, const RenderControl *control) {
    OpenFile out(file, O_WRONLY);
    if (!out.is_open()) return system_error(file, errno);
    if (Status written = write_all(file, out.descriptor(), bytes, control); !written) return written;
    if (!out.close()) return system_error(file, errno);
    return Done{};
}

/// Where a chain of symbolic links ends, whether or not something is there.
Result<fs::path> follow_links(const fs::path &file) {
    constexpr int longest_chain = 40; // Linux's own limit
    fs::path place = file;
    for (int links = 0; links < longest_chain; ++links) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(place, error))) return place;
        const fs::path next = fs::read_symlink(place, error);
        if (error) return system_error(file, error.value());
        place = place.parent_path() / next; // an absolute `next` replaces the whole path
    }
    return system_error(file, ELOOP);
}

fs::path folder_of(const fs::path &file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// A name that no other thread, process or earlier crash is likely to have used; O_EXCL catches the rest.
fs::path temporary_name(const fs::path &folder, int attempt) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    return folder / (".glint-" + std::to_string(::getpid()) + "-" + std::to_string(now) + "-" +
                     std::to_string(attempt) + ".tmp");
}

Status write_beside_and_rename(const fs::path &file, const fs::path &place, std::span<const uint8_t> bytes,
                               const RenderControl *control, const struct stat *existing) {
    const fs::path folder = folder_of(place);
    for (int attempt = 0;; ++attempt) {
        const fs::path name = temporary_name(folder, attempt);
        OpenFile out(name, O_WRONLY | O_CREAT | O_EXCL);
        if (!out.is_open() && errno == EEXIST && attempt < 100) continue;
        if (!out.is_open()) return system_error(file, errno);
        TemporaryName temporary(name);

        if (existing && ::fchmod(out.descriptor(), existing->st_mode & 07777) != 0) return system_error(file, errno);
        if (Status written = write_all(file, out.descriptor(), bytes, control); !written) return written;
        if (::fsync(out.descriptor()) != 0) return system_error(file, errno);
        if (!out.close()) return system_error(file, errno);
        if (control && control->cancelled()) return Error(ErrorCode::cancelled, "writing was cancelled");
        if (!temporary.rename_to(place)) return system_error(file, errno);
        return Done{};
    }
}

} // namespace

Status check_target(const fs::path &file) {
    struct stat existing {};
    if (::stat(file.c_str(), &existing) == 0) {
        if (S_ISDIR(existing.st_mode)) return folder_error(file);
        if (::access(file.c_str(), W_OK) != 0) return system_error(file, errno);
        if (!S_ISREG(existing.st_mode)) return Done{};
    } else if (errno != ENOENT) {
        return system_error(file, errno);
    }
    const Result<fs::path> place = follow_links(file);
    if (!place) return place.error();
    if (::access(folder_of(*place).c_str(), W_OK | X_OK) != 0) return system_error(file, errno);
    return Done{};
}

Status replace_file(const fs::path &file, std::span<const uint8_t> bytes, const RenderControl *control) {
    struct stat existing {};
    const bool exists = ::stat(file.c_str(), &existing) == 0;
    if (!exists && errno != ENOENT) return system_error(file, errno);
    if (exists && S_ISDIR(existing.st_mode)) return folder_error(file);
    if (exists && !S_ISREG(existing.st_mode)) return write_into(file, bytes, control);
    // Renaming would replace a file that its owner made read-only.
    if (exists && ::access(file.c_str(), W_OK) != 0) return system_error(file, errno);

    const Result<fs::path> place = follow_links(file);
    if (!place) return place.error();
    return write_beside_and_rename(file, *place, bytes, control, exists ? &existing : nullptr);
}

} // namespace glint::imageio
