// Where readers get files from when not from the system: the assets of an app, an archive, memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint {

/// A file's bytes, which readers change as they go.
struct GLINT_API FileBytes {
    std::unique_ptr<char[]> bytes;
    size_t size = 0;

    FileBytes() = default;
    /// So many bytes, to be filled. Throws std::bad_alloc.
    explicit FileBytes(size_t size_bytes) : bytes(new char[size_bytes]), size(size_bytes) {}
    [[nodiscard]] static FileBytes copy_of(std::string_view bytes);

    [[nodiscard]] std::string_view view() const { return {bytes.get(), size}; }
};

/// A tree of files with folders, of which only files can be seen. Paths are text, with '/' between folders and without
/// "." and ".." wherever those can be resolved ("config/../floor.obj" is asked for as "floor.obj"); they begin as the
/// path did that the reader was given, so that "scenes/room.sdl" leads to "scenes/floor.obj". There are no symbolic
/// links and no current folder. Names that lead out of the scene root never get here.
///
/// Readers call it from their caller's thread. One source may serve several readers at once if it allows for that
/// itself. std::bad_alloc may be thrown; anything else must be an Error.
class GLINT_API FileSource {
public:
    virtual ~FileSource();

    /// The whole file. Fails with one diagnostic, which need not name the file: not_found, limit_exceeded where it has
    /// more than max_bytes (preferably without reading it), or io.
    [[nodiscard]] virtual Result<FileBytes> read(const std::string &path, uint64_t max_bytes) const = 0;

    /// Whether there is such a file. As it is here: whether read() with a limit of no bytes fails with anything but
    /// not_found.
    [[nodiscard]] virtual bool contains(const std::string &path) const;
};

/// Files in memory.
///
///     auto files = std::make_shared<glint::MemoryFiles>();
///     files->add("room.sdl", text).add("floor.obj", mesh);
///     glint::ReadOptions options;
///     options.files = files;
///     auto scene = glint::read_scene("room.sdl", options);
///
/// Any number of readers may use it at once, while nobody adds to it.
class GLINT_API MemoryFiles : public FileSource {
public:
    /// Takes a file in, in place of one that had the path before.
    MemoryFiles &add(std::string_view path, std::string bytes);

    [[nodiscard]] Result<FileBytes> read(const std::string &path, uint64_t max_bytes) const override;
    [[nodiscard]] bool contains(const std::string &path) const override;

private:
    std::map<std::string, std::string> files_; ///< by paths without "." and ".."
};

} // namespace glint
