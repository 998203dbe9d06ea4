// From an OBJ file, and what it names, to meshes with materials.
#include "mesh/read_model.hpp"

#include <algorithm>
#include <utility>

#include "mesh/from_file.hpp"
#include "mesh/material_libraries.hpp"
#include "mesh/model_parse.hpp"
#include "mesh/model_parts.hpp"
#include "mesh/obj_check.hpp"
#include "mesh/obj_rules.hpp"
#include "text/plain_text.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// Whether tinyobjloader understood the text as check_obj() did.
bool matches(const ModelFaces &model, const ObjCounts &counts, const ObjNames &names) {
    const Mesh &all = model.elements;
    const auto index_fits = [](uint32_t index, size_t count) { return index == no_corner || index < count; };
    const auto corner_fits = [&](const FaceCorner &corner) {
        return corner.position < all.positions.size() && index_fits(corner.normal, all.normals.size()) &&
               index_fits(corner.texcoord, all.texcoords.size());
    };
    const auto is_texcoord = [](const glm::vec2 &t) { return is_place({t.x, t.y, 0.0f}); };
    const auto is_known = [&](const std::string &name) { return name.empty() || names.materials.contains(name); };
    return all.positions.size() == counts.vertices && all.normals.size() == counts.normals &&
           all.texcoords.size() == counts.texcoords && model.faces.size() == counts.faces &&
           model.corners.size() == counts.triangles + 2 * counts.faces &&
           std::all_of(all.positions.begin(), all.positions.end(), is_place) &&
           std::all_of(all.normals.begin(), all.normals.end(), is_place) &&
           std::all_of(all.texcoords.begin(), all.texcoords.end(), is_texcoord) &&
           std::all_of(model.materials.begin(), model.materials.end(), is_known) &&
           std::all_of(model.corners.begin(), model.corners.end(), corner_fits);
}

/// The meshes, all of the material that faces without one get: white.
std::vector<ModelPart> meshes_of(const ModelFaces &model, bool flat, Problems &problems) {
    PartMeshes meshes = make_parts(model);
    tell_of_triangles_without_area(meshes.left_out, meshes.triangles, problems);
    if (meshes.zero_normals > 0 && !flat) {
        problems.warn({},
                      words(meshes.zero_normals, " of the file's ", counted(model.elements.normals.size(), "normal"),
                            meshes.zero_normals == 1 ? " is" : " are", " zero; triangles with such corners are flat"));
    }
    Material white;
    white.ambient = 1.0f;
    std::vector<ModelPart> parts;
    for (PartMesh &part : meshes.parts) {
        parts.push_back({model.materials[part.material], std::move(part.mesh), white});
    }
    return parts;
}

} // namespace

Result<ModelFile> read_model_text(TextFile text, const std::filesystem::path &file, const AssetPaths &paths,
                                  const ReadOptions &options, TextureLibrary &textures) {
    Problems problems(file.string());
    const auto body = plain_text_of(text, problems);
    if (!body) return problems.take_error();

    ObjNames names;
    const ObjCounts counts = check_obj(*body, problems, &names);
    if (problems.ok()) check_counts(counts, options.limits, problems);
    MaterialLibraries libraries(paths, options, textures, problems);
    for (const ObjNames::Library &library : names.libraries) libraries.read(library);
    if (!problems.ok()) return problems.take_error();

    const ModelFaces model = parse_model(*body, counts, !options.flat);
    text = {};
    if (!matches(model, counts, names)) {
        tell_of_other_reading(problems);
        return problems.take_error();
    }
    ModelFile result;
    result.parts = meshes_of(model, options.flat, problems);
    for (ModelPart &part : result.parts) {
        if (part.material_name.empty()) continue;
        part.material = libraries.find(part.material_name, names.materials[part.material_name].place());
        if (part.material.texture && part.mesh->texcoords.empty()) {
            problems.warn(names.materials[part.material_name].place(),
                          words("the material ", in_quotes(part.material_name),
                                " has a texture, and its faces have no texture coordinates"));
        }
    }
    if (!problems.ok()) return problems.take_error();
    result.files.push_back(file);
    result.files.insert(result.files.end(), libraries.files().begin(), libraries.files().end());
    result.warnings = problems.take_warnings();
    return result;
}

Result<ModelFile> read_model(const std::filesystem::path &file, const ReadOptions &options) {
    return from_file<ModelFile>(file, options, [&](TextFile text) -> Result<ModelFile> {
        const Result<AssetPaths> paths = AssetPaths::create(file, options);
        if (!paths.ok()) return paths.error();
        TextureLibrary textures(options);
        Result<ModelFile> model =
            read_model_text(std::move(text), file, paths->beside(file, "OBJ file"), options, textures);
        if (model.ok()) model->files.insert(model->files.end(), textures.files().begin(), textures.files().end());
        return model;
    });
}

} // namespace glint
