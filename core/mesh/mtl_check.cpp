// The pass over an MTL file's text that lets tinyobjloader see only what it reads rightly.
#include "mesh/mtl_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include <glint/scene.hpp>

#include "mesh/left_out.hpp"
#include "mesh/map_options.hpp"
#include "mesh/obj_lines.hpp"
#include "mesh/obj_words.hpp"
#include "text/number.hpp"
#include "text/shortest.hpp"
#include "text/suggest.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// A statement with numbers.
struct Statement {
    std::string_view keyword;
    size_t count;
    float lowest, highest;
    /// Of one that is not read: the value that changes nothing, so that nobody has to hear that it is left out.
    std::optional<float> neutral = std::nullopt;
};

constexpr float any = max_intensity;

constexpr Statement statements[] = {
    {"Kd", 3, 0.0f, 1.0f},         {"Ks", 3, 0.0f, 1.0f}, {"Ns", 1, 0.0f, max_intensity},
    {"Ni", 1, 0.0f, greatest_ior}, // what lets nothing through needs none, and some files say 0 then
    {"d", 1, 0.0f, 1.0f},          {"Tr", 1, 0.0f, 1.0f}, {"Ke", 3, 0.0f, any, 0.0f},
    {"Tf", 3, 0.0f, any, 1.0f},
};

/// What the format has and a Material has not.
constexpr std::array<std::string_view, 28> unread_keywords = {
    "Km",       "Kt",       "map_Ka", "map_Ks", "map_Ns", "map_d",  "map_Tr", "map_Bump", "map_bump", "map_Disp",
    "map_disp", "map_Refl", "map_Ke", "map_Pr", "map_Pm", "map_Ps", "bump",   "disp",     "decal",    "refl",
    "norm",     "Pr",       "Pm",     "Ps",     "Pc",     "Pcr",    "aniso",  "anisor"};

/// What has no say in the picture here: Kd stands for the ambient colour too, and `illum` chooses among other programs'
/// shading models.
constexpr std::array<std::string_view, 4> quiet_keywords = {"Ka", "illum", "sharpness", "map_aat"};

constexpr std::array<std::string_view, 9> obj_keywords = {"v", "vn", "vt", "f", "g", "o", "s", "usemtl", "mtllib"};

