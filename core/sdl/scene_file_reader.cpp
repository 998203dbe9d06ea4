// From an SDL file and the meshes it names to a draft, and on to a scene.
#include "sdl/scene_file_reader.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "sdl/dialects.hpp"
#include "text/plain_text.hpp"

namespace glint {

Status SceneFileReader::read(TextFile file_text) {
    text_ = std::move(file_text);
    if (!check_is_text(text_.view(), problems_)) return problems_.take_error();
    const std::string_view text = without_byte_order_mark(text_.view());
    dialect_ = detect_dialect(text, options_.dialect, problems_);
    if (!dialect_) return problems_.take_error();
    Result<AssetPaths> paths = AssetPaths::create(file_, options_);
    if (!paths.ok()) return std::move(paths).error();

    meshes_.emplace(std::move(paths).value(), options_);
    reader_.emplace(*dialect_, options_, *meshes_, problems_);
    reader_->read(text);
    if (!problems_.ok()) return problems_.take_error();
    return Done{};
}

Result<SceneFile> SceneFileReader::build() {
    SceneDraft &draft = reader_->draft();
    std::shared_ptr<const Animation> animation = animation_of(draft);
    SceneBuilder builder(options_.limits);
    for (ObjectDraft &entry : draft.objects) {
        for (Object &object : entry.parts) builder.add_object(std::move(object));
    }
    for (LightDraft &entry : draft.lights) builder.add_light(std::move(entry.light));
    Result<std::shared_ptr<const Scene>> scene = builder.set_camera(reader_->camera())
                                                     .set_picture(draft.picture)
                                                     .set_background(draft.background)
                                                     .set_ambient(draft.ambient)
                                                     .set_optics(draft.optics)
                                                     .set_animation(std::move(animation))
                                                     .build();
    if (scene.ok()) scene = scene_at(*scene, 0.0);
    if (!scene.ok()) return std::move(scene).error();

    SceneFile result;
    result.scene = std::move(scene).value();
    result.dialect = std::string(dialect_name(dialect_->dialect));
    result.dialect_reason = dialect_->reason;
    result.dialect_evidence = dialect_->evidence;
    result.output_file = std::move(draft.output_file);
    result.warnings = problems_.take_warnings();
    result.mesh_files = meshes_->take_files();
    return result;
}

Error about_file(const std::filesystem::path &file, Error error) {
    for (Diagnostic &diagnostic : error.diagnostics) {
        if (diagnostic.file.empty()) diagnostic.file = file.string();
    }
    return error;
}

} // namespace glint
