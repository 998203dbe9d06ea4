// From an SDL file and the meshes it names to a scene.
#include <glint/read.hpp>

#include "sdl/scene_file_reader.hpp"

namespace glint {

Result<SceneFile> read_scene(const std::filesystem::path &file, const ReadOptions &options) {
    return guarded_reading(file, [&]() -> Result<SceneFile> {
        SceneFileReader reader(file, options);
        if (const Status read = reader.read(); !read.ok()) return read.error();
        return reader.build();
    });
}

} // namespace glint
