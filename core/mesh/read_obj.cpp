// From an OBJ file to a mesh that nothing later has to check again.
#include "mesh/read_obj.hpp"

#include <algorithm>
#include <utility>

#include "mesh/from_file.hpp"
#include "mesh/obj_check.hpp"
#include "mesh/obj_parse.hpp"
#include "mesh/obj_rules.hpp"
#include "scene/triangle_area.hpp"
#include "text/plain_text.hpp"
#include "text/problems.hpp"

namespace glint {

namespace {

/// Whether tinyobjloader understood the text as check_obj() did.
bool matches(const Mesh &mesh, const ObjCounts &counts) {
    const size_t count = mesh.positions.size();
    const auto in_range = [count](const Triangle &t) { return t.a < count && t.b < count && t.c < count; };
    return count == counts.vertices && mesh.triangles.size() == counts.triangles &&
           std::all_of(mesh.positions.begin(), mesh.positions.end(), is_place) &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(), in_range);
}

void drop_triangles_without_area(Mesh &mesh, Problems &problems) {
    const size_t all = mesh.triangles.size();
    const auto dropped = std::erase_if(mesh.triangles, [&](const Triangle &t) { return !has_area(mesh, t); });
    tell_of_triangles_without_area(dropped, all, problems);
}

} // namespace

Result<MeshFile> read_obj_text(TextFile text, const std::string &name, const SceneLimits &limits) {
    Problems problems(name);
    const auto body = plain_text_of(text, problems);
    if (!body) return problems.take_error();

    const ObjCounts counts = check_obj(*body, problems);
    if (problems.ok()) check_counts(counts, limits, problems);
    if (!problems.ok()) return problems.take_error();

    auto mesh = std::make_shared<Mesh>(parse_obj(*body, counts));
    text = {};
    if (!matches(*mesh, counts)) {
        tell_of_other_reading(problems);
    } else {
        drop_triangles_without_area(*mesh, problems);
    }
    if (!problems.ok()) return problems.take_error();
    return MeshFile{std::move(mesh), problems.take_warnings()};
}

Result<MeshFile> read_obj(const std::filesystem::path &file, const ReadOptions &options) {
    return from_file<MeshFile>(
        file, options, [&](TextFile text) { return read_obj_text(std::move(text), file.string(), options.limits); });
}

} // namespace glint
