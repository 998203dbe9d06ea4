// Reading scene files, SDL text and the OBJ meshes it names, and rewriting them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glint/export.hpp>
#include <glint/file_source.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

namespace glint {

/// What a reader may do and how much it will take.
struct ReadOptions {
    SceneLimits limits;
    /// Folder that no path of the scene file may leave; empty = the scene file's own folder. Paths are looked up in the
    /// scene file's folder first, then in each folder above it up to this one.
    std::filesystem::path scene_root;
    /// Accept paths that are absolute or leave the scene root.
    bool allow_outside_root = false;
    /// Largest file read, SDL, OBJ or MTL.
    uint64_t max_file_bytes = uint64_t{4} << 30;
    /// Name of the dialect to read the file as; empty = what the file's own directives show.
    std::string dialect;
    /// Reads the picture that a material names as its texture; its errors name the file. Empty = textures are left
    /// aside, with a warning. This library reads no image files by itself: glint::read_texture (glint/imageio.hpp)
    /// does.
    std::function<Result<Texture>(const std::filesystem::path &)> read_texture = {};
    /// Where all files come from; nullptr = the system's file system. With a source every path here and below is a path
    /// in it, and decode_texture takes the place of read_texture.
    std::shared_ptr<const FileSource> files = nullptr;
    /// Makes a texture of the bytes of an image file that `files` gave, and of its path; its errors need not name the
    /// file. Empty = textures are left aside, with a warning.
    std::function<Result<Texture>(std::string_view bytes, const std::string &path)> decode_texture = {};
    /// Leave the normals of OBJ files aside, so that every triangle is flat.
    bool flat = false;
};

/// A kind of line that only some SDL dialects have.
struct DialectEvidence {
    uint32_t line = 0;                 ///< the first such line, from 1
    std::string what;                  ///< "'object' with 9 numbers"
    std::vector<std::string> dialects; ///< that the line speaks for
};

/// A scene as it stood in a file, and what the file said besides.
struct SceneFile {
    std::shared_ptr<const Scene> scene;
    std::string dialect;        ///< name of the SDL dialect the file was read as
    std::string dialect_reason; ///< why: the directive, and its line, that decided
    /// Every kind of line that speaks for some dialects, in the file's order.
    std::vector<DialectEvidence> dialect_evidence;
    std::optional<std::string> output_file;        ///< the `output` directive, as written
    std::vector<Diagnostic> warnings;              ///< e.g. triangles without area that were left out
    std::vector<std::filesystem::path> mesh_files; ///< every OBJ file that was read, each once, in order of first use
};

/// Reads an SDL file and every mesh it names. Fails with every problem of the file that could be found in one run.
[[nodiscard]] GLINT_API Result<SceneFile> read_scene(const std::filesystem::path &file,
                                                     const ReadOptions &options = {});

/// Reads an SDL file that is in memory. `file` is where it would lie: messages call it so, and what it names is looked
/// for from there.
[[nodiscard]] GLINT_API Result<SceneFile> read_scene_text(std::string_view text, const std::filesystem::path &file,
                                                          const ReadOptions &options = {});

/// A scene file, rewritten in the canonical dialect of SDL, `glint`.
struct ConvertedScene {
    std::string text; ///< of the new file
    SceneFile source; ///< the old one, as it was read
    /// Set where the new file names files outside its own folder: the folder that must be its scene root.
    std::optional<std::filesystem::path> scene_root;
};

/// Reads an SDL file and writes what it says in the dialect `glint`: the picture is the same to the bit, and a file
/// that was converted already stays as it is. The new file is meant to lie in `folder`, which exists: names of meshes
/// are relative to it; the name of the output stays. Fails as read_scene() does, and where the new file could not name
/// a mesh, because of a blank or '#' in its path.
[[nodiscard]] GLINT_API Result<ConvertedScene>
convert_scene(const std::filesystem::path &file, const std::filesystem::path &folder, const ReadOptions &options = {});

/// A mesh as it stood in an OBJ file.
struct MeshFile {
    std::shared_ptr<const Mesh> mesh;
    std::vector<Diagnostic> warnings;
};

/// Reads the faces of a Wavefront OBJ file as one mesh: polygons are cut into triangles, negative (relative) indices
/// resolved; groups, normals, texture coordinates and materials are checked and left aside. Triangles keep the file's
/// order.
[[nodiscard]] GLINT_API Result<MeshFile> read_obj(const std::filesystem::path &file, const ReadOptions &options = {});

/// The faces of one material in an OBJ file.
struct ModelPart {
    std::string material_name; ///< as the OBJ file calls it; empty for faces before the first `usemtl`
    std::shared_ptr<const Mesh> mesh;
    Material material;
};

/// An OBJ file with its materials, normals and texture coordinates.
struct ModelFile {
    std::vector<ModelPart> parts; ///< one for each material that has faces, in the order of its first
    std::vector<Diagnostic> warnings;
    std::vector<std::filesystem::path> files; ///< every file that was read: OBJ, MTL and textures, each once
};

/// Reads a Wavefront OBJ file with the MTL files it names and the textures those name. Its faces become triangles as
/// read_obj() makes them. Each part's mesh has the positions, normals and texture coordinates that the part uses, in
/// the file's order.
///
/// Libraries are looked up beside the OBJ file, textures beside the MTL file, each then further up to the scene root;
/// `mtllib` may name several, and the first that has a material of the name counts. Of a material are taken Kd
/// (colour), Ks (highlight), Ns, d or Tr (transmission), Ni and map_Kd; options of map_Kd have no effect, and those
/// that should are warned of. Faces without a material are white. Fails with every problem that could be found in one
/// run.
[[nodiscard]] GLINT_API Result<ModelFile> read_model(const std::filesystem::path &file,
                                                     const ReadOptions &options = {});

} // namespace glint