template <size_t count> bool is_among(const std::array<std::string_view, count> &keywords, std::string_view word) {
    return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

class MtlChecker {
public:
    MtlChecker(std::span<char> text, Problems &problems) : lines_(text), problems_(problems) {}

    std::vector<MtlEntry> run() {
        while (!is_other_file_ && lines_.next()) check_line();
        finish_material();
        tell_of_left_out();
        if (materials_.empty() && problems_.ok()) problems_.warn({}, "the library has no material ('newmtl')");
        return std::move(materials_);
    }

private:
    /// A statement of the current material that was read.
    struct Given {
        uint32_t line;
        KeptPlace place; ///< of its first number; none where it has no number
        float value;     ///< its first number
    };

    void check_line() {
        char *const begin = skip_blanks(lines_.begin(), lines_.end());
        if (begin == lines_.end() || *begin == '#') return;
        lines_.join();
        const Word keyword = word_at(begin, lines_.end());
        if (keyword.text() == "newmtl") return begin_material(keyword);
        if (is_among(obj_keywords, keyword.text())) {
            error(begin, words(in_quotes(keyword.text()), " is a line of an OBJ file, expected a material library"),
                  "mtllib names files that begin their materials with 'newmtl'");
            is_other_file_ = true;
            return;
        }
        const bool is_kept = keyword.text() == "map_Kd" ? check_texture(keyword) : check_numbers(keyword);
        if (!is_kept) *keyword.begin = '#';
    }

    void error(const char *at, std::string message, std::string hint = {}) {
        problems_.error(lines_.place(at), std::move(message), std::move(hint));
    }

    void begin_material(const Word &keyword) {
        finish_material();
        const Word name = rest_of_line(keyword.end, lines_.end());
        if (name.text().empty() || !is_blank(*keyword.end)) error(keyword.begin, "'newmtl' takes a name");
        const auto [entry, is_new] = names_.try_emplace(std::string(name.text()), lines_.place(name.begin).line);
        if (!is_new) {
            error(name.begin,
                  words("the material ", in_quotes(name.text()), " was defined already, on line ", entry->second));
        }
        MtlEntry material;
        material.name = entry->first;
        materials_.push_back(std::move(material));
    }

    /// Statements that say one thing together.
    void finish_material() {
        const auto given = [&](std::string_view keyword) -> const Given * {
            const auto found = given_.find(keyword);
            const bool has_number = found != given_.end() && found->second.place.line > 0;
            return has_number ? &found->second : nullptr;
        };
        const Given *const dissolve = given("d"), *const transparency = given("Tr"), *const ior = given("Ni");
        // Exporters round both; a difference that shows is another matter.
        constexpr float rounding = 6e-3f;
        if (dissolve && transparency && !(std::abs(dissolve->value + transparency->value - 1.0f) <= rounding)) {
            const Given &later = dissolve->line > transparency->line ? *dissolve : *transparency;
            problems_.error(later.place.place(),
                            words("d ", shortest(dissolve->value), " and Tr ", shortest(transparency->value),
                                  " contradict each other"),
                            "Tr is 1 - d; leave one of them away");
        }
        const bool is_clear = dissolve ? dissolve->value < 1.0f : transparency != nullptr && transparency->value > 0.0f;
        if (ior && ior->value < least_ior && is_clear) {
            problems_.error(ior->place.place(), words("Ni is ", shortest(ior->value), ", expected a number from ",
                                                      shortest(least_ior), " to ", shortest(greatest_ior)));
        }
        given_.clear();
    }

    /// Whether the line is the first of its kind in a material.
    bool belongs_to_material(const Word &keyword) {
        if (materials_.empty()) {
            error(keyword.begin, words(in_quotes(keyword.text()), " comes before the first 'newmtl'"));
            return false;
        }
        const auto [entry, is_new] =
            given_.try_emplace(std::string(keyword.text()), Given{lines_.place(keyword.begin).line, {}, 0.0f});
        if (!is_new) {
            error(keyword.begin, words(in_quotes(keyword.text()), " was given already, on line ", entry->second.line));
        }
        return is_new;
    }

    /// Returns whether tinyobjloader is to read the line.
    bool check_numbers(const Word &keyword) {
        const auto *const statement = std::find_if(std::begin(statements), std::end(statements),
                                                   [&](const auto &s) { return s.keyword == keyword.text(); });
        if (statement == std::end(statements)) return skip(keyword), false;
        if (!belongs_to_material(keyword)) return false;

        const char *const end = lines_.end();
        char *at = skip_blanks(keyword.end, end);
        if (const std::string_view form = word_at(at, end).text(); form == "spectral" || form == "xyz") {
            if (statement->neutral) return skip_unread(keyword), false;
            error(at, words(keyword.text(), " is given as ", in_quotes(form), ", expected red, green and blue"));
            return false;
        }
        size_t count = 0;
        bool is_neutral = true;
        for (; at != end && *at != '#'; at = skip_blanks(at, end)) {
            const Word word = word_at(at, end);
            at = word.end;
            if (++count > statement->count) continue;
            const float value = check_number(word, *statement);
            is_neutral = is_neutral && value == statement->neutral;
            if (count == 1) {
                Given &given = given_.find(keyword.text())->second;
                given.place = KeptPlace(lines_.place(word.begin));
                given.value = value;
            }
        }
        std::fill(at, lines_.end(), ' ');
        if (count != statement->count) {
            error(keyword.begin,
                  words(in_quotes(keyword.text()), " takes ", counted(statement->count, "number"), ", found ", count));
        }
        if (keyword.text() == "Kd") materials_.back().has_color = true;
        if (statement->neutral && !is_neutral) skip_unread(keyword);
        return !statement->neutral;
    }

    float check_number(const Word &word, const Statement &statement) {
        float value = 0.0f;
        if (auto fault = read_number(word.text(), value)) {
            error(word.begin, std::move(fault->message), std::move(fault->hint));
        } else if (!(value >= statement.lowest && value <= statement.highest)) {
            error(word.begin, words(statement.keyword, " is ", in_quotes(word.text()), ", expected a number from ",
                                    shortest(statement.lowest), " to ", shortest(statement.highest)));
        } else {
            write_shortest(word, value);
        }
        return value;
    }

    bool check_texture(const Word &keyword) {
        if (!belongs_to_material(keyword)) return false;
        char *const options_begin = keyword.end;
        char *const name_begin = check_map_options(options_begin, lines_, problems_);
        if (!name_begin) return false;
        std::fill(options_begin, name_begin, ' ');
        const Word name = rest_of_line(name_begin, lines_.end());
        if (name.text().empty() || !is_blank(*keyword.end)) {
            error(keyword.begin, "'map_Kd' takes the name of an image file");
            return false;
        }
        materials_.back().texture = KeptPlace(lines_.place(name.begin));
        return true;
    }

    void skip_unread(const Word &keyword) { unread_.add(lines_.place(keyword.begin), keyword.text()); }

    void skip(const Word &keyword) {
        if (is_among(quiet_keywords, keyword.text())) return;
        if (is_among(unread_keywords, keyword.text())) return skip_unread(keyword);
        unknown_.add(lines_.place(keyword.begin), keyword.text());
    }

    void tell_of_left_out() {
        if (unread_.lines > 0) {
            problems_.warn(unread_.first.place(),
                           words(counted(unread_.lines, "line"), " of materials' properties that Glint does not have (",
                                 in_quotes(unread_.keyword), " first)"));
        }
        if (unknown_.lines == 0) return;
        std::vector<std::string_view> known = {"newmtl", "map_Kd"};
        for (const Statement &statement : statements) known.push_back(statement.keyword);
        const auto nearest = nearest_word(unknown_.keyword, known);
        problems_.warn(unknown_.first.place(),
                       words(counted(unknown_.lines, "line"), " of a kind that is not read (",
                             in_quotes(unknown_.keyword), " first)"),
                       nearest ? words("did you mean '", *nearest, "'?") : std::string());
    }

    ObjLines lines_;
    Problems &problems_;
    std::vector<MtlEntry> materials_;
    std::map<std::string, uint32_t> names_;           ///< of all materials, with their lines
    std::map<std::string, Given, std::less<>> given_; ///< statements of the current material
    LeftOut unread_, unknown_;
    bool is_other_file_ = false;
};

} // namespace

std::vector<MtlEntry> check_mtl(std::span<char> text, Problems &problems) {
    return MtlChecker(text, problems).run();
}

} // namespace glint
