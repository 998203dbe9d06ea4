// An option whose value is one of a few words.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace glint::cli {

template <typename Value> using Choices = std::vector<std::pair<std::string, Value>>;

/// What an option chooses from, for a target that may also stay unset.
template <typename Target> struct ChoiceValue {
    using Type = Target;
};
template <typename Value> struct ChoiceValue<std::optional<Value>> {
    using Type = Value;
};

/// Adds an option to `parser`; a word that is none of the choices ends the parse with a message that names them.
/// `target` must live as long as the parser; it is a Value or a std::optional of one.
template <typename Target, typename Value = typename ChoiceValue<Target>::Type>
CLI::Option *add_choice(CLI::App &parser, const std::string &flag, Target &target,
                        const std::type_identity_t<Choices<Value>> &choices, const std::string &description) {
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
