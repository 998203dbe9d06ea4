// Reading a whole text file without trusting what its name leads to.
#include "text/text_file.hpp"

#include <cerrno>
#include <limits>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "text/words.hpp"

namespace glint {

namespace {

/// Closes what open() gave.
class FileDescriptor {
public:
    explicit FileDescriptor(int fd) : fd_(fd) {}
    ~FileDescriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    FileDescriptor(const FileDescriptor &) = delete;
    FileDescriptor &operator=(const FileDescriptor &) = delete;
    [[nodiscard]] int get() const { return fd_; }

private:
    int fd_;
};

Error system_error(int number) {
    switch (number) {
    case ENOENT:
    case ENOTDIR:
        return {ErrorCode::not_found, "there is no such file"};
    case EACCES:
    case EPERM:
        return {ErrorCode::not_found, "the file may not be read: permission denied"};
    case ENAMETOOLONG:
        return {ErrorCode::not_found, "there is no such file: its name is too long"};
    case ELOOP:
        return {ErrorCode::not_found, "there is no such file: its symbolic links go round in a circle"};
    default:
        return {ErrorCode::io, words("the file cannot be read: ", std::generic_category().message(number))};
    }
}

/// Why something of this kind is not read, or nothing for a regular file.
const char *kind_problem(const struct stat &status) {
    if (S_ISREG(status.st_mode)) return nullptr;
    if (S_ISDIR(status.st_mode)) return "this is a folder, expected a file";
    if (S_ISFIFO(status.st_mode)) return "this is a pipe, expected a file";
    if (S_ISSOCK(status.st_mode)) return "this is a socket, expected a file";
    return "this is a device, expected a file";
}

} // namespace

Error file_too_large(uint64_t size_bytes, uint64_t max_bytes) {
    return {ErrorCode::limit_exceeded, words("the file has ", size_bytes, " bytes, the limit is ", max_bytes)};
}

Result<TextFile> read_text_file(const std::filesystem::path &path, uint64_t max_bytes) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return system_error(errno);
    if (const char *problem = kind_problem(status)) return Error(ErrorCode::not_found, problem);

    // Someone may put a pipe there just now: do not wait for it, and look again at what was really opened.
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file.get() < 0) return system_error(errno);
    if (::fstat(file.get(), &status) != 0) return system_error(errno);
    if (const char *problem = kind_problem(status)) return Error(ErrorCode::not_found, problem);

    const auto size = static_cast<uint64_t>(status.st_size);
    if (size > max_bytes) return file_too_large(size, max_bytes);
    TextFile text;
    // One byte more is asked for than stat promised: a file that has grown since gives it, and is refused.
    if (size < std::numeric_limits<size_t>::max()) text.bytes.reset(new (std::nothrow) char[size_t(size) + 1]);
    if (!text.bytes) {
        return Error(ErrorCode::out_of_memory, words("there is no memory for the file's ", size, " bytes"));
    }
    while (text.size <= size) {
        const ssize_t got = ::read(file.get(), text.bytes.get() + text.size, size_t(size) + 1 - text.size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return system_error(errno);
        if (got == 0) return text;
        text.size += static_cast<size_t>(got);
    }
    return Error(ErrorCode::io, "the file grew while it was read");
}

} // namespace glint
