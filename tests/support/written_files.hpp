// Files that a test writes into a folder of its own.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "imageio/temporary_folder.hpp"

namespace glint::test {

class WrittenFiles : public TemporaryFolder {
protected:
    /// Writes the file, and the folders it lies in, and returns its path.
    std::filesystem::path write(const std::string &name, std::string_view text) const {
        const std::filesystem::path path = in_folder(name);
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
        return path;
    }
};

} // namespace glint::test
