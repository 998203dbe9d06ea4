// Broken in any way, an SDL file gives a scene or an error with its place: quickly, and in little memory.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>

#include <malloc.h>

#include <gtest/gtest.h>

#include "sdl/good_corpus.hpp"
#include "support/cpu_time.hpp"
#include "support/mutate.hpp"
#include "support/written_files.hpp"

namespace {

/// Bytes that operator new has given and not got back, and the most there ever were. Everything in the reader and the
/// libraries under it allocates by it.
std::atomic<size_t> live_bytes = 0, most_live_bytes = 0;

void *counted_allocation(size_t size) {
    void *const memory = std::malloc(size > 0 ? size : 1);
    if (!memory) return nullptr;
    const size_t now = live_bytes += malloc_usable_size(memory);
    for (size_t most = most_live_bytes; now > most && !most_live_bytes.compare_exchange_weak(most, now);) {
    }
    return memory;
}

} // namespace

void *operator new(size_t size) {
    if (void *const memory = counted_allocation(size)) return memory;
    throw std::bad_alloc();
}
void *operator new[](size_t size) {
    return operator new(size);
}
void *operator new(size_t size, const std::nothrow_t &) noexcept {
    return counted_allocation(size);
}
void *operator new[](size_t size, const std::nothrow_t &) noexcept {
    return counted_allocation(size);
}
void operator delete(void *memory) noexcept {
    if (memory) live_bytes -= malloc_usable_size(memory);
    std::free(memory);
}
void operator delete[](void *memory) noexcept {
    operator delete(memory);
}
void operator delete(void *memory, size_t) noexcept {
    operator delete(memory);
}
void operator delete[](void *memory, size_t) noexcept {
    operator delete(memory);
}
void operator delete(void *memory, const std::nothrow_t &) noexcept {
    operator delete(memory);
}
void operator delete[](void *memory, const std::nothrow_t &) noexcept {
    operator delete(memory);
}

namespace glint::test {
namespace {

constexpr size_t most_bytes = size_t{64} << 20;
constexpr double most_seconds = 1.0;

// Sanitizers take fifty times as long: they see some of every kind of change. A prime, which no number of rules
// divides.
#ifdef GLINT_SANITIZED
constexpr int changes_per_read = 7;
#else
constexpr int changes_per_read = 1;
#endif

/// What became of the texts that were read.
struct Outcome {
    int scenes = 0, errors = 0;
};

class MutatedScenes : public WrittenFiles {
protected:
    void SetUp() override {
        WrittenFiles::SetUp();
        std::filesystem::copy(good_corpus(), in_folder("corpus"), std::filesystem::copy_options::recursive);
    }

    /// Reads the text beside one of the corpus's scenes. It stays on the disk when the reader crashes.
    void read(const std::string &scene, const std::string &text, Outcome &outcome) {
        if (++changes_ % changes_per_read != 0) return;
        // Always a new file: some file systems wait for the disk when an old one is written over.
        const auto file = write("corpus/" + scene + "." + std::to_string(++files_) + ".sdl", text);
        ReadOptions options;
        options.scene_root = in_folder("corpus");
        const size_t before = live_bytes;
        most_live_bytes = before;
        const CpuTime time;
        const auto result = read_scene(file, options);
        ASSERT_LT(time.seconds(), most_seconds) << text;
        ASSERT_LT(most_live_bytes - before, most_bytes) << text;
        most_taken_ = std::max(most_taken_, most_live_bytes - before);
        std::filesystem::remove(file);
        result.ok() ? expect_valid(*result->scene, text, outcome) : expect_told(result.error(), text, outcome);
    }

    /// For who runs this with --gtest_output.
    void TearDown() override { RecordProperty("most_bytes_taken", std::to_string(most_taken_)); }

private:
    int changes_ = 0, files_ = 0;
    size_t most_taken_ = 0;

    static void expect_valid(const Scene &scene, const std::string &text, Outcome &outcome) {
        ++outcome.scenes;
        // A scene that is built anew from its parts passes the last wall again.
        SceneBuilder builder;
        for (const Object &object : scene.objects()) builder.add_object(object);
        for (const Light &light : scene.lights()) builder.add_light(light);
        builder.set_camera(scene.camera()).set_picture(scene.picture()).set_background(scene.background());
        const auto again = builder.set_ambient(scene.ambient()).set_optics(scene.optics()).build();
        ASSERT_TRUE(again.ok()) << text << again.error().text();
        ASSERT_EQ((*again)->skipped_triangles(), 0u) << text;
        ASSERT_GT(scene.lights().size(), 0u) << text;
    }

