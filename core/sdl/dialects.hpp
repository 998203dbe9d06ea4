// The SDL dialects, and the table of every directive that any of them has.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sdl/lexer.hpp"

namespace glint {

/// The members of the SDL family, each named after where it was first seen; `glint` is what `glint convert` writes.
enum class Dialect : uint8_t { mobile2013, path2005, ray2005, cg_path_tracer, raycife, glint };

inline constexpr size_t dialect_count = 6;

/// As written behind the `dialect` directive.
[[nodiscard]] std::string_view dialect_name(Dialect dialect);
[[nodiscard]] std::optional<Dialect> dialect_named(std::string_view name);
/// Whether mirrored and transmitted light is added to a surface's own, or takes the place of its share of it.
[[nodiscard]] bool adds_reflections(Dialect dialect);

/// Some of the dialects.
class DialectSet {
public:
    constexpr DialectSet() = default;
    constexpr DialectSet(Dialect dialect) : bits_(static_cast<uint8_t>(1u << static_cast<unsigned>(dialect))) {}

    [[nodiscard]] static constexpr DialectSet all() { return from_bits((1u << dialect_count) - 1); }

    [[nodiscard]] constexpr bool has(Dialect dialect) const { return (bits_ & DialectSet(dialect).bits_) != 0; }
    [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
    [[nodiscard]] constexpr DialectSet without(DialectSet others) const { return from_bits(bits_ & ~others.bits_); }
    /// The only member, where there is just one.
    [[nodiscard]] std::optional<Dialect> only() const;
    /// "mobile2013, path2005 or raycife".
    [[nodiscard]] std::string names() const;

    friend constexpr DialectSet operator|(DialectSet a, DialectSet b) { return from_bits(unsigned{a.bits_} | b.bits_); }
    friend constexpr DialectSet operator&(DialectSet a, DialectSet b) { return from_bits(unsigned{a.bits_} & b.bits_); }
    friend constexpr bool operator==(DialectSet a, DialectSet b) = default;

private:
    static constexpr DialectSet from_bits(unsigned bits) {
        DialectSet set;
        set.bits_ = static_cast<uint8_t>(bits);
        return set;
    }

    uint8_t bits_ = 0;
};

class Arguments;
struct SceneDraft;

/// What a directive does: reads its arguments and adds to the draft. Faults are reported through the arguments.
using DirectiveHandler = void (*)(const Arguments &arguments, SceneDraft &draft);

/// A row of the table: one form of a directive, in some dialects.
class DirectiveForm {
public:
    /// Settings stand once in a file; lights and objects as often as wanted, and at least once; steps of motions as
    /// often as wanted.
    enum class Role { setting, light, object, motion };

    /// A keyword and 25 arguments would do for the longest form.
    static constexpr size_t most_words = 28;

    /// `usage` is the keyword, then one word for each argument; an argument in [brackets] may be missing. The words
    /// name the arguments in messages. "file" and "file.obj" stand for paths, a word in 'quotes' for itself.
    constexpr DirectiveForm(std::string_view usage_, DialectSet dialects_, DialectSet evidence_,
                            DirectiveHandler handler_, Role role_ = Role::setting)
        : usage(usage_), dialects(dialects_), evidence(evidence_), handler(handler_), role(role_) {
        std::string_view rest = usage;
        while (!rest.empty()) {
            const size_t end = rest.find(' ') < rest.size() ? rest.find(' ') : rest.size();
            words_[word_count_++] = {static_cast<uint8_t>(usage.size() - rest.size()), static_cast<uint8_t>(end)};
            rest.remove_prefix(end < rest.size() ? end + 1 : end);
        }
    }

    std::string_view usage;
    DialectSet dialects; ///< that have the form
    DialectSet evidence; ///< that a file with such a line belongs to; empty where the line says nothing about it
    DirectiveHandler handler;
    Role role;

    [[nodiscard]] constexpr std::string_view keyword() const { return word(0); }
    [[nodiscard]] constexpr size_t most_arguments() const { return word_count_ - 1; }
    [[nodiscard]] size_t least_arguments() const;
    /// The name of argument i, from 0; without brackets where it may be missing.
    [[nodiscard]] constexpr std::string_view argument(size_t i) const {
        const std::string_view name = word(i + 1);
        return is_optional(i) ? name.substr(1, name.size() - 2) : name;
    }
    [[nodiscard]] constexpr bool is_optional(size_t i) const { return word(i + 1).starts_with('['); }
    [[nodiscard]] bool is_path(size_t i) const { return argument(i) == "file" || argument(i) == "file.obj"; }

    /// Whether the line's first argument is a path where the form has one, and a number where it has none.
    [[nodiscard]] bool starts_like(const Line &line) const;
    /// Whether the words that stand for themselves are in their places, but for those that may be missing.
    [[nodiscard]] bool has_words_of(const Line &line) const;
    /// Whether the line has this form: the count of arguments, how they start, words that stand for themselves.
    [[nodiscard]] bool fits(const Line &line) const;

private:
    [[nodiscard]] constexpr std::string_view word(size_t i) const {
        return usage.substr(words_[i].begin, words_[i].size);
    }

    /// Within the usage, which is no longer than a byte counts. (Two pointers a word would make the table, with what
    /// the loader must know of pointers, 40 KB of a library for phones.)
    struct Word {
        uint8_t begin = 0, size = 0;
    };
    std::array<Word, most_words> words_{};
    uint8_t word_count_ = 0;
};

/// The table, forms of one keyword side by side.
[[nodiscard]] std::span<const DirectiveForm> directive_forms();

/// The forms that begin with the keyword, in any case of letters; none where it is not known.
[[nodiscard]] std::span<const DirectiveForm> forms_of(std::string_view keyword);

} // namespace glint
