// From an SDL file and the meshes it names to a draft, and on to a scene: how every use of a scene file begins.
#pragma once

#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <system_error>

#include <glint/read.hpp>

#include "sdl/detect.hpp"
#include "sdl/draft_reader.hpp"
#include "sdl/mesh_library.hpp"
#include "sdl/scene_draft.hpp"
#include "text/problems.hpp"
#include "text/text_file.hpp"

namespace glint {

/// One file being read. The options must live as long as it does.
class SceneFileReader {
public:
    SceneFileReader(std::filesystem::path file, const ReadOptions &options)
        : file_(std::move(file)), options_(options), problems_(file_.string()) {}
    SceneFileReader(const SceneFileReader &) = delete;
    SceneFileReader &operator=(const SceneFileReader &) = delete;

    /// Reads the file, whose text this is, and its meshes. Fails with every problem that could be found.
    [[nodiscard]] Status read(TextFile file_text);

    /// What the file says; only after a read() that succeeded.
    [[nodiscard]] const SceneDraft &draft() const { return reader_->draft(); }
    /// The scene, and the rest of what the file said; takes what draft() holds.
    [[nodiscard]] Result<SceneFile> build();

private:
    std::filesystem::path file_;
    const ReadOptions &options_;
    Problems problems_;
    TextFile text_; ///< which the places in the draft point into
    std::optional<DetectedDialect> dialect_;
    std::optional<MeshLibrary> meshes_;
    std::optional<DraftReader> reader_;
};

/// The error, with the file's name wherever a diagnostic names none.
[[nodiscard]] Error about_file(const std::filesystem::path &file, Error error);

/// What `use()`, a Result, returns; its failures name the file, and what memory and the file system throw becomes one.
template <typename Use> [[nodiscard]] auto guarded_reading(const std::filesystem::path &file, const Use &use) {
    using Outcome = decltype(use());
    try {
        Outcome outcome = use();
        if (!outcome.ok()) return Outcome(about_file(file, std::move(outcome).error()));
        return outcome;
    } catch (const std::bad_alloc &) {
        return Outcome(about_file(file, {ErrorCode::out_of_memory, "there is not enough memory to read this scene"}));
    } catch (const std::system_error &failure) { // std::filesystem's among them
        return Outcome(about_file(file, {ErrorCode::io, std::string("the file system failed: ") + failure.what()}));
    }
}

/// What `use(text)`, a Result, returns of the file's text, guarded.
template <typename Use>
[[nodiscard]] auto with_text_of(const std::filesystem::path &file, const ReadOptions &options, const Use &use) {
    return guarded_reading(file, [&]() -> decltype(use(TextFile())) {
        Result<TextFile> text = Files(options.files.get()).read(file, options.max_file_bytes);
        if (!text.ok()) return std::move(text).error();
        return use(std::move(text).value());
    });
}

} // namespace glint
