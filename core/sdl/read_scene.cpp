// From an SDL file and the meshes it names to a scene.
#include <algorithm>
#include <filesystem>
#include <map>
#include <new>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <glint/read.hpp>

#include "sdl/arguments.hpp"
#include "sdl/camera_draft.hpp"
#include "sdl/detect.hpp"
#include "sdl/dialects.hpp"
#include "sdl/directives.hpp"
#include "sdl/lexer.hpp"
#include "sdl/mesh_library.hpp"
#include "sdl/scene_draft.hpp"
#include "text/plain_text.hpp"
#include "text/suggest.hpp"
#include "text/text_file.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// Reads one file in one dialect.
class SceneReader {
public:
    SceneReader(const DetectedDialect &dialect, const ReadOptions &options, MeshLibrary &meshes, Problems &problems)
        : dialect_(dialect), problems_(problems), draft_(options, meshes) {}

    void read(std::string_view text) {
        Lexer lexer(text, &problems_);
        Line line;
        while (lexer.next(line)) read_line(line);
        check_whole();
    }

    /// The scene; only after a read() that found no problem.
    Result<std::shared_ptr<const Scene>> build() {
        SceneBuilder builder(draft_.options.limits);
        for (ObjectDraft &entry : draft_.objects) {
            for (Object &object : entry.parts) builder.add_object(std::move(object));
        }
        for (LightDraft &entry : draft_.lights) builder.add_light(std::move(entry.light));
        return builder.set_camera(*camera_)
            .set_picture(draft_.picture)
            .set_background(draft_.background)
            .set_ambient(draft_.ambient)
            .set_optics(draft_.optics)
            .build();
    }

    [[nodiscard]] std::optional<std::string> take_output_file() { return std::move(draft_.output_file); }

private:
    void read_line(const Line &line) {
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
            return error_at(line, keyword,
                            words(in_quotes(keyword.text), " was given already, on line ", first->second));
        }
        form->handler(Arguments(line, *form, problems_), draft_);
    }

    /// The form of this dialect that the line fits, else its first one; nullptr where the dialect has none.
    const DirectiveForm *choose(std::span<const DirectiveForm> forms, const Line &line) const {
        const DirectiveForm *chosen = nullptr;
        for (const DirectiveForm &form : forms) {
            if (!form.dialects.has(dialect_.dialect)) continue;
            if (form.fits(line)) return &form;
            if (!chosen) chosen = &form;
        }
        return chosen;
    }

    void error_at(const Line &line, const Token &token, std::string message, std::string hint = {}) {
        problems_.error(line.place(token), std::move(message), std::move(hint));
    }

    void tell_unknown(const Line &line) {
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

    void tell_wrong_count(const Line &line, const DirectiveForm &form) {
        const bool too_many = line.argument_count > form.most_arguments();
        const size_t at = too_many ? std::min(form.most_arguments() + 1, line.tokens.size() - 1) : 0;
        std::string hint = words("expected: ", form.usage);
        if (too_many && form.is_path(0)) hint += "; file names cannot contain blanks";
        error_at(line, line.tokens[at],
                 words(in_quotes(line.tokens[0].text), " takes ", counted(form.most_arguments(), "argument"),
                       ", found ", line.argument_count),
                 std::move(hint));
    }

    /// What only the end of the file shows.
    void check_whole() {
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
    void apply_settings() {
        const bool adds = draft_.reflection_adds.value_or(adds_reflections(dialect_.dialect));
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

    const DetectedDialect &dialect_;
    Problems &problems_;
    SceneDraft draft_;
    std::optional<Camera> camera_;
    std::map<DirectiveHandler, uint32_t> given_; ///< the line where each setting was first given
    bool has_light_ = false;                     ///< whether a line tried to add one
    bool has_object_ = false;
};

Result<SceneFile> read_scene_text(std::string_view text, const std::filesystem::path &file, const ReadOptions &options,
                                  Problems &problems) {
    if (!check_is_text(text, problems)) return problems.take_error();
    text = without_byte_order_mark(text);
    const std::optional<DetectedDialect> dialect = detect_dialect(text, options.dialect, problems);
    if (!dialect) return problems.take_error();
    Result<AssetPaths> paths = AssetPaths::create(file, options);
    if (!paths.ok()) return std::move(paths).error();

    MeshLibrary meshes(std::move(paths).value(), options);
    SceneReader reader(*dialect, options, meshes, problems);
    reader.read(text);
    if (!problems.ok()) return problems.take_error();
    Result<std::shared_ptr<const Scene>> scene = reader.build();
    if (!scene.ok()) return std::move(scene).error();

    SceneFile result;
    result.scene = std::move(scene).value();
    result.dialect = std::string(dialect_name(dialect->dialect));
    result.dialect_reason = dialect->reason;
    result.output_file = reader.take_output_file();
    result.warnings = problems.take_warnings();
    result.mesh_files = meshes.take_files();
    return result;
}

Error about(const std::string &file, Error error) {
    for (Diagnostic &diagnostic : error.diagnostics) {
        if (diagnostic.file.empty()) diagnostic.file = file;
    }
    return error;
}

} // namespace

Result<SceneFile> read_scene(const std::filesystem::path &file, const ReadOptions &options) {
    const std::string name = file.string();
    try {
        Problems problems(name);
        const Result<TextFile> text = read_text_file(file, options.max_file_bytes);
        if (!text.ok()) return about(name, text.error());
        Result<SceneFile> scene = read_scene_text(text->view(), file, options, problems);
        if (!scene.ok()) return about(name, std::move(scene).error());
        return scene;
    } catch (const std::bad_alloc &) {
        return about(name, Error(ErrorCode::limit_exceeded, "there is not enough memory to read this scene"));
    } catch (const std::system_error &failure) { // std::filesystem's among them
        return about(name, Error(ErrorCode::io, words("the file system failed: ", failure.what())));
    }
}

} // namespace glint
