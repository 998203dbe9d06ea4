// From the lines of an SDL file to what they say together.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glint/read.hpp>

#include "sdl/detect.hpp"
#include "sdl/dialects.hpp"
#include "sdl/lexer.hpp"
#include "sdl/scene_draft.hpp"
#include "text/problems.hpp"

namespace glint {

/// Reads one file in one dialect. What it is given must live as long as it and its draft do.
class DraftReader {
public:
    DraftReader(const DetectedDialect &dialect, const ReadOptions &options, MeshLibrary &meshes, Problems &problems)
        : dialect_(dialect), problems_(problems), draft_(options, meshes) {}

    /// Reads all lines, then checks what only the whole file shows. Everything that is wrong is in the problems.
    void read(std::string_view text);

    [[nodiscard]] SceneDraft &draft() { return draft_; }
    [[nodiscard]] const SceneDraft &draft() const { return draft_; }
    /// Only after a read() that found no problem.
    [[nodiscard]] const Camera &camera() const { return *camera_; }

private:
    /// Where a setting was first given, and by which of its names.
    struct First {
        uint32_t line;
        std::string_view keyword;
    };

    void note_attempt(const DirectiveForm &form);
    void read_line(const Line &line);
    [[nodiscard]] const DirectiveForm *choose(std::span<const DirectiveForm> forms, const Line &line) const;
    void error_at(const Line &line, const Token &token, std::string message, std::string hint = {});
    void tell_unknown(const Line &line);
    void tell_twice(const Line &line, const DirectiveForm &form, const First &first);
    void tell_wrong_count(const Line &line, const DirectiveForm &form);
    void check_whole();
    void choose_depth();
    void apply_settings();

    const DetectedDialect &dialect_;
    Problems &problems_;
    SceneDraft draft_;
    std::optional<Camera> camera_;
    std::map<DirectiveHandler, First> given_; ///< by what it does, so that synonyms are one
    bool has_eye_ = false;                    ///< whether a line tried to give it
    bool has_light_ = false;
    bool has_object_ = false;
};

} // namespace glint
