// Every file of tests/sdl/bad is refused, in the very words that are written beside it.
#include "sdl/bad_corpus.hpp"

#include <set>

#include <gtest/gtest.h>

#include "sdl/dialects.hpp"

namespace glint::test {
namespace {

class BadFiles : public testing::TestWithParam<std::string> {};

TEST_P(BadFiles, are_refused_in_the_words_beside_them) {
    const auto messages = bad_messages(GetParam());
    std::set<std::string> names;
    for (const std::string &name : bad_files(GetParam())) {
        names.insert(name);
        const auto expected = messages.find(name);
        EXPECT_EQ(said_about(GetParam(), name), expected == messages.end() ? "no entry" : expected->second) << name;
    }
    for (const auto &[name, message] : messages)
        EXPECT_TRUE(names.contains(name)) << "an entry without a file: " << name;
}

TEST_P(BadFiles, have_one_fault_each_and_its_place) {
    for (const std::string &name : bad_files(GetParam())) {
        const Error error = error_of_bad_file(GetParam(), name);
        if (GetParam() == "obj") continue; // one fault of a face's line is told of at each of its corners
        ASSERT_EQ(error.diagnostics.size(), 1u) << name << '\n' << error.text();
        const Diagnostic &fault = error.diagnostics[0];
        // What is missing stands nowhere, and a mesh that is wrong as a whole where it is named.
        EXPECT_TRUE(fault.line > 0 || fault.message.starts_with("there is no ") || fault.hint.starts_with("named in "))
            << name << '\n'
            << error.text();
    }
}

INSTANTIATE_TEST_SUITE_P(Of, BadFiles, testing::ValuesIn(bad_folders()), [](const auto &test) { return test.param; });

TEST(BadCorpus, has_three_hundred_files) {
    size_t files = 0;
    for (const std::string &folder : bad_folders()) files += bad_files(folder).size();
    EXPECT_GE(files, 300u);
}

TEST(BadCorpus, counts_the_arguments_of_every_directive_wrongly) {
    std::string counts;
    for (const auto &[name, message] : bad_messages("counts")) counts += message;
    for (const DirectiveForm &form : directive_forms()) {
        EXPECT_NE(counts.find("expected: " + std::string(form.usage)), std::string::npos) << form.usage;
    }
}

} // namespace
} // namespace glint::test
