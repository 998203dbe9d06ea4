// The directives that the SDL dialects share.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "sdl/arguments.hpp"
#include "sdl/directives.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

/// It has spoken before any other line was read (detect.cpp).
void read_dialect(const Arguments &, SceneDraft &) {}

void read_eye(const Arguments &arguments, SceneDraft &draft) {
    draft.eye = {arguments.point(0), arguments.place(2)};
}

void read_ortho(const Arguments &arguments, SceneDraft &draft) {
    const auto coordinate = [&](size_t i) { return arguments.number(i, -max_coordinate, max_coordinate); };
    const Window window = {coordinate(0), coordinate(1), coordinate(2), coordinate(3)};
    if (window.x0 == window.x1) {
        arguments.error(2, words("the window has no width: x0 and x1 are both ", in_quotes(arguments.word(2))));
    }
    if (window.y0 == window.y1) {
        arguments.error(3, words("the window has no height: y0 and y1 are both ", in_quotes(arguments.word(3))));
    }
    draft.window = {window, arguments.keyword_place()};
}

void read_size(const Arguments &arguments, SceneDraft &draft) {
    const uint64_t width = arguments.whole_number(0, 1), height = arguments.whole_number(1, 1);
    if (width == 0 || height == 0) {
        return arguments.error(width == 0 ? 0 : 1,
                               words("the picture has ", width, " x ", height, " pixels, expected at least 1 x 1"));
    }
    const uint64_t limit = draft.options.limits.max_pixels;
    const uint64_t longest_side = std::numeric_limits<uint32_t>::max();
    if (width > longest_side || height > longest_side || width > limit / height) {
        return arguments.error(0,
                               words("the picture has ", in_quotes(arguments.word(0)), " x ",
                                     in_quotes(arguments.word(1)), " pixels, the limit is ", limit, " in all"),
                               "--max-pixels raises the limit", ErrorCode::limit_exceeded);
    }
    draft.picture.width_px = static_cast<uint32_t>(width);
    draft.picture.height_px = static_cast<uint32_t>(height);
}

void read_background(const Arguments &arguments, SceneDraft &draft) {
    draft.background = arguments.numbers(0, 0.0f, max_intensity);
}

void read_ambient(const Arguments &arguments, SceneDraft &draft) {
    draft.ambient = arguments.number(0, 0.0f, max_intensity);
}

void read_max_depth(const Arguments &arguments, SceneDraft &draft) {
    const uint64_t depth = arguments.whole_number(0, 0);
    const uint32_t limit = draft.options.limits.max_depth;
    if (depth > limit) {
        return arguments.error(0, words("the depth is ", in_quotes(arguments.word(0)), ", the limit is ", limit), {},
                               ErrorCode::limit_exceeded);
    }
    draft.picture.max_depth = static_cast<uint32_t>(depth);
}

void read_output(const Arguments &arguments, SceneDraft &draft) {
    if (auto problem = draft.meshes.paths().output_problem(arguments.word(0))) {
        return arguments.error(0, std::move(*problem));
    }
    draft.output_file = std::string(arguments.word(0));
}

void read_mesh_light(const Arguments &arguments, SceneDraft &draft) {
    MeshLight light;
    light.name = std::string(arguments.word(0));
    light.color = arguments.numbers(1, 0.0f, max_intensity);
    light.intensity = arguments.number(4, 0.0f, max_intensity);
    light.mesh = read_mesh(arguments, 0, draft);
    draft.lights.push_back(std::move(light));
}

std::shared_ptr<const Mesh> read_mesh(const Arguments &arguments, size_t i, SceneDraft &draft) {
    std::shared_ptr<const Mesh> mesh = draft.meshes.find(arguments.word(i), arguments.place(i), arguments.problems());
    if (!mesh) return nullptr;
    const uint64_t limit = std::min(draft.options.limits.max_triangles, uint64_t{1} << 30);
    const bool was_within = draft.triangle_count <= limit;
    draft.triangle_count += mesh->triangles.size();
    if (was_within && draft.triangle_count > limit) {
        arguments.error(
            i, words("with this mesh the scene has ", draft.triangle_count, " triangles, the limit is ", limit), {},
            ErrorCode::limit_exceeded);
    }
    return mesh;
}

} // namespace glint
