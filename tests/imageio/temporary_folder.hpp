// A folder of a test's own, gone when the test is over.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

namespace glint::test {

class TemporaryFolder : public ::testing::Test {
protected:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "glint-test-XXXXXX").string();
        if (::mkdtemp(name.data())) folder_ = name;
    }
    ~TemporaryFolder() override {
        std::error_code ignored;
        if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
    }
    void SetUp() override { ASSERT_FALSE(folder_.empty()) << "no temporary folder to be had"; }

    [[nodiscard]] std::filesystem::path in_folder(const std::string &name) const { return folder_ / name; }

    /// Names of everything in the folder, in no order.
    [[nodiscard]] std::vector<std::string> listing() const {
        std::vector<std::string> names;
        for (const auto &entry : std::filesystem::directory_iterator(folder_)) {
            names.push_back(entry.path().filename().string());
        }
        return names;
    }

private:
    std::filesystem::path folder_;
};

} // namespace glint::test
