// Reading scenes for C: options, files that the host brings.
#include <glint/scene.h>

#include <glint/read.hpp>

#include "c/scene_handle.hpp"
#include "c/sized.hpp"

struct glint_file {
    uint64_t max_bytes;
    glint::FileBytes bytes = {};
    glint_error error = GLINT_OK; ///< why there was no memory for it
};

namespace glint {

namespace {

Error failure(ErrorCode code, const char *message) {
    return {code, message};
}

/// Files that the host's callbacks read.
class HostFiles : public FileSource {
public:
    explicit HostFiles(const glint_file_source &source) : source_(source) {}

    Result<FileBytes> read(const std::string &path, uint64_t max_bytes) const override {
        glint_file file{max_bytes};
        const glint_error error = source_.read(source_.user, path.c_str(), max_bytes, &file);
        if (error == GLINT_OK && file.error == GLINT_OK) return std::move(file.bytes);
        switch (error != GLINT_OK ? error : file.error) {
        case GLINT_ERROR_NOT_FOUND:
            return failure(ErrorCode::not_found, "there is no such file");
        case GLINT_ERROR_LIMIT_EXCEEDED:
            return failure(ErrorCode::limit_exceeded, "larger than the options allow");
        case GLINT_ERROR_OUT_OF_MEMORY:
            return failure(ErrorCode::out_of_memory, "out of memory");
        default:
            return failure(ErrorCode::io, "its source could not read it");
        }
    }

    bool contains(const std::string &path) const override {
        return source_.contains ? source_.contains(source_.user, path.c_str()) != 0 : FileSource::contains(path);
    }

private:
    const glint_file_source source_;
};

glint_read_options default_read_options() {
    const ReadOptions options;
    glint_read_options defaults = {};
    defaults.size = sizeof defaults;
    defaults.max_file_bytes = options.max_file_bytes;
    defaults.max_pixels = options.limits.max_pixels;
    defaults.max_triangles = options.limits.max_triangles;
    defaults.max_depth = options.limits.max_depth;
    return defaults;
}

/// The options in C++; what is wrong with them, or nullptr.
const char *convert(const glint_read_options *asked, ReadOptions &options) {
    glint_read_options given = default_read_options();
    if (!take(asked, given)) return "the options are not a valid struct: see their size";
    if (given.scene_root) options.scene_root = given.scene_root;
    if (given.dialect) options.dialect = given.dialect;
    options.max_file_bytes = given.max_file_bytes;
    options.limits.max_pixels = given.max_pixels;
    options.limits.max_triangles = given.max_triangles;
    options.limits.max_depth = given.max_depth;
    options.flat = given.flat != 0;
    options.allow_outside_root = given.allow_outside_root != 0;
    if (given.files) {
        glint_file_source source = {};
        if (!take(given.files, source)) return "the file source is not a valid struct: see its size";
        if (!source.read) return "the file source cannot read";
        if (given.memory_files) return "files come from a source or from memory, not both";
        options.files = std::make_shared<HostFiles>(source);
    }
    if (given.memory_files) {
        const auto files = std::make_shared<MemoryFiles>();
        for (size_t i = 0; i < given.memory_file_count; ++i) {
            const glint_memory_file &file = given.memory_files[i];
            if (!file.path || (!file.bytes && file.byte_count > 0)) return "a file in memory has no path or no bytes";
            files->add(file.path, std::string(static_cast<const char *>(file.bytes), file.byte_count));
        }
        options.files = files;
    }
    return nullptr;
}

/// Reads the file or, where there is one, the text in its place.
glint_error read(glint_scene **place, const char *file, const std::string_view *text, const glint_read_options *asked) {
    return create(place, [&](glint_scene &handle) -> glint_error {
        if (!file || (text && !text->data() && !text->empty())) return handle.refuse("the file has no name or no text");
        ReadOptions options;
        if (const char *const problem = convert(asked, options)) return handle.refuse(problem);
        Result<SceneFile> result = text ? read_scene_text(*text, file, options) : read_scene(file, options);
        if (!result) return handle.fail_with(std::move(result).error());
        SceneFile &read = *result;
        handle.dialect = std::move(read.dialect);
        handle.dialect_reason = std::move(read.dialect_reason);
        if (read.output_file) handle.output_file = std::move(*read.output_file);
        handle.diagnostics = std::move(read.warnings);
        handle.scene = std::move(read.scene);
        return GLINT_OK;
    });
}

} // namespace

} // namespace glint

using namespace glint;

void *glint_file_allocate(glint_file *file, size_t byte_count) {
    if (!file) return nullptr;
    if (byte_count > file->max_bytes) return file->error = GLINT_ERROR_LIMIT_EXCEEDED, nullptr;
    try {
        file->bytes = FileBytes(byte_count);
        return file->error = GLINT_OK, file->bytes.bytes.get();
    } catch (...) {
        return file->error = GLINT_ERROR_OUT_OF_MEMORY, nullptr;
    }
}

glint_error glint_read_options_init(glint_read_options *options, size_t size) {
    return init(options, size, default_read_options());
}

glint_error glint_scene_read(const char *file, const glint_read_options *options, glint_scene **scene) {
    return glint::read(scene, file, nullptr, options);
}

glint_error glint_scene_read_text(const char *text, size_t byte_count, const char *file,
                                  const glint_read_options *options, glint_scene **scene) {
    const std::string_view all(text, byte_count);
    return glint::read(scene, file, &all, options);
}
