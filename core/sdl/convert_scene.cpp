// From an SDL file in any dialect to one in the canonical dialect.
#include <string>
#include <utility>

#include <glint/read.hpp>

#include "sdl/file_names.hpp"
#include "sdl/scene_file_reader.hpp"
#include "sdl/write_scene.hpp"

namespace glint {

Result<ConvertedScene> convert_scene(const std::filesystem::path &file, const std::filesystem::path &folder,
                                     const ReadOptions &options) {
    return guarded_reading(file, [&]() -> Result<ConvertedScene> {
        Result<FileNames> names = FileNames::in_folder(folder);
        if (!names.ok()) return std::move(names).error();
        SceneFileReader reader(file, options);
        if (const Status read = reader.read(); !read.ok()) return read.error();

        ConvertedScene converted;
        Problems problems(file.string());
        converted.text = write_scene(reader.draft(), *names, problems);
        if (!problems.ok()) return problems.take_error();
        Result<SceneFile> source = reader.build();
        if (!source.ok()) return std::move(source).error();
        converted.source = std::move(source).value();
        converted.scene_root = names->scene_root();
        return converted;
    });
}

} // namespace glint
