// From an SDL file and the meshes it names to a scene.
#include "sdl/read_scene.hpp"

#include <utility>

#include "sdl/scene_file_reader.hpp"

namespace glint {

Result<SceneFile> read_scene_text(TextFile text, const std::filesystem::path &file, const ReadOptions &options) {
    return guarded_reading(file, [&]() -> Result<SceneFile> {
        SceneFileReader reader(file, options);
        if (const Status read = reader.read(std::move(text)); !read.ok()) return read.error();
        return reader.build();
    });
}

Result<SceneFile> read_scene_text(std::string_view text, const std::filesystem::path &file,
                                  const ReadOptions &options) {
    return guarded_reading(file, [&] { return read_scene_text(TextFile::copy_of(text), file, options); });
}

Result<SceneFile> read_scene(const std::filesystem::path &file, const ReadOptions &options) {
    return with_text_of(file, options, [&](TextFile text) { return read_scene_text(std::move(text), file, options); });
}

} // namespace glint
