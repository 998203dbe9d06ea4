// Scripts: every event there is, and every way to get one wrong.
#include "viewer/script.hpp"

#include <gtest/gtest.h>

namespace glint::viewer {
namespace {

using Kind = InputEvent::Kind;

Script parsed(std::string_view text) {
    Result<Script> script = Script::parse(text, "walk.txt");
    EXPECT_TRUE(script.ok()) << (script.ok() ? "" : script.error().text());
    return script.ok() ? std::move(*script) : Script();
}

TEST(Script, has_every_event) {
    const Script script = parsed("# a walk\n"
                                 "0.5 press left 100 200.5\r\n"
                                 "\n"
                                 "0.75\tmove -150 200   # beyond the edge\n"
                                 "1 release right 1 2\n"
                                 "2 wheel -2.5 256 128\n"
                                 "3 key w down\n4 key + up\n5 key 7\n"
                                 "6 finger 3 down 10 20\n7 finger 3 move 11 21\n8 finger 3 up 12 22\n"
                                 "9 resize 640 480\n10 lose-context\n11 close");
    const auto &events = script.events();
    ASSERT_EQ(events.size(), 14u);
    EXPECT_EQ(events[0].seconds, 0.5);
    EXPECT_EQ(events[0].event.kind, Kind::button_down);
    EXPECT_EQ(events[0].event.button, Button::left);
    EXPECT_EQ(events[0].event.x, 100.0);
    EXPECT_EQ(events[0].event.y, 200.5);
    EXPECT_EQ(events[1].event.kind, Kind::move);
    EXPECT_EQ(events[1].event.x, -150.0);
    EXPECT_EQ(events[2].event.kind, Kind::button_up);
    EXPECT_EQ(events[2].event.button, Button::right);
    EXPECT_EQ(events[3].event.kind, Kind::wheel);
    EXPECT_EQ(events[3].event.amount, -2.5);
    EXPECT_EQ(events[4].event.kind, Kind::key_down);
    EXPECT_EQ(events[4].event.key, Key::w);
    EXPECT_EQ(events[5].event.kind, Kind::key_up);
    EXPECT_EQ(events[5].event.key, Key::plus);
    EXPECT_EQ(events[6].event.kind, Kind::key_down);
    EXPECT_EQ(events[7].event.kind, Kind::key_up);
    EXPECT_EQ(events[7].event.key, Key::digit7);
    EXPECT_EQ(events[8].event.kind, Kind::finger_down);
    EXPECT_EQ(events[9].event.kind, Kind::finger_move);
    EXPECT_EQ(events[10].event.kind, Kind::finger_up);
    EXPECT_EQ(events[10].event.finger, 3u);
    EXPECT_EQ(events[11].event.width_px, 640u);
    EXPECT_EQ(events[11].event.height_px, 480u);
    EXPECT_EQ(events[12].event.kind, Kind::context_lost);
    EXPECT_EQ(events[13].event.kind, Kind::close);
}

TEST(Script, draws_a_drag_out_evenly) {
    const Script script = parsed("1 drag right 10 20 110 70 2");
    const auto &events = script.events();
    ASSERT_EQ(events.size(), 252u); // 125 moves a second
    EXPECT_EQ(events.front().event.kind, Kind::button_down);
    EXPECT_EQ(events.front().event.x, 10.0);
    EXPECT_EQ(events[125].event.kind, Kind::move);
    EXPECT_DOUBLE_EQ(events[125].seconds, 2.0);
    EXPECT_DOUBLE_EQ(events[125].event.x, 60.0);
    EXPECT_DOUBLE_EQ(events[125].event.y, 45.0);
    EXPECT_EQ(events.back().event.kind, Kind::button_up);
    EXPECT_EQ(events.back().event.button, Button::right);
    EXPECT_DOUBLE_EQ(events.back().seconds, 3.0);
    EXPECT_DOUBLE_EQ(events.back().event.x, 110.0);
}

TEST(Script, goes_by_time_not_by_line) {
    Script script = parsed("2 close\n1 key a down\n1 key a up\n");
    EXPECT_EQ(script.next_seconds(), 1.0);
    std::vector<TimedEvent> events;
    script.take_until(0.999, events);
    EXPECT_TRUE(events.empty());
    script.take_until(1.0, events);
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].event.kind, Kind::key_down); // of the same time, in the order of the lines
    EXPECT_EQ(events[1].event.kind, Kind::key_up);
    EXPECT_EQ(script.next_seconds(), 2.0);
    script.take_until(100.0, events);
    EXPECT_EQ(events.size(), 3u);
    EXPECT_FALSE(script.next_seconds());
}

