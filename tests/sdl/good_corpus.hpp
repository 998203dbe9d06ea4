// The scenes of tests/sdl/good, the hashes of their pictures, and how the two are compared.
//
// After a change that is meant to change pictures: look at them (`glint render`), then put what `glint_good_pictures`
// prints into hashes.txt.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "golden/golden_table.hpp"
#include "support/picture.hpp"

namespace glint::test {

[[nodiscard]] inline std::filesystem::path good_corpus() {
    return std::filesystem::path(GLINT_SOURCE_DIR) / "tests" / "sdl" / "good";
}

/// Every .sdl, in folders too, as "Input/config/x" without the ending.
[[nodiscard]] inline std::vector<std::string> good_scenes() {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(good_corpus())) {
        if (entry.path().extension() != ".sdl") continue;
        names.push_back(entry.path().lexically_relative(good_corpus()).replace_extension().generic_string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

[[nodiscard]] inline std::filesystem::path good_file(const std::string &scene) {
    return good_corpus() / (scene + ".sdl");
}

/// The corpus is the scene root.
[[nodiscard]] inline ReadOptions good_options() {
    ReadOptions options;
    options.scene_root = good_corpus();
    return options;
}

/// The picture that the file asks for, with this instruction set.
[[nodiscard]] inline PictureHashes picture_of_good_scene(const std::string &scene, Isa isa) {
    const auto file = read_scene(good_file(scene), good_options());
    if (!file.ok()) throw std::runtime_error(file.error().text());
    const PictureSettings &wanted = file->scene->picture();
    return hashes_of(render(Accel::build(file->scene), wanted.width_px, wanted.height_px, wanted.max_depth, {2, isa}));
}

/// hashes.txt: a scene, the hash of its 8-bit pixels and that of its radiance a line.
[[nodiscard]] inline std::map<std::string, PictureHashes> good_hashes() {
    std::ifstream lines(good_corpus() / "hashes.txt");
    std::map<std::string, PictureHashes> table;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        std::string scene;
        words >> scene;
        words >> table[scene].pixels >> table[scene].radiance;
    }
    return table;
}

} // namespace glint::test