    static void expect_told(const Error &error, const std::string &text, Outcome &outcome) {
        ++outcome.errors;
        ASSERT_FALSE(error.diagnostics.empty()) << text;
        for (const Diagnostic &diagnostic : error.diagnostics) {
            // What is missing stands nowhere, and a mesh that is wrong as a whole where it is named. What the scene
            // builder finds, the reader missed: the builder knows no places.
            ASSERT_TRUE(diagnostic.line > 0 || diagnostic.message.starts_with("there is no '") ||
                        diagnostic.hint.starts_with("named in "))
                << text << diagnostic.text();
            ASSERT_FALSE(diagnostic.message.empty()) << text;
            ASSERT_FALSE(diagnostic.file.empty()) << text;
        }
    }
};

std::string text_of(const std::string &scene) {
    std::ifstream file(good_file(scene), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST_F(MutatedScenes, by_every_rule_at_every_word_give_a_valid_scene_or_an_error_with_a_place) {
    Outcome outcome;
    Random random(2013);
    for (const std::string &scene : good_scenes()) {
        const std::string good = text_of(scene);
        const std::vector<Words> lines = lines_of(good);
        for (size_t line = 0; line < lines.size(); ++line) {
            for (size_t word = 0; word < lines[line].size(); ++word) {
                for (uint32_t rule = 0; rule < word_rules; ++rule) {
                    const Words words = changed(lines[line], word, static_cast<WordRule>(rule), random);
                    read(scene, text_with(lines, line, words), outcome);
                    if (HasFatalFailure()) return;
                }
            }
            for (uint32_t rule = 0; rule < line_rules; ++rule) {
                read(scene, changed_lines(lines, line, static_cast<LineRule>(rule), random), outcome);
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_GT(outcome.scenes, 1000 / changes_per_read);
    EXPECT_GT(outcome.errors, 1000 / changes_per_read);
}

TEST_F(MutatedScenes, at_every_number_survive_extremes) {
    Outcome outcome;
    for (const std::string scene :
         {"glint_everything", "mobile2013_sun_and_spot", "path2005_bubbles", "cg_mixed_terms"}) {
        const std::vector<Words> lines = lines_of(text_of(scene));
        for (size_t line = 0; line < lines.size(); ++line) {
            for (size_t word = 1; word < lines[line].size(); ++word) {
                for (const std::string_view extreme : extremes) {
                    Words words = lines[line];
                    words[word] = extreme;
                    // The picture and its samples may be large; what is read stays small.
                    read(scene, text_with(lines, line, words), outcome);
                    if (HasFatalFailure()) return;
                }
            }
        }
    }
    EXPECT_GT(outcome.scenes, 300 / changes_per_read);
    EXPECT_GT(outcome.errors, 1000 / changes_per_read);
}

TEST_F(MutatedScenes, byte_by_byte_give_a_valid_scene_or_an_error_with_a_place) {
    Outcome outcome;
    Random random(2005);
    for (const std::string &scene : good_scenes()) {
        const std::string good = text_of(scene);
        for (int i = 0; i < 60; ++i) {
            read(scene, mutated(good, random), outcome);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(outcome.scenes, 200 / changes_per_read);
    EXPECT_GT(outcome.errors, 200 / changes_per_read);
}

TEST_F(MutatedScenes, with_mutated_meshes_give_a_mesh_or_an_error) {
    Random random(77);
    int meshes = 0, errors = 0;
    for (const auto &entry : std::filesystem::directory_iterator(good_corpus() / "room")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string good{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        const std::vector<Words> lines = lines_of(good);
        for (int i = 0; i < 150; ++i) {
            const size_t line = random.below(static_cast<uint32_t>(lines.size()));
            const auto rule = static_cast<LineRule>(random.below(line_rules));
            std::string text = changed_lines(lines, line, rule, random);
            if (i % 5 != 0 && !lines[line].empty()) {
                const size_t word = random.below(static_cast<uint32_t>(lines[line].size()));
                const auto word_rule = static_cast<WordRule>(random.below(word_rules));
                text = text_with(lines, line, changed(lines[line], word, word_rule, random));
            }
            const auto path = write("mesh" + std::to_string(meshes + errors) + ".obj", text);
            const size_t before = live_bytes;
            most_live_bytes = before;
            const CpuTime time;
            const auto mesh = read_obj(path);
            ASSERT_LT(time.seconds(), most_seconds) << text;
            ASSERT_LT(most_live_bytes - before, most_bytes) << text;
            ++(mesh.ok() ? meshes : errors);
            if (!mesh.ok()) continue;
            SceneBuilder builder;
            ASSERT_TRUE(builder.add_object({"mutated", mesh->mesh, {}}).build().ok()) << text;
        }
    }
    EXPECT_GT(meshes, 300);
    EXPECT_GT(errors, 300);
}

TEST_F(MutatedScenes, cut_short_anywhere_lack_something_or_are_scenes) {
    Outcome outcome;
    for (const std::string scene : {"mobile2013_star", "path2005_bubbles"}) {
        const std::string good = text_of(scene);
        for (size_t length = 0; length < good.size(); ++length) {
            read(scene, good.substr(0, length), outcome);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(outcome.scenes, 10 / changes_per_read);
    EXPECT_GT(outcome.errors, 100 / changes_per_read);
}

TEST(CountedMemory, sees_what_a_reader_takes) {
    most_live_bytes = live_bytes.load();
    const size_t before = live_bytes;
    { const std::vector<char> large(size_t{10} << 20); }
    EXPECT_GE(most_live_bytes - before, size_t{10} << 20) << "else the tests above prove nothing";
    EXPECT_LT(live_bytes - before, size_t{1} << 20);
}

} // namespace
} // namespace glint::test
