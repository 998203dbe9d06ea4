// Files are replaced whole or not at all.
#include "imageio/file_target.hpp"

#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "imageio/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace glint {
namespace {

using ImageFileTarget = test::TemporaryFolder;

std::vector<uint8_t> bytes_of(const std::string &text) {
    return {text.begin(), text.end()};
}

std::string content(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void put(const fs::path &file, const std::string &text) {
    std::ofstream(file, std::ios::binary) << text;
}

Status replace(const fs::path &file, const std::string &text, const RenderControl *control = nullptr) {
    return imageio::replace_file(file, bytes_of(text), control);
}

TEST_F(ImageFileTarget, a_new_file_holds_the_bytes_and_stands_alone) {
    ASSERT_TRUE(replace(in_folder("new"), "picture").ok());
    EXPECT_EQ(content(in_folder("new")), "picture");
    EXPECT_EQ(listing(), std::vector<std::string>{"new"});
}

TEST_F(ImageFileTarget, a_file_that_existed_is_replaced_and_keeps_its_permissions) {
    put(in_folder("old"), "a much longer content than the new one");
    ASSERT_EQ(::chmod(in_folder("old").c_str(), 0640), 0);
    ASSERT_TRUE(replace(in_folder("old"), "new").ok());
    EXPECT_EQ(content(in_folder("old")), "new");
    EXPECT_EQ(fs::status(in_folder("old")).permissions(), fs::perms(0640));
    EXPECT_EQ(listing().size(), 1u);
}

TEST_F(ImageFileTarget, whoever_holds_the_old_file_open_still_reads_it) {
    put(in_folder("file"), "old");
    std::ifstream reader(in_folder("file"));
    ASSERT_TRUE(replace(in_folder("file"), "new").ok());
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST_F(ImageFileTarget, a_symbolic_link_stays_one_and_its_target_gets_the_bytes) {
    put(in_folder("target"), "old");
    fs::create_symlink("target", in_folder("link"));
    ASSERT_TRUE(replace(in_folder("link"), "new").ok());
    EXPECT_TRUE(fs::is_symlink(in_folder("link")));
    EXPECT_EQ(content(in_folder("target")), "new");
}

TEST_F(ImageFileTarget, a_dangling_link_makes_the_file_it_points_at) {
    fs::create_directory(in_folder("other"));
    fs::create_symlink("other/target", in_folder("link"));
    ASSERT_TRUE(replace(in_folder("link"), "new").ok());
    EXPECT_EQ(content(in_folder("other") / "target"), "new");
    EXPECT_TRUE(fs::is_symlink(in_folder("link")));
}

TEST_F(ImageFileTarget, links_in_a_circle_are_an_error) {
    fs::create_symlink("b", in_folder("a"));
    fs::create_symlink("a", in_folder("b"));
    const Status written = replace(in_folder("a"), "new");
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::io);
}

TEST_F(ImageFileTarget, a_fifo_gets_the_bytes_and_stays_a_fifo) {
    const fs::path fifo = in_folder("fifo");
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = content(fifo); });
    const Status written = replace(fifo, "picture");
    reader.join();
    ASSERT_TRUE(written.ok()) << written.error().text();
    EXPECT_EQ(received, "picture");
    EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST_F(ImageFileTarget, a_full_device_reports_the_systems_own_words) {
    if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    const Status written = replace("/dev/full", "picture");
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::io);
    EXPECT_NE(written.error().text().find("No space left on device"), std::string::npos) << written.error().text();
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(ImageFileTarget, cancelling_leaves_the_old_file_and_no_temporary_one) {
    put(in_folder("file"), "old");
    RenderControl control;
    control.cancel();
    const Status written = replace(in_folder("file"), "new", &control);
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::cancelled);
    EXPECT_EQ(content(in_folder("file")), "old");
    EXPECT_EQ(listing(), std::vector<std::string>{"file"});
}

TEST_F(ImageFileTarget, a_folder_cannot_be_replaced) {
    fs::create_directory(in_folder("folder.png"));
    for (const Status &status :
         {imageio::check_target(in_folder("folder.png")), replace(in_folder("folder.png"), "x")}) {
        ASSERT_FALSE(status.ok());
        EXPECT_NE(status.error().text().find("is a folder"), std::string::npos) << status.error().text();
    }
}

TEST_F(ImageFileTarget, a_missing_folder_is_reported_before_and_at_writing) {
    const fs::path file = in_folder("missing") / "picture.png";
    for (const Status &status : {imageio::check_target(file), replace(file, "x")}) {
        ASSERT_FALSE(status.ok());
        EXPECT_EQ(status.error().code, ErrorCode::io);
        EXPECT_NE(status.error().text().find("No such file or directory"), std::string::npos) << status.error().text();
    }
}

TEST_F(ImageFileTarget, a_read_only_file_is_left_alone) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
    put(in_folder("file"), "old");
    ASSERT_EQ(::chmod(in_folder("file").c_str(), 0400), 0);
    EXPECT_FALSE(imageio::check_target(in_folder("file")).ok());
    EXPECT_FALSE(replace(in_folder("file"), "new").ok());
    EXPECT_EQ(content(in_folder("file")), "old");
}

TEST_F(ImageFileTarget, a_place_that_can_be_written_passes_the_check_and_nothing_appears_there) {
    EXPECT_TRUE(imageio::check_target(in_folder("new")).ok());
    EXPECT_TRUE(listing().empty());
}

} // namespace
} // namespace glint
