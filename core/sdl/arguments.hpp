// The arguments of one directive, handed to its handler with checks and places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <glint/scene.hpp>

#include "sdl/dialects.hpp"
#include "sdl/lexer.hpp"
#include "text/problems.hpp"

namespace glint {

/// The arguments of a line that has the form's count of them; they count from 0. Each reading function reports what is
/// wrong, with its place, and then returns something that no later comparison will complain about.
class Arguments {
public:
    Arguments(const Line &line, const DirectiveForm &form, Problems &problems)
        : line_(line), form_(form), problems_(problems) {}

    [[nodiscard]] size_t count() const { return static_cast<size_t>(line_.argument_count); }
    [[nodiscard]] std::string_view word(size_t i) const { return token(i).text; }
    /// A number from `lowest` to `highest`; NaN where there is none.
    [[nodiscard]] float number(size_t i, float lowest, float highest) const;
    /// Three numbers from i on.
    [[nodiscard]] glm::vec3 numbers(size_t i, float lowest, float highest) const;
    /// A place in the world: three coordinates from i on.
    [[nodiscard]] Point point(size_t i) const { return numbers(i, -max_coordinate, max_coordinate); }
    /// A whole number; `otherwise` where there is none.
    [[nodiscard]] uint64_t whole_number(size_t i, uint64_t otherwise) const;
    /// A whole number from `lowest` to `highest`; `lowest` where there is none.
    [[nodiscard]] uint64_t whole_number_in(size_t i, uint64_t lowest, uint64_t highest) const;
    /// Whether the word is "on", in any case of letters; anything but "on" and "off" is an error.
    [[nodiscard]] bool on_or_off(size_t i) const;

    [[nodiscard]] Place place(size_t i) const { return line_.place(token(i)); }
    [[nodiscard]] Place keyword_place() const { return line_.place(line_.tokens[0]); }
    void error(size_t i, std::string message, std::string hint = {}, ErrorCode code = ErrorCode::bad_input) const {
        problems_.error(place(i), std::move(message), std::move(hint), code);
    }
    [[nodiscard]] Problems &problems() const { return problems_; }

private:
    [[nodiscard]] const Token &token(size_t i) const { return line_.tokens[i + 1]; }

    const Line &line_;
    const DirectiveForm &form_;
    Problems &problems_;
};

} // namespace glint
