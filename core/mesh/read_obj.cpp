// From an OBJ file to a mesh that nothing later has to check again.
#include "mesh/read_obj.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "mesh/obj_check.hpp"
#include "mesh/obj_parse.hpp"
#include "scene/triangle_area.hpp"
#include "text/plain_text.hpp"
#include "text/problems.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// Says what a mesh may not be: too large for the limits, or for 32-bit indices.
void check_counts(const ObjCounts &counts, const SceneLimits &limits, Problems &problems) {
    const uint64_t most_triangles = std::min(limits.max_triangles, uint64_t{1} << 30);
    if (counts.triangles > most_triangles) {
        problems.error({}, words("the mesh has ", counts.triangles, " triangles, the limit is ", most_triangles), {},
                       ErrorCode::limit_exceeded);
    }
    const uint64_t most_vertices = (uint64_t{1} << 31) - 1; // tinyobjloader's indices are int
    if (counts.vertices > most_vertices) {
        problems.error({}, words("the mesh has ", counts.vertices, " vertices, the limit is ", most_vertices), {},
                       ErrorCode::limit_exceeded);
    }
    if (counts.faces == 0) problems.error({}, "the file has no face ('f'), so there is nothing to see");
}

/// Whether tinyobjloader understood the text as check_obj() did. It always should; a library that changes its mind must
/// not be able to put a wild index into a scene.
bool matches(const Mesh &mesh, const ObjCounts &counts) {
    const auto is_place = [](const Point &p) {
        return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate && std::abs(p.z) <= max_coordinate;
    };
    const size_t count = mesh.positions.size();
    const auto in_range = [count](const Triangle &t) { return t.a < count && t.b < count && t.c < count; };
    return count == counts.vertices && mesh.triangles.size() == counts.triangles &&
           std::all_of(mesh.positions.begin(), mesh.positions.end(), is_place) &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(), in_range);
}

/// Leaves out triangles that no ray can hit, here rather than in the scene builder: only here is it known whose they
/// are.
void drop_triangles_without_area(Mesh &mesh, Problems &problems) {
    const size_t all = mesh.triangles.size();
    const auto dropped = std::erase_if(mesh.triangles, [&](const Triangle &t) { return !has_area(mesh, t); });
    if (dropped == all) {
        problems.error({}, "none of the mesh's triangles has an area");
    } else if (dropped > 0) {
        problems.warn({}, words(dropped, " of the mesh's ", all, " triangles have no area and are left out"));
    }
}

} // namespace

Result<MeshFile> read_obj_text(TextFile text, const std::string &name, const SceneLimits &limits) {
    Problems problems(name);
    if (!check_is_text(text.view(), problems)) return problems.take_error();

    const size_t mark_bytes = text.size - without_byte_order_mark(text.view()).size();
    const std::span<char> body(text.bytes.get() + mark_bytes, text.size - mark_bytes);
    const ObjCounts counts = check_obj(body, problems);
    if (problems.ok()) check_counts(counts, limits, problems);
    if (!problems.ok()) return problems.take_error();

    auto mesh = std::make_shared<Mesh>(parse_obj(body, counts));
    text = {};
    if (!matches(*mesh, counts)) {
        problems.error({}, "tinyobjloader read this file differently from Glint's own check",
                       "this is a fault of Glint's: please report it with the file");
    } else {
        drop_triangles_without_area(*mesh, problems);
    }
    if (!problems.ok()) return problems.take_error();
    return MeshFile{std::move(mesh), problems.take_warnings()};
}

Result<MeshFile> read_obj(const std::filesystem::path &file, const ReadOptions &options) {
    try {
        const std::string name = file.string();
        Result<TextFile> text = read_text_file(file, options.max_file_bytes);
        if (text.ok()) return read_obj_text(std::move(text).value(), name, options.limits);
        Error error = std::move(text).error();
        for (Diagnostic &diagnostic : error.diagnostics) diagnostic.file = name;
        return error;
    } catch (const std::bad_alloc &) {
        return Error(ErrorCode::limit_exceeded, words("there is not enough memory to read ", in_quotes(file.string())));
    }
}

} // namespace glint
