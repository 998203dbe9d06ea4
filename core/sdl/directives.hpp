// What each directive does: the handlers that the table in dialects.cpp names.
#pragma once

#include <cstddef>

#include <glint/scene.hpp>

#include "sdl/dialects.hpp"

namespace glint {

// directives_picture.cpp: the picture and how it is made.
void read_dialect(const Arguments &arguments, SceneDraft &draft);
void read_size(const Arguments &arguments, SceneDraft &draft);
void read_background(const Arguments &arguments, SceneDraft &draft);
void read_ambient(const Arguments &arguments, SceneDraft &draft);
void read_max_depth(const Arguments &arguments, SceneDraft &draft);
void read_output(const Arguments &arguments, SceneDraft &draft);
void read_supersample(const Arguments &arguments, SceneDraft &draft);
void read_samples(const Arguments &arguments, SceneDraft &draft);
void read_npaths(const Arguments &arguments, SceneDraft &draft);
void read_tonemapping(const Arguments &arguments, SceneDraft &draft);
void read_seed(const Arguments &arguments, SceneDraft &draft);
void read_reflection_adds(const Arguments &arguments, SceneDraft &draft);
void read_fresnel(const Arguments &arguments, SceneDraft &draft);
void read_shadows_through_glass(const Arguments &arguments, SceneDraft &draft);

// directives_camera.cpp
void read_eye(const Arguments &arguments, SceneDraft &draft);
void read_target(const Arguments &arguments, SceneDraft &draft);
void read_up(const Arguments &arguments, SceneDraft &draft);
void read_window_size(const Arguments &arguments, SceneDraft &draft);
void read_fov(const Arguments &arguments, SceneDraft &draft);
void read_ortho(const Arguments &arguments, SceneDraft &draft);

// directives_lights.cpp
void read_mesh_light(const Arguments &arguments, SceneDraft &draft);
void read_aimed_light(const Arguments &arguments, SceneDraft &draft);
void read_white_point_light(const Arguments &arguments, SceneDraft &draft);
void read_point_light(const Arguments &arguments, SceneDraft &draft);
void read_directional_light(const Arguments &arguments, SceneDraft &draft);
void read_spot_light(const Arguments &arguments, SceneDraft &draft);
void read_quadric_light(const Arguments &arguments, SceneDraft &draft);
void read_nshadowrays(const Arguments &arguments, SceneDraft &draft);
void read_lightresolution(const Arguments &arguments, SceneDraft &draft);

// directives_objects.cpp
void read_mobile2013_object(const Arguments &arguments, SceneDraft &draft);
void read_path2005_object(const Arguments &arguments, SceneDraft &draft);
void read_moved_object(const Arguments &arguments, SceneDraft &draft);
void read_mtl_object(const Arguments &arguments, SceneDraft &draft);
void read_ray2005_quadric(const Arguments &arguments, SceneDraft &draft);
void read_cg_quadric(const Arguments &arguments, SceneDraft &draft);
void read_path2005_quadric(const Arguments &arguments, SceneDraft &draft);

// directives_motion.cpp
void read_object_move(const Arguments &arguments, SceneDraft &draft);
void read_object_turn(const Arguments &arguments, SceneDraft &draft);
void read_object_pivot(const Arguments &arguments, SceneDraft &draft);
void read_eye_move(const Arguments &arguments, SceneDraft &draft);

} // namespace glint
