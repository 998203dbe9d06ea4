// What holds for every OBJ file, whether its shape alone is wanted or its materials too.
#include "mesh/obj_rules.hpp"

#include <algorithm>

#include "text/words.hpp"

namespace glint {

void check_counts(const ObjCounts &counts, const SceneLimits &limits, Problems &problems) {
    const uint64_t most_triangles = std::min(limits.max_triangles, uint64_t{1} << 30);
    if (counts.triangles > most_triangles) {
        problems.error({}, words("the mesh has ", counts.triangles, " triangles, the limit is ", most_triangles), {},
                       ErrorCode::limit_exceeded);
    }
    const uint64_t most_elements = (uint64_t{1} << 31) - 1; // tinyobjloader's indices are int
    const auto check = [&](uint64_t count, const char *what) {
        if (count <= most_elements) return;
        problems.error({}, words("the mesh has ", count, ' ', what, ", the limit is ", most_elements), {},
                       ErrorCode::limit_exceeded);
    };
    check(counts.vertices, "vertices");
    check(counts.normals, "normals");
    check(counts.texcoords, "texture coordinates");
    if (counts.faces == 0) problems.error({}, "the file has no face ('f'), so there is nothing to see");
}

void tell_of_other_reading(Problems &problems) {
    problems.error({}, "tinyobjloader read this file differently from Glint's own check",
                   "this is a fault of Glint's: please report it with the file");
}

void tell_of_triangles_without_area(uint64_t left_out, uint64_t all, Problems &problems) {
    if (left_out == all) {
        problems.error({}, "none of the mesh's triangles has an area");
    } else if (left_out > 0) {
        problems.warn({}, words(left_out, " of the mesh's ", all, " triangles have no area and are left out"));
    }
}

} // namespace glint
