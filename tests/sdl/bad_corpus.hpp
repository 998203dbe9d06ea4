// The files of tests/sdl/bad, one fault each, and what is said about them: `messages.txt` of each folder.
//
// To add a case, write the file and put what `glint_bad_messages FOLDER` prints into the folder's messages.txt.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <glint/read.hpp>

namespace glint::test {

[[nodiscard]] inline std::filesystem::path bad_corpus() {
    return std::filesystem::path(GLINT_SOURCE_DIR) / "tests" / "sdl" / "bad";
}

[[nodiscard]] inline std::vector<std::string> bad_folders() {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(bad_corpus())) {
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// Names of the folder's cases: every .sdl, and in the folder "obj" every .obj.
[[nodiscard]] inline std::vector<std::string> bad_files(const std::string &folder) {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(bad_corpus() / folder)) {
        const auto extension = entry.path().extension();
        if (extension == (folder == "obj" ? ".obj" : ".sdl")) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// What reading the file ends with. The folder of the corpus is the scene root, so that scenes share its two meshes.
[[nodiscard]] inline Error error_of_bad_file(const std::string &folder, const std::string &name) {
    const std::filesystem::path file = bad_corpus() / folder / name;
    const auto refused = [](auto result) { return result.ok() ? Error(ErrorCode::io, "it was read") : result.error(); };
    ReadOptions options;
    options.scene_root = bad_corpus();
    return folder == "obj" ? refused(read_obj(file)) : refused(read_scene(file, options));
}

/// The same as an entry of messages.txt: the corpus is called "bad", wherever it lies, and the code is told where it is
/// not bad_input.
[[nodiscard]] inline std::string said_about(const std::string &folder, const std::string &name) {
    const Error error = error_of_bad_file(folder, name);
    std::string text = error.text();
    for (const std::string &root : {bad_corpus().string(), std::filesystem::canonical(bad_corpus()).string()}) {
        for (size_t at; (at = text.find(root)) != std::string::npos;) text.replace(at, root.size(), "bad");
    }
    const char *code = error.code == ErrorCode::limit_exceeded ? "limit exceeded: "
                       : error.code == ErrorCode::not_found    ? "not found: "
                       : error.code == ErrorCode::bad_input    ? ""
                                                               : "other: ";
    return code + text + '\n';
}

/// The entries of a folder's messages.txt by file.
[[nodiscard]] inline std::map<std::string, std::string> bad_messages(const std::string &folder) {
    std::ifstream lines(bad_corpus() / folder / "messages.txt");
    std::map<std::string, std::string> messages;
    std::string name;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("== ")) {
            name = line.substr(3);
        } else if (!line.empty()) {
            messages[name] += line + '\n';
        }
    }
    return messages;
}

} // namespace glint::test
