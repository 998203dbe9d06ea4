// The generated files: which there are, and that they are the same bytes every time and everywhere.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "generate/models.hpp"
#include "generate/obj_writer.hpp"
#include "scenes/scene_folder.hpp"

namespace glint::scenes {
namespace {

/// FNV-1a (Fowler, Noll and Vo), 64 bits, continued from `hash`.
uint64_t fnv1a(const std::string &text, uint64_t hash) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

struct ModelHash {
    std::string name;
    uint64_t hash; ///< of all its files' text, one after another
    friend void PrintTo(const ModelHash &model, std::ostream *out) { *out << model.name; }
};

class ModelFiles : public testing::TestWithParam<ModelHash> {
protected:
    static std::vector<NamedMesh> make(const std::string &name) {
        for (const Model &model : models())
            if (model.name == name) return model.make();
        ADD_FAILURE() << "no model " << name;
        return {};
    }
};

TEST_P(ModelFiles, are_the_same_bytes_every_time_and_on_every_machine) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const NamedMesh &file : make(GetParam().name)) {
        const std::string text = obj_text(file);
        // The build made the file in another process.
        EXPECT_TRUE(text == test::text_of(test::scene_folder() / "generated" / file.file_name)) << file.file_name;
        EXPECT_LE(text.size(), 45'000'000u) << file.file_name;
        hash = fnv1a(text, hash);
    }
    EXPECT_EQ(hash, GetParam().hash) << std::hex << "now 0x" << hash
                                     << ": change it here if you changed the model, never for a machine's sake";
}

INSTANTIATE_TEST_SUITE_P(, ModelFiles,
                         testing::Values(ModelHash{"sphereflake", 0xa36f1c96d1180143},
                                         ModelHash{"terrain", 0x1af5f49d68552075},
                                         ModelHash{"gears", 0xf33c8fcedae35eaf},
                                         ModelHash{"mirrors", 0xd8a799342c208680},
                                         ModelHash{"lights16", 0x6289cc14510112fb}),
                         [](const auto &instance) { return instance.param.name; });

TEST(GeneratedFolder, is_listed_by_the_build_file_for_file) {
    std::vector<std::string> listed;
    std::ifstream list(GLINT_BINARY_DIR "/tests/scenes/generated_files.txt");
    for (std::string path; std::getline(list, path);) listed.push_back(std::filesystem::path(path).filename().string());
    std::vector<std::string> made;
    for (const Model &model : models())
        for (const NamedMesh &file : model.make()) made.push_back(file.file_name);
    std::sort(listed.begin(), listed.end());
    std::sort(made.begin(), made.end());
    EXPECT_EQ(listed, made);
}

} // namespace
} // namespace glint::scenes
