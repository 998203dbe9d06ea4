// Every scene of tests/sdl/good is read, shows something, and keeps its picture; together they have every directive.
#include "sdl/good_corpus.hpp"

#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "sdl/dialects.hpp"
#include "sdl/lexer.hpp"
#include "sdl/read_scene.hpp"
#include "text/plain_text.hpp"

namespace glint::test {
namespace {

std::string text_of(const std::string &scene) {
    std::ifstream file(good_file(scene), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class GoodScene : public testing::TestWithParam<std::string> {};

TEST_P(GoodScene, is_read_as_the_dialect_it_is_named_after) {
    const auto file = read_scene(good_file(GetParam()), good_options());
    ASSERT_TRUE(file.ok()) << file.error().text();
    const std::string name = std::filesystem::path(GetParam()).filename().string();
    const std::string dialect = file->dialect == "cg-path-tracer" ? "cg" : file->dialect;
    const bool is_in_a_folder = GetParam() != name;
    EXPECT_TRUE(is_in_a_folder || name.starts_with(dialect + "_")) << "it is " << file->dialect;
    EXPECT_EQ(file->warnings.size(), name == "ray2005_over_one" ? 1u : 0u);
    EXPECT_FALSE(file->dialect_reason.empty());
}

TEST_P(GoodScene, begins_with_a_line_that_says_what_it_shows) {
    const std::string text = text_of(GetParam());
    EXPECT_TRUE(without_byte_order_mark(text).starts_with("# ")) << text.substr(0, 80);
}

TEST_P(GoodScene, keeps_its_picture_for_every_instruction_set) {
    const auto table = good_hashes();
    const auto golden = table.find(GetParam());
    ASSERT_TRUE(golden != table.end()) << "no line in hashes.txt; see good_corpus.hpp";
    for (const Isa isa : available_isas()) {
        EXPECT_EQ(picture_of_good_scene(GetParam(), isa), golden->second) << isa_name(isa);
    }
}

TEST_P(GoodScene, converts_to_a_file_with_the_same_picture_that_converts_into_itself) {
    const auto text_file = [](const std::string &text) {
        TextFile file;
        file.bytes = std::make_unique<char[]>(text.size());
        file.size = text.size();
        std::copy(text.begin(), text.end(), file.bytes.get());
        return file;
    };
    const std::filesystem::path path = good_file(GetParam());
    const auto converted = convert_scene(path, path.parent_path(), good_options());
    ASSERT_TRUE(converted.ok()) << converted.error().text();
    const auto file = read_scene_text(text_file(converted->text), path, good_options());
    ASSERT_TRUE(file.ok()) << file.error().text() << '\n' << converted->text;
    EXPECT_EQ(file->dialect, "glint");
    const PictureSettings &wanted = file->scene->picture();
    const Framebuffer picture = render(file->scene, wanted.width_px, wanted.height_px, wanted.max_depth);
    EXPECT_EQ(hashes_of(picture), good_hashes().at(GetParam()));
    const auto again = convert_scene_text(text_file(converted->text), path, path.parent_path(), good_options());
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_EQ(again->text, converted->text);
}

TEST_P(GoodScene, shows_something) {
    const auto file = read_scene(good_file(GetParam()), good_options());
    ASSERT_TRUE(file.ok());
    const PictureSettings &wanted = file->scene->picture();
    const Framebuffer picture = render(file->scene, wanted.width_px, wanted.height_px, wanted.max_depth);
    std::set<uint32_t> colors;
    for (uint32_t i = 0; i < wanted.width_px * wanted.height_px; ++i) {
        const uint8_t *p = picture.rgba8() + size_t{i} * 4;
        colors.insert(uint32_t{p[0]} << 16 | uint32_t{p[1]} << 8 | p[2]);
    }
    EXPECT_GT(colors.size(), 50u);
}

INSTANTIATE_TEST_SUITE_P(of_the_corpus, GoodScene, testing::ValuesIn(good_scenes()), [](const auto &test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
});

TEST(GoodCorpus, has_forty_scenes_and_no_line_about_others) {
    const std::vector<std::string> scenes = good_scenes();
    EXPECT_GE(scenes.size(), 40u);
    const auto exists = [&](const std::string &name) { return std::count(scenes.begin(), scenes.end(), name) == 1; };
    for (const auto &[scene, hashes] : good_hashes()) EXPECT_TRUE(exists(scene)) << scene << " in hashes.txt";
}

TEST(GoodCorpus, has_every_form_of_every_directive_in_every_dialect_that_is_written_with_it) {
    std::set<const DirectiveForm *> seen;
    for (const std::string &scene : good_scenes()) {
        const auto file = read_scene(good_file(scene), good_options());
        ASSERT_TRUE(file.ok()) << file.error().text();
        const Dialect dialect = *dialect_named(file->dialect);
        const std::string text = text_of(scene);
        Lexer lexer(without_byte_order_mark(text));
        for (Line line; lexer.next(line);) {
            for (const DirectiveForm &form : forms_of(line.tokens[0].text)) {
                if (form.dialects.has(dialect) && form.fits(line)) seen.insert(&form);
            }
        }
    }
    for (const DirectiveForm &form : directive_forms()) EXPECT_TRUE(seen.contains(&form)) << form.usage;
}

} // namespace
} // namespace glint::test
