// From an SDL file in any dialect to one in the canonical dialect.
#include <string>
#include <utility>

#include "sdl/file_names.hpp"
#include "sdl/read_scene.hpp"
#include "sdl/scene_file_reader.hpp"
#include "sdl/write_scene.hpp"

namespace glint {

Result<ConvertedScene> convert_scene_text(TextFile text, const std::filesystem::path &file,
                                          const std::filesystem::path &folder, const ReadOptions &options) {
    return guarded_reading(file, [&]() -> Result<ConvertedScene> {
        Result<FileNames> names = FileNames::in_folder(Files(options.files.get()), folder);
        if (!names.ok()) return std::move(names).error();
        SceneFileReader reader(file, options);
        if (const Status read = reader.read(std::move(text)); !read.ok()) return read.error();

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

Result<ConvertedScene> convert_scene(const std::filesystem::path &file, const std::filesystem::path &folder,
                                     const ReadOptions &options) {
    return with_text_of(file, options,
                        [&](TextFile text) { return convert_scene_text(std::move(text), file, folder, options); });
}

} // namespace glint
