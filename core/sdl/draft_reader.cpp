// From the lines of an SDL file to what they say together.
#include "sdl/draft_reader.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "sdl/arguments.hpp"
#include "sdl/camera_draft.hpp"
#include "sdl/directives.hpp"
#include "text/number.hpp"
#include "text/suggest.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// Depth of scenes that give none and have something to look through: into a ball behind another, and out again.
constexpr uint32_t depth_of_glass = 5;

bool is_number(std::string_view word) {
    float value = 0.0f;
    return !read_number(word, value);
}

/// The form of another dialect that the line fits, if any.
const DirectiveForm *form_elsewhere(const Line &line) {
    for (const DirectiveForm &form : forms_of(line.tokens[0].text)) {
        if (form.fits(line)) return &form;
    }
    return nullptr;
}

} // namespace

void DraftReader::read(std::string_view text) {
    Lexer lexer(text, &problems_);
    Line line;
    while (lexer.next(line)) read_line(line);
    check_whole();
}

void DraftReader::read_line(const Line &line) {
    const Token &keyword = line.tokens[0];
    const std::span<const DirectiveForm> forms = forms_of(keyword.text);
    if (forms.empty()) return line.has_problem ? void() : tell_unknown(line);
    note_attempt(forms.front());
    if (line.has_problem) return; // told already; what it says cannot be trusted
    const DirectiveForm *const form = choose(forms, line);
    if (!form) {
        DialectSet owners;
        for (const DirectiveForm &other : forms) owners = owners | other.dialects;
        return error_at(line, keyword,
                        words(in_quotes(keyword.text), " is a directive of ", owners.names(),
                              ", and this file is read as ", dialect_name(dialect_.dialect), " (", dialect_.reason,
                              ")"));
    }
    if (line.argument_count < form->least_arguments() || line.argument_count > form->most_arguments()) {
        given_.try_emplace(form->handler, First{line.number, form->keyword()});
        return tell_wrong_count(line, *form);
    }
    const auto [first, is_first] = given_.try_emplace(form->handler, First{line.number, form->keyword()});
    if (!is_first && form->role == DirectiveForm::Role::setting) return tell_twice(line, *form, first->second);
    form->handler(Arguments(line, *form, problems_), draft_);
}

/// Keeps in mind that the line was meant to give what every scene needs: then, whatever else is wrong with it, that
/// is not missing.
void DraftReader::note_attempt(const DirectiveForm &form) {
    has_eye_ = has_eye_ || form.handler == read_eye;
    has_light_ = has_light_ || form.role == DirectiveForm::Role::light;
    has_object_ = has_object_ || form.role == DirectiveForm::Role::object;
}

/// The form of this dialect that the line fits, else the one it comes nearest to: of those that start as the line
/// does, if there are any, the one whose count of arguments is missed least. nullptr where the dialect has none.
const DirectiveForm *DraftReader::choose(std::span<const DirectiveForm> forms, const Line &line) const {
    const DirectiveForm *nearest = nullptr;
    uint64_t least_miss = UINT64_MAX;
    for (const DirectiveForm &form : forms) {
        if (!form.dialects.has(dialect_.dialect)) continue;
        if (form.fits(line)) return &form;
        const uint64_t count = line.argument_count, least = form.least_arguments(), most = form.most_arguments();
        constexpr uint64_t another_start = uint64_t{1} << 40;
        const uint64_t miss = (count < least ? least - count : count - std::min(count, most)) +
                              (form.starts_like(line) ? 0 : another_start) +
                              (form.has_words_of(line) ? 0 : 2 * another_start);
        if (miss >= least_miss) continue;
        least_miss = miss;
        nearest = &form;
    }
    return nearest;
}

void DraftReader::error_at(const Line &line, const Token &token, std::string message, std::string hint) {
    problems_.error(line.place(token), std::move(message), std::move(hint));
}

