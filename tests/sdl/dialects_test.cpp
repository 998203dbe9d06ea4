// The table of directives holds together.
#include "sdl/dialects.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

const DirectiveForm &form(std::string_view usage) {
    for (const DirectiveForm &candidate : directive_forms()) {
        if (candidate.usage == usage) return candidate;
    }
    throw std::runtime_error("no such form: " + std::string(usage));
}

Line line_of(std::string_view text) {
    Line line;
    Lexer(text).next(line);
    return line;
}

TEST(DialectTable, spells_keywords_in_lower_case_and_keeps_a_keywords_forms_together) {
    std::set<std::string_view> finished;
    std::string_view current;
    for (const DirectiveForm &row : directive_forms()) {
        for (const char c : row.keyword()) EXPECT_FALSE(c >= 'A' && c <= 'Z') << row.usage;
        if (row.keyword() != current) {
            EXPECT_TRUE(finished.insert(row.keyword()).second) << row.usage << " stands apart from its other forms";
            current = row.keyword();
        }
    }
}

TEST(DialectTable, takes_no_line_as_evidence_for_a_dialect_that_does_not_have_it) {
    for (const DirectiveForm &row : directive_forms()) {
        EXPECT_EQ(row.evidence & row.dialects, row.evidence) << row.usage;
        EXPECT_FALSE(row.dialects.empty()) << row.usage;
    }
}

TEST(DialectTable, has_no_two_forms_that_one_dialect_could_not_tell_apart) {
    for (const DirectiveForm &one : directive_forms()) {
        for (const DirectiveForm &other : directive_forms()) {
            if (&one == &other || one.keyword() != other.keyword() || (one.dialects & other.dialects).empty()) continue;
            const bool counts_differ =
                one.most_arguments() < other.least_arguments() || other.most_arguments() < one.least_arguments();
            EXPECT_TRUE(counts_differ || one.is_path(0) != other.is_path(0)) << one.usage << " and " << other.usage;
        }
    }
}

TEST(DialectTable, has_all_that_mobile2013_needs) {
    for (const char *usage :
         {"eye x y z", "size w h", "ortho x0 y0 x1 y1", "background r g b", "ambient Ia", "max_depth n",
          "light file.obj r g b I", "object file.obj r g b ka kd ks ke kr kt", "output file", "dialect name"}) {
        EXPECT_TRUE(form(usage).dialects.has(Dialect::mobile2013)) << usage;
        EXPECT_NE(form(usage).handler, nullptr) << usage;
    }
}

TEST(DialectTable, leaves_no_row_without_a_handler) {
    for (const DirectiveForm &row : directive_forms()) EXPECT_NE(row.handler, nullptr) << row.usage;
}

TEST(DialectTable, gives_every_dialect_a_light_an_object_and_a_depth) {
    for (size_t i = 0; i < dialect_count; ++i) {
        const auto dialect = static_cast<Dialect>(i);
        bool light = false, object = false, depth = false;
        for (const DirectiveForm &row : directive_forms()) {
            if (!row.dialects.has(dialect)) continue;
            light = light || row.role == DirectiveForm::Role::light;
            object = object || row.role == DirectiveForm::Role::object;
            depth = depth || row.argument(0) == "n";
        }
        EXPECT_TRUE(light && object && depth) << dialect_name(dialect);
    }
}

TEST(DialectTable, lets_only_the_paper_s_and_our_own_dialect_mirror_instead_of_adding) {
    EXPECT_FALSE(adds_reflections(Dialect::mobile2013));
    EXPECT_FALSE(adds_reflections(Dialect::glint));
    EXPECT_TRUE(adds_reflections(Dialect::ray2005));
    EXPECT_TRUE(adds_reflections(Dialect::path2005));
    EXPECT_TRUE(adds_reflections(Dialect::cg_path_tracer));
    EXPECT_TRUE(adds_reflections(Dialect::raycife));
}

TEST(DialectTable, names_every_dialect_once) {
    for (size_t i = 0; i < dialect_count; ++i) {
        const auto dialect = static_cast<Dialect>(i);
        EXPECT_EQ(dialect_named(dialect_name(dialect)), dialect);
        EXPECT_EQ(DialectSet(dialect).only(), dialect);
    }
    EXPECT_EQ(dialect_named("Mobile2013"), std::nullopt);
    EXPECT_EQ(DialectSet::all().only(), std::nullopt);
    EXPECT_EQ((DialectSet(Dialect::path2005) | Dialect::mobile2013).names(), "mobile2013 or path2005");
    EXPECT_EQ((DialectSet(Dialect::path2005) | Dialect::raycife).without(Dialect::raycife).only(), Dialect::path2005);
}

TEST(DirectiveForms, find_their_lines_by_count_and_first_argument) {
    const DirectiveForm &object = form("object file.obj r g b ka kd ks kt n [ior]");
    EXPECT_EQ(object.least_arguments(), 9u);
    EXPECT_EQ(object.most_arguments(), 10u);
    EXPECT_EQ(object.argument(4), "ka");
    EXPECT_TRUE(object.fits(line_of("object a.obj 1 1 1 1 1 1 1 1")));
    EXPECT_TRUE(object.fits(line_of("object a.obj 1 1 1 1 1 1 1 1 1")));
    EXPECT_FALSE(object.fits(line_of("object a.obj 1 1 1 1 1 1 1")));
    EXPECT_FALSE(object.fits(line_of("object 1 1 1 1 1 1 1 1 1"))) << "no path";
    EXPECT_FALSE(object.starts_like(line_of("object 1")));
    EXPECT_TRUE(object.starts_like(line_of("object a.obj")));
    EXPECT_TRUE(object.starts_like(line_of("object")));
    const DirectiveForm &point_light = form("light x y z I");
    EXPECT_TRUE(point_light.fits(line_of("light 0 0 0 1")));
    EXPECT_FALSE(point_light.fits(line_of("light a.obj 1 1 1"))) << "a mesh light that lacks its intensity";
}

TEST(DirectiveForms, know_words_that_stand_for_themselves) {
    const DirectiveForm &light = form("light_point x y z r g b I ['falloff'] [on/off]");
    EXPECT_EQ(light.least_arguments(), 7u);
    EXPECT_TRUE(light.fits(line_of("light_point 0 0 0 1 1 1 1")));
    EXPECT_TRUE(light.fits(line_of("light_point 0 0 0 1 1 1 1 falloff on")));
    EXPECT_FALSE(light.fits(line_of("light_point 0 0 0 1 1 1 1 fallof on")));
    EXPECT_TRUE(form("samples n [pattern]").fits(line_of("samples 4 anything")));
    EXPECT_TRUE(form("fresnel on/off").fits(line_of("fresnel on")));
    EXPECT_TRUE(form("dialect name").fits(line_of("dialect x")));
}

TEST(DirectiveForms, are_found_by_keyword_in_any_case) {
    EXPECT_EQ(forms_of("EyE").size(), 1u);
    EXPECT_EQ(forms_of("light").size(), 3u);
    EXPECT_EQ(forms_of("object").size(), 6u);
    EXPECT_TRUE(forms_of("sphere").empty());
    EXPECT_TRUE(forms_of(std::string(1000, 'e')).empty());
}

} // namespace
} // namespace glint::test
