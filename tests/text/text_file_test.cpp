// Reading a whole text file without trusting what its name leads to.
#include "text/text_file.hpp"

#include <string>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

class TextFiles : public WrittenFiles {
protected:
    void expect_failure(const std::filesystem::path &path, ErrorCode code, const std::string &message,
                        uint64_t max_bytes = 1000) {
        const auto text = read_text_file(path, max_bytes);
        ASSERT_FALSE(text.ok()) << path;
        EXPECT_EQ(text.error().code, code);
        EXPECT_EQ(text.error().text(), "error: " + message);
    }
};

TEST_F(TextFiles, are_read_whole) {
    EXPECT_EQ(read_text_file(write("a", "one\r\ntwo"), 8)->view(), "one\r\ntwo");
    EXPECT_EQ(read_text_file(write("empty", ""), 8)->view(), "");
    const std::string large(1'000'000, 'x');
    EXPECT_EQ(read_text_file(write("large", large), 1'000'000)->view(), large);
}

TEST_F(TextFiles, that_are_missing_are_told_so) {
    expect_failure(in_folder("missing"), ErrorCode::not_found, "there is no such file");
    expect_failure(write("a", "") / "below", ErrorCode::not_found, "there is no such file");
    expect_failure("", ErrorCode::not_found, "there is no such file");
    expect_failure(in_folder(std::string(5000, 'x')), ErrorCode::not_found,
                   "there is no such file: its name is too long");
    std::filesystem::create_symlink("loop", in_folder("loop"));
    expect_failure(in_folder("loop"), ErrorCode::not_found,
                   "there is no such file: its symbolic links go round in a circle");
}

TEST_F(TextFiles, that_are_no_files_are_not_opened) {
    expect_failure(in_folder(""), ErrorCode::not_found, "this is a folder, expected a file");
    expect_failure("/dev/zero", ErrorCode::not_found, "this is a device, expected a file");
    expect_failure("/dev/null", ErrorCode::not_found, "this is a device, expected a file");
    ASSERT_EQ(::mkfifo(in_folder("pipe").c_str(), 0600), 0);
    expect_failure(in_folder("pipe"), ErrorCode::not_found, "this is a pipe, expected a file"); // and comes back
    const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    in_folder("socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(fd, reinterpret_cast<const sockaddr *>(&address), sizeof address), 0);
    expect_failure(in_folder("socket"), ErrorCode::not_found, "this is a socket, expected a file");
    ::close(fd);
}

TEST_F(TextFiles, larger_than_the_limit_are_refused_unread) {
    expect_failure(write("a", "123456789"), ErrorCode::limit_exceeded, "the file has 9 bytes, the limit is 8", 8);
    std::filesystem::resize_file(write("sparse", ""), uint64_t{1} << 40);
    expect_failure(in_folder("sparse"), ErrorCode::limit_exceeded,
                   "the file has 1099511627776 bytes, the limit is 4294967296", uint64_t{4} << 30);
}

TEST_F(TextFiles, without_permission_are_refused) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
    std::filesystem::permissions(write("secret", "x"), std::filesystem::perms::none);
    expect_failure(in_folder("secret"), ErrorCode::not_found, "the file may not be read: permission denied");
}

} // namespace
} // namespace glint::test
