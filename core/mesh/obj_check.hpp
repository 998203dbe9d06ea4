// The pass over an OBJ file's text that lets tinyobjloader see only what it reads rightly.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "text/kept_place.hpp"
#include "text/problems.hpp"

namespace glint {

/// How many elements an OBJ file has.
struct ObjCounts {
    uint64_t vertices = 0;
    uint64_t texcoords = 0;
    uint64_t normals = 0;
    uint64_t faces = 0;
    uint64_t triangles = 0; ///< once polygons are cut
};

/// What an OBJ file says about materials.
struct ObjNames {
    struct Library {
        std::string names; ///< of one file, or of several with blanks between them
        KeptPlace place;
    };
    std::vector<Library> libraries;             ///< `mtllib` lines, in order
    std::map<std::string, KeptPlace> materials; ///< that `usemtl` lines name, with the first such line's place
};

/// Corners that one face may have. PolygonCutter needs milliseconds for most polygons of that size, but seconds for the
/// worst, and that grows with the square.
inline constexpr uint64_t max_face_corners = 100000;

/// Checks every number, index and count of the file and reports what is wrong, with its place.
///
/// tinyobjloader takes "nan", "0,5" or a relative index before the first vertex without a word, so nothing reaches it
/// that has not passed here. The text is changed on the way, never in size: continued lines are joined, comments behind
/// an element become blanks, and lines that a mesh has no use for become comments. With `names`, which are added to,
/// normals, texture coordinates and `usemtl` lines are of use; without, only vertices and faces are.
[[nodiscard]] ObjCounts check_obj(std::span<char> text, Problems &problems, ObjNames *names = nullptr);

} // namespace glint
