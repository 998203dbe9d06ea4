// The meshes of one scene file, each read once.
#include "sdl/mesh_library.hpp"

#include <cmath>
#include <system_error>
#include <utility>

#include "math/vec.hpp"
#include "mesh/read_obj.hpp"
#include "scene/triangle_area.hpp"
#include "text/text_file.hpp"
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
    const Result<fs::path> found = paths_.find(name);
    if (!found.ok()) {
        for (const Diagnostic &diagnostic : found.error().diagnostics) {
            problems.error(place, diagnostic.message, diagnostic.hint, found.error().code);
        }
        return {};
    }
    std::error_code unknown;
    fs::path real = fs::canonical(*found, unknown);
    if (unknown) real = *found;
    const auto [entry, is_new] = by_file_.try_emplace(std::move(real));
    if (is_new) entry->second = read(*found, place, problems);
    return {entry->second, *found};
}

std::shared_ptr<const Mesh> MeshLibrary::read(const fs::path &path, const Place &place, Problems &problems) {
    const std::string name = path.string();
    Result<TextFile> text = read_text_file(path, options_.max_file_bytes);
    if (!text.ok()) {
        for (const Diagnostic &diagnostic : text.error().diagnostics) {
            problems.error(place, words("mesh ", path_in_quotes(name), ": ", diagnostic.message), diagnostic.hint,
                           text.error().code);
        }
        return nullptr;
    }
    files_.push_back(path);
    Result<MeshFile> mesh = read_obj_text(std::move(text).value(), name, options_.limits);
    if (mesh.ok()) {
        problems.adopt(std::move(mesh->warnings));
        return std::move(mesh->mesh);
    }
    Error error = std::move(mesh).error();
    for (Diagnostic &diagnostic : error.diagnostics) {
        // A problem of the file as a whole shows no line: say which line wants the file.
        if (diagnostic.line == 0 && diagnostic.hint.empty()) {
            diagnostic.hint = words("named in ", problems.file(), ':', place.line, ':', place.column);
        }
    }
    problems.adopt(std::move(error));
    return nullptr;
}

} // namespace glint
