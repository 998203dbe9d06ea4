// The models that glint_scenes knows, each a set of OBJ files that one scene of scenes/sdl uses.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "generate/mesh.hpp"

namespace glint::scenes {

/// Eric Haines' sphereflake, one file to each of its five generations of spheres.
[[nodiscard]] std::vector<NamedMesh> sphereflake();
/// A block of mountains around a lake, one file to each kind of ground; together they are closed.
[[nodiscard]] std::vector<NamedMesh> terrain();
/// A clockwork of involute gears on a table, one file to each metal.
[[nodiscard]] std::vector<NamedMesh> gears();
/// A room of four mirror walls and what stands in it, one file to each material.
[[nodiscard]] std::vector<NamedMesh> mirrors();
/// Sixteen lamps in a ring, a file each, and the pieces they light.
[[nodiscard]] std::vector<NamedMesh> lights16();

struct Model {
    std::string_view name;
    std::function<std::vector<NamedMesh>()> make;
};

/// All of them.
[[nodiscard]] inline std::vector<Model> models() {
    return {{"sphereflake", sphereflake},
            {"terrain", terrain},
            {"gears", gears},
            {"mirrors", mirrors},
            {"lights16", lights16}};
}

} // namespace glint::scenes