void DraftReader::tell_unknown(const Line &line) {
    const Token &keyword = line.tokens[0];
    if (problems_.full()) return error_at(line, keyword, {});
    std::vector<std::string_view> known;
    for (const DirectiveForm &form : directive_forms()) {
        if (form.dialects.has(dialect_.dialect)) known.push_back(form.keyword());
    }
    const auto nearest = nearest_word(lower_case(keyword.text.substr(0, 64)), known);
    if (nearest) note_attempt(forms_of(*nearest).front());
    error_at(line, keyword, words("unknown directive ", in_quotes(keyword.text)),
             nearest ? words("did you mean '", *nearest, "'?") : std::string());
}

void DraftReader::tell_twice(const Line &line, const DirectiveForm &form, const First &first) {
    error_at(line, line.tokens[0],
             words(in_quotes(line.tokens[0].text), " was given already, on line ", first.line,
                   first.keyword == form.keyword() ? "" : words(" as ", in_quotes(first.keyword))));
}

void DraftReader::tell_wrong_count(const Line &line, const DirectiveForm &form) {
    const bool too_many = line.argument_count > form.most_arguments();
    const size_t at = too_many ? std::min(form.most_arguments() + 1, line.tokens.size() - 1) : 0;
    std::string hint = words("expected: ", form.usage);
    if (const DirectiveForm *const other = form_elsewhere(line)) {
        hint += words("; as it stands it is a line of ", other->dialects.names(), ": ", other->usage);
    } else if (too_many && form.is_path(0) && form.starts_like(line) && !form.argument(1).starts_with('\'') &&
               !is_number(line.tokens[2].text)) {
        hint += "; file names cannot contain blanks";
    }
    const size_t least = form.least_arguments(), most = form.most_arguments();
    const std::string range = least == most ? "" : words(least, least + 1 == most ? " or " : " to ");
    error_at(line, line.tokens[at],
             words(in_quotes(line.tokens[0].text), " takes ", range, counted(most, "argument"), ", found ",
                   line.argument_count),
             std::move(hint));
}

/// What only the end of the file shows.
void DraftReader::check_whole() {
    const auto missing = [&](const char *keyword) {
        const DirectiveForm *const form = choose(forms_of(keyword), {});
        problems_.error({}, words("there is no '", keyword, "'"),
                        form ? words("expected: ", form->usage) : std::string());
    };
    if (!has_eye_) missing("eye");
    if (!has_light_) missing("light");
    if (!has_object_) missing("object");
    camera_ = camera_of(draft_, problems_);
    check_motion(draft_, problems_);
    apply_settings();
}

/// A scene of a path tracer's needs no depth. The default of one ray would leave its glass dark, since none would come
/// out of it again.
void DraftReader::choose_depth() {
    if (given_.contains(read_max_depth)) return;
    for (const ObjectDraft &entry : draft_.objects) {
        for (const Object &object : entry.parts) {
            if (!(object.material.transmission > 0.0f) || object.material.ior == 1.0f) continue;
            draft_.picture.max_depth = depth_of_glass;
            return problems_.warn({},
                                  words("no depth is given, and the scene has glass: ", depth_of_glass, " is taken"),
                                  "a line 'reflections n' says how deep rays go");
        }
    }
}

/// Settings that stand for every light and object, wherever in the file they are.
void DraftReader::apply_settings() {
    choose_depth();
    const bool adds = draft_.reflection_adds.value_or(adds_reflections(dialect_.dialect));
    draft_.reflection_adds = adds;
    for (ObjectDraft &entry : draft_.objects) {
        for (Object &object : entry.parts) object.material.adds_to_local = adds && !entry.from_mtl;
    }
    for (LightDraft &entry : draft_.lights) {
        Light &light = entry.light;
        if (!light.mesh || light.position) continue; // one place to come from
        light.shadow_rays = draft_.shadow_rays;
        light.grid_width = draft_.grid_width;
        light.grid_height = draft_.grid_height;
    }
}

} // namespace glint