struct BadLine {
    const char *line;
    uint32_t column;
    const char *message;
};
class BadScript : public testing::TestWithParam<BadLine> {};

TEST_P(BadScript, is_refused_with_its_place) {
    const Result<Script> script = Script::parse(std::string("0 close\n") + GetParam().line + "\n", "walk.txt");
    ASSERT_FALSE(script.ok());
    ASSERT_EQ(script.error().diagnostics.size(), 1u);
    const Diagnostic &problem = script.error().diagnostics.front();
    EXPECT_EQ(script.error().code, ErrorCode::bad_input);
    EXPECT_EQ(problem.file, "walk.txt");
    EXPECT_EQ(problem.line, 2u);
    EXPECT_EQ(problem.column, GetParam().column);
    EXPECT_EQ(problem.message, GetParam().message);
    EXPECT_EQ(problem.source_line, GetParam().line);
}

INSTANTIATE_TEST_SUITE_P(
    lines, BadScript,
    testing::Values(BadLine{"soon close", 1, "'soon' is not a time in seconds"},
                    BadLine{"-1 close", 1, "'-1' is not a time in seconds"},
                    BadLine{"nan close", 1, "'nan' is not a time in seconds"},
                    BadLine{"1e9 close", 1, "'1e9' is not a time in seconds"},
                    BadLine{"1,5 close", 1, "'1,5' is not a time in seconds"},
                    BadLine{"1", 2, "expected what happens then"},
                    BadLine{"1 # close", 3, "expected what happens then"},
                    BadLine{"1 dance", 3,
                            "unknown event 'dance', expected press, release, move, drag, wheel, key, finger, resize, "
                            "lose-context or close"},
                    BadLine{"1 press thumb 1 2", 9, "'thumb' is not a button: left, middle or right"},
                    BadLine{"1 press left 1", 15, "expected a row in pixels"},
                    BadLine{"1 press left 1 2 3", 18, "nothing more was expected on this line"},
                    BadLine{"1 move x 2", 8, "'x' is not a column in pixels"},
                    BadLine{"1 move inf 2", 8, "'inf' is not a column in pixels"},
                    BadLine{"1 wheel up 2 3", 9, "'up' is not notches of the wheel"},
                    BadLine{"1 key x", 7, "'x' is not a key that means something here"},
                    BadLine{"1 key w sideways", 9, "'sideways' is neither down nor up"},
                    BadLine{"1 finger 1 tap 2 3", 12, "'tap' is neither down, move nor up"},
                    BadLine{"1 finger -1 up 2 3", 10, "'-1' is not a finger's number"},
                    BadLine{"1 resize 0 480", 10, "'0' is not a width in pixels"},
                    BadLine{"1 drag left 1 2 3 4 601", 21, "'601' is not a time of up to 600 seconds"},
                    BadLine{"1 drag left 1 2 3", 18, "expected a row in pixels"},
                    BadLine{"1 close now", 9, "nothing more was expected on this line"}),
    [](const auto &line) { return "line_" + std::to_string(line.index); });

TEST(Script, tells_of_every_bad_line_up_to_twenty) {
    std::string text = "1 dance\n2 close\nthen close\n";
    EXPECT_EQ(Script::parse(text, "walk.txt").error().diagnostics.size(), 2u);
    for (int line = 0; line < 100; ++line) text += "?\n";
    EXPECT_EQ(Script::parse(text, "walk.txt").error().diagnostics.size(), 20u);
}

TEST(Script, may_be_anything_without_harm) {
    uint64_t state = 1;
    const std::string_view words[] = {"1",   "press", "left", "-",  "drag", "#",      "key", "w",   "\n",
                                      "9e9", "wheel", "nan",  "\t", "\0x",  "finger", "up",  "0.5", "\xff"};
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (int i = 0; i < 40; ++i) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            text += words[(state >> 33) % std::size(words)];
            text += (state >> 60) % 3 == 0 ? "" : " ";
        }
        const Result<Script> script = Script::parse(text, "noise");
        if (!script) {
            EXPECT_FALSE(script.error().diagnostics.empty());
        }
    }
}

TEST(Script, that_is_not_there_says_so) {
    const Result<Script> script = Script::read("/no/such/walk.txt");
    ASSERT_FALSE(script.ok());
    EXPECT_EQ(script.error().code, ErrorCode::not_found);
    EXPECT_FALSE(Script::read("/").ok());
}

} // namespace
} // namespace glint::viewer
