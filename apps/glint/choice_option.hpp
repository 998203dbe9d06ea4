// An option whose value is one of a few words.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace glint::cli {

template <typename Value> using Choices = std::vector<std::pair<std::string, Value>>;

/// Adds an option to `parser`; a word that is none of the choices ends the parse with a message that names them.
/// `target` must live as long as the parser.
template <typename Value> CLI::Option *add_choice(CLI::App &parser, const std::string &flag, Value &target,
                                                  const Choices<Value> &choices, const std::string &description) {
    std::string words;
    for (const auto &choice : choices) words += (words.empty() ? "" : "|") + choice.first;
    const auto read = [&target, flag, choices, words](const std::string &text) {
        for (const auto &[word, value] : choices) {
            if (word == text) {
                target = value;
                return;
            }
        }
        throw CLI::ValidationError(flag, "'" + text + "' is not one of " + words);
    };
    return parser.add_option_function<std::string>(flag, read, description)->type_name(words);
}

} // namespace glint::cli
