// Every printable letter has a shape, and none has another's.
#include "viewer/hud/font.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

using viewer::Glyph;

std::string shape_of(char letter) {
    const Glyph glyph(letter);
    std::string shape;
    for (int y = 0; y < Glyph::height_px; ++y) {
        for (int x = 0; x < Glyph::width_px; ++x) shape += glyph.has_ink(x, y) ? '#' : '.';
        shape += '\n';
    }
    return shape;
}

TEST(Font, has_a_shape_of_its_own_for_every_printable_letter) {
    std::map<std::string, char> letters;
    for (char letter = ' '; letter <= '~'; ++letter) {
        const auto [known, is_new] = letters.emplace(shape_of(letter), letter);
        EXPECT_TRUE(is_new) << letter << " looks like " << known->second;
        EXPECT_EQ(shape_of(letter).find('#') == std::string::npos, letter == ' ') << letter;
    }
    EXPECT_EQ(letters.size(), 95u);
    EXPECT_FALSE(letters.contains(shape_of('\n')));
}

TEST(Font, shows_a_box_for_everything_else) {
    for (const int byte : {0, 7, 10, 31, 127, 128, 200, 255}) {
        EXPECT_EQ(shape_of(static_cast<char>(byte)), "#####\n#...#\n#...#\n#...#\n#...#\n#...#\n#####\n.....\n.....\n");
    }
}

TEST(Font, keeps_capitals_and_digits_on_the_line) {
    for (const char letter : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789")) {
        const std::string shape = shape_of(letter);
        EXPECT_NE(shape.substr(0, 5), ".....") << letter;
        EXPECT_NE(shape.substr(36, 5), ".....") << letter;
        EXPECT_EQ(shape.substr(42), ".....\n.....\n") << letter;
    }
}

TEST(Font, draws_the_letters_one_expects) {
    EXPECT_EQ(shape_of('T'), "#####\n..#..\n..#..\n..#..\n..#..\n..#..\n..#..\n.....\n.....\n");
    EXPECT_EQ(shape_of('L'), "#....\n#....\n#....\n#....\n#....\n#....\n#####\n.....\n.....\n");
    EXPECT_EQ(shape_of('-'), ".....\n.....\n.....\n#####\n.....\n.....\n.....\n.....\n.....\n");
}

} // namespace
} // namespace glint::test
