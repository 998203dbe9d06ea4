// The meshes of one scene file, each read once.
#include "sdl/mesh_library.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/vec.hpp"
#include "mesh/read_model.hpp"
#include "mesh/read_obj.hpp"
#include "scene/triangle_area.hpp"
#include "text/asset_file.hpp"
#include "text/words.hpp"

namespace glint {

namespace fs = std::filesystem;

MeshLibrary::Found MeshLibrary::find(std::string_view name, const Place &place, Problems &problems) {
    const auto [entry, is_new] = by_name_.try_emplace(std::string(name));
    if (is_new) entry->second = look_up(entry->first, place, problems);
    return entry->second;
}

std::shared_ptr<const Mesh> MeshLibrary::moved(const std::shared_ptr<const Mesh> &mesh, const Vector &offset,
                                               std::string_view name, const Place &place, Problems &problems) {
    const bool stays = offset.x == 0.0f && offset.y == 0.0f && offset.z == 0.0f;
    if (stays || std::isnan(offset.x + offset.y + offset.z)) return mesh;
    const auto [entry, is_new] = moved_.try_emplace({mesh.get(), offset.x, offset.y, offset.z});
    if (!is_new) return entry->second;

    auto copy = std::make_shared<Mesh>(*mesh);
    for (Point &p : copy->positions) {
        p = {p.x + offset.x, p.y + offset.y, p.z + offset.z};
        if (max_abs(p) <= max_coordinate) continue;
        problems.error(place, words("the mesh ", path_in_quotes(name), " moves to more than 1e12 from the origin"));
        return nullptr;
    }
    const size_t all = copy->triangles.size();
    const size_t erased = erase_triangles_without_area(*copy);
    if (erased == all) {
        problems.error(place,
                       words("so far from the origin no triangle of the mesh ", path_in_quotes(name), " is left"));
        return nullptr;
    }
    if (erased > 0) {
        problems.warn(place, words(erased, " of the ", all, " triangles of the mesh ", path_in_quotes(name),
                                   " have no area so far from the origin, and are left out"));
    }
    return entry->second = std::move(copy);
}

MeshLibrary::Found MeshLibrary::look_up(const std::string &name, const Place &place, Problems &problems) {
    const std::optional<fs::path> file = find_asset(paths_, name, place, problems);
    if (!file) return {};
    const auto [entry, is_new] = by_file_.try_emplace(real_path(paths_.files(), *file));
    if (is_new) entry->second = read(*file, place, problems);
    return {entry->second, *file};
}

MeshLibrary::FoundModel MeshLibrary::find_model(std::string_view name, const Place &place, Problems &problems) {
    const auto [known, is_first] = models_by_name_.try_emplace(std::string(name));
    if (!is_first) return known->second;
    const std::optional<fs::path> file = find_asset(paths_, name, place, problems);
    if (!file) return {};
    const auto [entry, is_new] = models_by_file_.try_emplace(real_path(paths_.files(), *file));
    if (is_new) entry->second = read_model(*file, place, problems);
    return known->second = {entry->second, *file};
}

std::optional<TextFile> MeshLibrary::open(const fs::path &path, const Place &place, Problems &problems) {
    std::optional<TextFile> text = read_asset(paths_.files(), path, "mesh", options_.max_file_bytes, place, problems);
    if (text && std::find(files_.begin(), files_.end(), path) == files_.end()) files_.push_back(path);
    return text;
}

std::shared_ptr<const Mesh> MeshLibrary::read(const fs::path &path, const Place &place, Problems &problems) {
    std::optional<TextFile> text = open(path, place, problems);
    if (!text) return nullptr;
    Result<MeshFile> mesh = read_obj_text(std::move(*text), path.string(), options_.limits);
    if (!mesh.ok()) return problems.adopt(std::move(mesh).error(), place), nullptr;
    problems.adopt(std::move(mesh->warnings));
    return std::move(mesh->mesh);
}

std::shared_ptr<const ModelFile> MeshLibrary::read_model(const fs::path &path, const Place &place, Problems &problems) {
    std::optional<TextFile> text = open(path, place, problems);
    if (!text) return nullptr;
    Result<ModelFile> model =
        read_model_text(std::move(*text), path, paths_.beside(path, "OBJ file"), options_, textures_);
    if (!model.ok()) return problems.adopt(std::move(model).error(), place), nullptr;
    problems.adopt(std::move(model->warnings));
    return std::make_shared<const ModelFile>(std::move(model).value());
}

} // namespace glint
