// The benchmark's parts that can be wrong without any timing: statistics, comparison, reports.
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/paper.hpp"
#include "bench/report.hpp"
#include "bench/shown_picture.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {
namespace {

std::vector<double> one_to(int count) {
    std::vector<double> values(static_cast<size_t>(count));
    std::iota(values.rbegin(), values.rend(), 1.0);
    return values;
}

TEST(BenchStatistics, an_odd_number_of_measurements_has_a_middle_one) {
    EXPECT_EQ(summarize({9.0, 1.0, 5.0}).median, 5.0);
    EXPECT_EQ(summarize({9.0, 1.0, 5.0}).min, 1.0);
}

TEST(BenchStatistics, an_even_number_of_measurements_has_two) {
    EXPECT_EQ(summarize({4.0, 1.0, 9.0, 2.0}).median, 3.0);
}

TEST(BenchStatistics, the_95th_percentile_is_the_nearest_rank) {
    EXPECT_EQ(summarize(one_to(100)).p95, 95.0);
    EXPECT_EQ(summarize(one_to(50)).p95, 48.0); // ceil(47.5)
    EXPECT_EQ(summarize(one_to(20)).p95, 19.0);
    EXPECT_EQ(summarize(one_to(19)).p95, 19.0);
    EXPECT_EQ(summarize({7.0}).p95, 7.0);
}

TEST(BenchStatistics, nothing_measured_is_all_zero) {
    EXPECT_EQ(summarize({}).median, 0.0);
}

Framebuffer small_picture() {
    Framebuffer picture = Framebuffer::create(3, 2, false).value();
    for (int i = 0; i < 24; ++i) picture.rgba8()[i] = static_cast<uint8_t>(10 * i);
    return picture;
}

TEST(ShownPicture, the_same_bytes_pass) {
    const Framebuffer picture = small_picture();
    EXPECT_TRUE(compare_shown(picture, {picture.rgba8(), 24}).ok());
}

TEST(ShownPicture, one_differing_byte_fails_and_is_named) {
    const Framebuffer picture = small_picture();
    for (size_t byte = 0; byte < 24; ++byte) {
        std::vector<uint8_t> shown(picture.rgba8(), picture.rgba8() + 24);
        shown[byte] ^= 1u;
        EXPECT_FALSE(compare_shown(picture, shown).ok()) << byte;
    }
    std::vector<uint8_t> shown(picture.rgba8(), picture.rgba8() + 24);
    shown[17] = 0; // channel 1 of pixel 4
    shown[20] = 0;
    const std::string text = compare_shown(picture, shown).error().text();
    EXPECT_NE(text.find("2 of 24 bytes"), std::string::npos) << text;
    EXPECT_NE(text.find("channel 1 of pixel (1, 1): rendered 170, shown 0"), std::string::npos) << text;
}

TEST(ShownPicture, another_size_fails) {
    const Framebuffer picture = small_picture();
    EXPECT_FALSE(compare_shown(picture, {picture.rgba8(), 20}).ok());
}

/// Two rows with made-up figures: one that the paper has, one that it has not.
Table small_table(std::string scene = "scenes/sdl/cornell.sdl") {
    Row row;
    row.width_px = row.height_px = 128;
    row.depth = 1;
    row.frames = 50;
    row.render_ms = {4.186, 4.0, 5.0};
    row.upload_ms = {0.01, 0.005, 0.02};
    row.gl_ms = {0.047, 0.04, 0.05};
    row.time_to_image_ms = {4.235, 4.045, 5.07};
    row.fps = 200.1;
    row.loop_fps = 190.0;
    row.rays = 41860;
    row.mrays_per_s = 10.0;
    Table table{.machine = {},
                .scene = std::move(scene),
                .threads = 2,
                .isa = "scalar",
                .surface = "egl-pbuffer",
                .gl_description = "OpenGL ES 3.2 | llvmpipe",
                .rows = {row, row}};
    table.rows[1].depth = 7;
    return table;
}

TEST(BenchReport, the_paper_is_beside_the_cells_it_has) {
    const Table table = small_table();
    const auto cell = paper_for(table, table.rows[0]);
    ASSERT_TRUE(cell.has_value());
    EXPECT_EQ(cell->render_ms, 41.86);
    EXPECT_FALSE(paper_for(table, table.rows[1]).has_value());
    EXPECT_FALSE(paper_for(small_table("other.sdl"), table.rows[0]).has_value());
}

TEST(BenchReport, every_ratio_says_how_many_times_better_than_the_paper) {
    const Table table = small_table();
    const PaperCell cell = *paper_for(table, table.rows[0]);
    const std::vector<double> want = {10.0, 2.0, 10.0, 10.0, 10.0};
    ASSERT_EQ(quantities().size(), want.size());
    for (size_t i = 0; i < want.size(); ++i) {
        EXPECT_NEAR(ratio(quantities()[i], table.rows[0], cell), want[i], 1e-9) << quantities()[i].name;
    }
}

TEST(BenchReport, the_papers_time_to_image_is_the_sum_of_its_parts) {
    for (const uint32_t size : {128u, 256u, 512u}) {
        for (const uint32_t depth : {1u, 2u}) {
            const PaperCell cell = paper_cell(size, size, depth).value();
            EXPECT_NEAR(cell.time_to_image_ms, cell.render_ms + cell.upload_ms + cell.gl_ms, 0.011) << size << depth;
        }
    }
}

TEST(BenchReport, the_text_has_the_papers_rows_and_its_figures) {
    const std::string text = to_text(small_table());
    for (const char *part : {"Render, ms", "Texture upload, ms", "OpenGL render, ms", "Time to image, ms", "FPS",
                             "41.86", "10.00x", "128x128", "egl-pbuffer"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in\n" << text;
    }
}

TEST(BenchReport, another_scene_is_not_compared_with_the_paper) {
    EXPECT_EQ(to_text(small_table("other.sdl")).find("41.86"), std::string::npos);
    EXPECT_EQ(to_markdown(small_table("other.sdl")).find("41.86"), std::string::npos);
}

TEST(BenchReport, the_csv_has_as_many_fields_as_names_on_every_line) {
    const std::string text = to_csv(small_table("a \"b\", c.sdl"));
    EXPECT_NE(text.find("\"a \"\"b\"\", c.sdl\",128,128,1,2,scalar,egl-pbuffer,50,"), std::string::npos) << text;
    const std::string plain = to_csv(small_table());
    std::vector<long> commas;
    for (size_t start = 0; start < plain.size(); start = plain.find('\n', start) + 1) {
        const auto line = plain.substr(start, plain.find('\n', start) - start);
        commas.push_back(std::count(line.begin(), line.end(), ','));
    }
    EXPECT_EQ(commas, std::vector<long>(3, commas.front()));
}

TEST(BenchReport, every_markdown_line_of_the_table_has_the_same_cells) {
    const std::string text = to_markdown(small_table());
    const std::string table = text.substr(text.find("\n|") + 1);
    for (size_t start = 0; start < table.size(); start = table.find('\n', start) + 1) {
        const std::string line = table.substr(start, table.find('\n', start) - start);
        EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 4) << line;
    }
}

} // namespace
} // namespace glint::bench
