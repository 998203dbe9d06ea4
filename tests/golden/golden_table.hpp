// The pictures that must not change, and their fingerprints: what pictures.txt says.
#pragma once

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <glint/framebuffer.hpp>

namespace glint::test {

struct PictureHashes {
    std::string pixels, radiance; ///< 16 hexadecimal digits each
    bool operator==(const PictureHashes &) const = default;
};

/// A line of the table.
struct Golden {
    std::string scene; ///< a file of scenes/sdl, without ".sdl"
    uint32_t width, height, depth;
    PictureHashes hashes;
};

inline std::ostream &operator<<(std::ostream &out, const PictureHashes &hashes) {
    return out << hashes.pixels << ' ' << hashes.radiance;
}
inline std::ostream &operator<<(std::ostream &out, const Golden &golden) {
    return out << golden.scene << ' ' << golden.width << ' ' << golden.height << ' ' << golden.depth << ' '
               << golden.hashes;
}

[[nodiscard]] inline PictureHashes hashes_of(const Framebuffer &picture) {
    const auto digits = [](uint64_t hash) {
        std::ostringstream text;
        text << std::hex << std::setfill('0') << std::setw(16) << hash;
        return text.str();
    };
    return {digits(picture.pixel_hash()), digits(picture.radiance_hash())};
}

/// Empty where there is no such file.
[[nodiscard]] inline std::vector<Golden> golden_table(const std::filesystem::path &file) {
    std::ifstream lines(file);
    std::vector<Golden> table;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        Golden golden;
        std::istringstream words(line);
        words >> golden.scene >> golden.width >> golden.height >> golden.depth >> golden.hashes.pixels >>
            golden.hashes.radiance;
        table.push_back(golden);
    }
    return table;
}

} // namespace glint::test
