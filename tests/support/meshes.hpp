// Small meshes to trace: each has something a tracer may stumble over.
#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <glint/scene.hpp>

namespace glint::test {

[[nodiscard]] Mesh cube();                        ///< axis-parallel, [-1, 1]^3; closed
[[nodiscard]] Mesh tetrahedron();                 ///< closed
[[nodiscard]] Mesh icosphere(int subdivisions);   ///< 20 * 4^n triangles, radius 1; closed
[[nodiscard]] Mesh torus(int around, int across); ///< not convex; closed
[[nodiscard]] Mesh terrain(int cells);            ///< height field on a regular grid
[[nodiscard]] Mesh flat_grid(int cells);          ///< all in the plane z = 0
[[nodiscard]] Mesh soup(int triangles);           ///< random triangles through each other
[[nodiscard]] Mesh slivers(int triangles);        ///< needles a thousand times longer than wide, round one corner
[[nodiscard]] Mesh stacked_copies(int copies);    ///< the same square several times: nothing but ties
[[nodiscard]] Mesh small_in_large();              ///< a millimetre sphere inside a kilometre cube; closed
[[nodiscard]] Mesh moved(Mesh mesh, Vector by);   ///< rounds to the floats that exist out there
[[nodiscard]] Mesh turned(Mesh mesh);             ///< by angles that leave no edge parallel to an axis

/// One object with this mesh, no light, default camera.
[[nodiscard]] std::shared_ptr<const Scene> scene_of(Mesh mesh);

/// Two triangles across the z axis, seen from both sides.
[[nodiscard]] std::shared_ptr<const Mesh> square(Point centre, float half);

struct NamedMesh {
    std::string name;
    Mesh mesh;
    bool closed;
};
/// How a test's parameter is printed.
inline std::ostream &operator<<(std::ostream &out, const NamedMesh &mesh) {
    return out << mesh.name;
}

/// All of the above and mixtures of them.
[[nodiscard]] std::vector<NamedMesh> all_meshes();

} // namespace glint::test
