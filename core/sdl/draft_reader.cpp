// From the lines of an SDL file to what they say together.
#include "sdl/draft_reader.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "sdl/arguments.hpp"
#include "sdl/camera_draft.hpp"
#include "sdl/directives.hpp"
#include "text/suggest.hpp"
#include "text/words.hpp"

namespace glint {

void DraftReader::read(std::string_view text) {
    Lexer lexer(text, &problems_);
    Line line;
    while (lexer.next(line)) read_line(line);
    check_whole();
}

void DraftReader::read_line(const Line &line) {
    const Token &keyword = line.tokens[0];
    const std::span<const DirectiveForm> forms = forms_of(keyword.text);
    if (forms.empty()) return tell_unknown(line);
    has_light_ = has_light_ || forms.front().role == DirectiveForm::Role::light;
    has_object_ = has_object_ || forms.front().role == DirectiveForm::Role::object;
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
        given_.try_emplace(form->handler, line.number);
        return tell_wrong_count(line, *form);
    }
    const auto [first, is_first] = given_.try_emplace(form->handler, line.number);
    if (!is_first && form->role == DirectiveForm::Role::setting) {
        return error_at(line, keyword, words(in_quotes(keyword.text), " was given already, on line ", first->second));
    }
    form->handler(Arguments(line, *form, problems_), draft_);
}

/// The form of this dialect that the line fits, else its first one; nullptr where the dialect has none.
const DirectiveForm *DraftReader::choose(std::span<const DirectiveForm> forms, const Line &line) const {
    const DirectiveForm *chosen = nullptr;
    for (const DirectiveForm &form : forms) {
        if (!form.dialects.has(dialect_.dialect)) continue;
        if (form.fits(line)) return &form;
        if (!chosen) chosen = &form;
    }
    return chosen;
}

void DraftReader::error_at(const Line &line, const Token &token, std::string message, std::string hint) {
    problems_.error(line.place(token), std::move(message), std::move(hint));
}

void DraftReader::tell_unknown(const Line &line) {
    const Token &keyword = line.tokens[0];
    if (problems_.full()) return error_at(line, keyword, {});
    std::string lower;
    for (const char c : keyword.text.substr(0, 64)) {
        lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    std::vector<std::string_view> known;
    for (const DirectiveForm &form : directive_forms()) {
        if (form.dialects.has(dialect_.dialect)) known.push_back(form.keyword());
    }
    const auto nearest = nearest_word(lower, known);
    error_at(line, keyword, words("unknown directive ", in_quotes(keyword.text)),
             nearest ? words("did you mean '", *nearest, "'?") : std::string());
}

void DraftReader::tell_wrong_count(const Line &line, const DirectiveForm &form) {
    const bool too_many = line.argument_count > form.most_arguments();
    const size_t at = too_many ? std::min(form.most_arguments() + 1, line.tokens.size() - 1) : 0;
    std::string hint = words("expected: ", form.usage);
    if (too_many && form.is_path(0)) hint += "; file names cannot contain blanks";
    error_at(line, line.tokens[at],
             words(in_quotes(line.tokens[0].text), " takes ", counted(form.most_arguments(), "argument"), ", found ",
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
    if (!draft_.eye && !given_.contains(read_eye)) missing("eye");
    if (!has_light_) missing("light");
    if (!has_object_) missing("object");
    camera_ = camera_of(draft_, problems_);
    apply_settings();
}

/// Settings that stand for every light and object, wherever in the file they are.
void DraftReader::apply_settings() {
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
