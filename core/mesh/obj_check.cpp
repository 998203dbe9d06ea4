// The pass over an OBJ file's text that lets tinyobjloader see only what it reads rightly.
#include "mesh/obj_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <glint/scene.hpp>

#include "mesh/left_out.hpp"
#include "mesh/obj_lines.hpp"
#include "mesh/obj_words.hpp"
#include "text/number.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// Keywords of the format that say nothing about the surface: names, materials, smoothing, levels of detail.
constexpr std::array<std::string_view, 15> quiet_keywords = {
    "g",     "o",        "s",        "mg",  "usemtl",     "mtllib",    "usemap", "maplib",
    "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "call"};

/// From here on a decimal exponent, or a token's length, is beyond what tinyobjloader computes with.
constexpr int far_exponent = 300;

class ObjChecker {
public:
    ObjChecker(std::span<char> text, Problems &problems, ObjNames *names)
        : text_(text), problems_(problems), names_(names) {}

    ObjCounts run() {
        count_elements();
        ObjLines lines(text_);
        while (lines.next()) check_line(lines);
        tell_of_left_out();
        counts_.vertices = so_far_.vertices;
        counts_.texcoords = so_far_.texcoords;
        counts_.normals = so_far_.normals;
        return counts_;
    }

private:
    /// A face may name a vertex that only comes later, so the totals are needed before the first face is checked.
    void count_elements() {
        ObjLines lines(text_);
        while (lines.next()) {
            const char *at = skip_blanks(lines.begin(), lines.end());
            if (lines.end() - at < 2 || *at != 'v') continue;
            if (is_blank(at[1])) {
                ++counts_.vertices;
            } else if (lines.end() - at > 2 && is_blank(at[2])) {
                if (at[1] == 't') ++counts_.texcoords;
                if (at[1] == 'n') ++counts_.normals;
            }
        }
    }

    void check_line(ObjLines &lines) {
        char *const keyword_begin = skip_blanks(lines.begin(), lines.end());
        if (keyword_begin == lines.end() || *keyword_begin == '#') return;
        lines.join();
        lines_ = &lines;
        const Word keyword = word_at(keyword_begin, lines.end());
        if (keyword.text() == "v") {
            check_numbers(
                keyword, true, [](uint64_t n) { return n == 3 || n == 4 || n == 6 || n == 7; },
                "3 coordinates, and perhaps a weight and a colour (4, 6 or 7 numbers in all)");
            ++so_far_.vertices;
        } else if (keyword.text() == "f") {
            check_face(keyword);
        } else if (check_other(keyword)) {
            *keyword.begin = '#';
        }
    }

    /// Checks a line that says nothing about the shape. True where tinyobjloader is not to see it.
    bool check_other(const Word &keyword) {
        const std::string_view name = keyword.text();
        if (name == "vn") {
            check_numbers(
                keyword, names_ != nullptr, [](uint64_t n) { return n == 3; }, "3 numbers");
            ++so_far_.normals;
            return names_ == nullptr;
        }
        if (name == "vt") {
            check_numbers(
                keyword, names_ != nullptr, [](uint64_t n) { return n >= 1 && n <= 3; }, "1 to 3 numbers");
            ++so_far_.texcoords;
            return names_ == nullptr;
        }
        if (names_ && (name == "usemtl" || name == "mtllib")) return take_name(keyword), name == "mtllib";
        if (name == "l" || name == "p") {
            lines_and_points_.add(lines_->place(keyword.begin), name);
        } else if (std::find(quiet_keywords.begin(), quiet_keywords.end(), name) == quiet_keywords.end()) {
            unknown_.add(lines_->place(keyword.begin), name);
        }
        return true;
    }

    /// Remembers what `usemtl` or `mtllib` names.
    void take_name(const Word &keyword) {
        const Word name = rest_of_line(keyword.end, lines_->end());
        const bool is_library = keyword.text() == "mtllib";
        if (name.text().empty() || !is_blank(*keyword.end)) {
            return error(keyword.begin, words(in_quotes(keyword.text()), " takes the name of a ",
                                              is_library ? "material library" : "material"));
        }
        const Place place = lines_->place(name.begin);
        if (is_library) {
            names_->libraries.push_back({std::string(name.text()), KeptPlace(place)});
        } else if (auto [entry, is_new] = names_->materials.try_emplace(std::string(name.text())); is_new) {
            entry->second = KeptPlace(place);
        }
    }

    void error(const char *at, std::string message, std::string hint = {}, ErrorCode code = ErrorCode::bad_input) {
        problems_.error(lines_->place(at), std::move(message), std::move(hint), code);
    }

    void blank_comment(char *at) { std::fill(at, lines_->end(), ' '); }

    template <typename IsRightCount>
    void check_numbers(const Word &keyword, bool coordinates, IsRightCount is_right_count, std::string_view wanted) {
        const char *const end = lines_->end();
        char *at = skip_blanks(keyword.end, end);
        uint64_t count = 0;
        for (; at != end && *at != '#'; at = skip_blanks(at, end)) {
            const NumberShape shape = scan_number(at, end);
            const Word word = {at,
                               shape.valid && ends_word(shape.end, end) ? at + (shape.end - at) : word_at(at, end).end};
            const bool plain = shape.valid && word.end == shape.end && shape.magnitude <= 12 &&
                               shape.exponent > -far_exponent && word.end - word.begin < far_exponent;
            if (!plain) check_odd_number(word, coordinates && count < 3);
            if (word.end != end && *word.end == '#' &&
                is_hash_of_a_number(word.text(), {word.end + 1, static_cast<size_t>(end - word.end - 1)})) {
                return error(word.begin, words(in_quotes({word.begin, static_cast<size_t>(end - word.begin)}),
                                               " is not a finite number"));
            }
            ++count;
            at = word.end;
        }
        if (!is_right_count(count)) {
            error(keyword.begin, words(in_quotes(keyword.text()), " takes ", wanted, ", found ", count));
        }
        blank_comment(at);
    }

    /// A number that is wrong, large, or written so that tinyobjloader would lose it: the last kind is written anew.
    void check_odd_number(const Word &word, bool coordinate) {
        if (problems_.full()) return error(word.begin, {});
        float value = 0.0f;
        if (auto fault = read_number(word.text(), value)) {
            return error(word.begin, std::move(fault->message), std::move(fault->hint));
        }
        if (coordinate && !(std::abs(value) <= max_coordinate)) {
            return error(word.begin, words(in_quotes(word.text()), " is too far out"),
                         "coordinates reach from -1e12 to 1e12");
        }
        write_shortest(word, value);
    }

    void check_face(const Word &keyword) {
        const char *const end = lines_->end();
        char *at = skip_blanks(keyword.end, end);
        uint64_t corners = 0;
        for (; at != end && *at != '#'; at = skip_blanks(at, end)) {
            at = check_corner(at, end);
            ++corners;
        }
        if (corners < 3) {
            return error(keyword.begin, words("a face needs at least 3 corners, found ", corners));
        }
        blank_comment(at);
        if (corners > max_face_corners) {
            error(keyword.begin, words("the face has ", corners, " corners, the limit is ", max_face_corners), {},
                  ErrorCode::limit_exceeded);
        }
        ++counts_.faces;
        counts_.triangles += corners - 2;
    }

    /// Checks `v`, `v/vt`, `v//vn` or `v/vt/vn`, returns its end. Nothing behind a slash means that there is none.
    char *check_corner(char *begin, const char *end) {
        char *at = begin;
        if (!check_index(at, end, counts_.vertices, so_far_.vertices, "vertex", "vertices")) {
            return corner_error(begin, end);
        }
        if (at != end && *at == '/') {
            ++at;
            if (!is_part_end(at, end) && !check_index(at, end, counts_.texcoords, so_far_.texcoords,
                                                      "texture coordinate", "texture coordinates")) {
                return corner_error(begin, end);
            }
            if (at != end && *at == '/') {
                ++at;
                if (!is_part_end(at, end) &&
                    !check_index(at, end, counts_.normals, so_far_.normals, "normal", "normals")) {
                    return corner_error(begin, end);
                }
            }
        }
        if (!ends_word(at, end)) return corner_error(begin, end);
        // tinyobjloader would take the next corner's number for what is missing behind a last slash.
        for (char *last = at; names_ && last[-1] == '/'; --last) last[-1] = ' ';
        return at;
    }

    static bool is_part_end(const char *at, const char *end) { return ends_word(at, end) || *at == '/'; }

    char *corner_error(char *begin, const char *end) {
        const Word word = word_at(begin, end);
        if (problems_.full()) return error(begin, {}), word.end;
        error(begin, words(in_quotes(word.text()), " is not a face's corner"),
              "expected whole numbers as in 1, 1/2, 1//3 or 1/2/3");
        return word.end;
    }

    /// Walks over a whole number and checks its range. False where there is no whole number.
    bool check_index(char *&at, const char *end, uint64_t total, uint64_t so_far, const char *one, const char *many) {
        const char *const begin = at;
        const bool negative = at != end && *at == '-';
        if (at != end && (*at == '-' || *at == '+')) ++at;
        const char *const digits = at;
        uint64_t index = 0;
        while (at != end && *at >= '0' && *at <= '9') {
            if (index < uint64_t{1} << 40) index = index * 10 + static_cast<uint64_t>(*at - '0');
            ++at;
        }
        if (at == digits || !is_part_end(at, end)) return false;
        if (index >= 1 && index <= (negative ? so_far : total)) return true;
        if (problems_.full()) return error(begin, {}), true;
        const std::string_view digits_shown(begin, std::min<size_t>(size_t(at - begin), 24));
        const std::string found = words(one, ' ', digits_shown, " does not exist: ");
        if (index == 0) {
            error(begin, words(found, "OBJ counts from 1"));
        } else if (negative) {
            error(begin, words(found, so_far, ' ', so_far == 1 ? one : many, so_far == 1 ? " comes" : " come",
                               " before this line"));
        } else {
            error(begin, words(found, "the file has ", total, ' ', total == 1 ? one : many));
        }
        return true;
    }

    void tell_of_left_out() {
        if (lines_and_points_.lines > 0) {
            problems_.warn(lines_and_points_.first.place(),
                           words(counted(lines_and_points_.lines, "line"), " of points or lines (",
                                 in_quotes(lines_and_points_.keyword),
                                 " first): they have no surface and are left out"));
        }
        if (unknown_.lines > 0) {
            problems_.warn(unknown_.first.place(),
                           words(counted(unknown_.lines, "line"), " of a kind that is not read (",
                                 in_quotes(unknown_.keyword), " first)"));
        }
    }

    std::span<char> text_;
    Problems &problems_;
    ObjNames *names_;  ///< nullptr where only the shape is wanted
    ObjCounts counts_; ///< vertices, texture coordinates and normals: of the whole file
    ObjCounts so_far_; ///< before the current line
    ObjLines *lines_ = nullptr;
    LeftOut lines_and_points_;
    LeftOut unknown_;
};

} // namespace

ObjCounts check_obj(std::span<char> text, Problems &problems, ObjNames *names) {
    return ObjChecker(text, problems, names).run();
}

} // namespace glint
