// The directives that add lights, and say how many shadow rays they get.
#include <string>

#include "scene/quadric_shape.hpp"
#include "sdl/arguments.hpp"
#include "sdl/directives.hpp"
#include "sdl/read_shapes.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// r g b I from argument i on.
Light light_with_color(const Arguments &arguments, size_t i) {
    Light light;
    light.color = arguments.numbers(i, 0.0f, max_intensity);
    light.intensity = arguments.number(i + 3, 0.0f, max_intensity);
    return light;
}

/// "falloff on" from argument i on; nothing there is "off".
bool read_falloff(const Arguments &arguments, size_t i) {
    if (arguments.count() == i) return false;
    if (arguments.word(i) != "falloff") {
        arguments.error(i,
                        words("expected 'falloff on', 'falloff off' or nothing, found ", in_quotes(arguments.word(i))));
        return false;
    }
    if (arguments.count() == i + 2) return arguments.on_or_off(i + 1);
    arguments.error(i, "'falloff' is followed by 'on' or 'off'");
    return false;
}

/// A direction from argument i on.
Vector read_direction(const Arguments &arguments, size_t i) {
    const Vector direction = arguments.point(i);
    if (direction == Vector(0.0f)) arguments.error(i, "the direction is zero");
    return direction;
}

void add_mesh_light(const Arguments &arguments, SceneDraft &draft, std::optional<Point> aim) {
    LightDraft entry;
    entry.light = light_with_color(arguments, 1);
    entry.light.name = std::string(arguments.word(0));
    entry.light.position = aim;
    entry.light.mesh = read_mesh(arguments, 0, draft, Vector(0.0f), &entry.file);
    draft.lights.push_back(std::move(entry));
}

void add(Light light, Light::Kind kind, std::string name, SceneDraft &draft) {
    light.kind = kind;
    light.name = std::move(name);
    LightDraft entry;
    entry.light = std::move(light);
    draft.lights.push_back(std::move(entry));
}

} // namespace

void read_mesh_light(const Arguments &arguments, SceneDraft &draft) {
    add_mesh_light(arguments, draft, std::nullopt);
}

void read_aimed_light(const Arguments &arguments, SceneDraft &draft) {
    add_mesh_light(arguments, draft, arguments.point(5));
}

void read_white_point_light(const Arguments &arguments, SceneDraft &draft) {
    Light light;
    light.position = arguments.point(0);
    light.intensity = arguments.number(3, 0.0f, max_intensity);
    add(std::move(light), Light::Kind::point, "point", draft);
}

void read_point_light(const Arguments &arguments, SceneDraft &draft) {
    Light light = light_with_color(arguments, 3);
    light.position = arguments.point(0);
    light.has_falloff = read_falloff(arguments, 7);
    add(std::move(light), Light::Kind::point, "point", draft);
}

void read_directional_light(const Arguments &arguments, SceneDraft &draft) {
    Light light = light_with_color(arguments, 3);
    light.direction = read_direction(arguments, 0);
    add(std::move(light), Light::Kind::directional, "directional", draft);
}

void read_spot_light(const Arguments &arguments, SceneDraft &draft) {
    constexpr float radians = 0.017453292f;
    Light light = light_with_color(arguments, 8);
    light.position = arguments.point(0);
    light.direction = read_direction(arguments, 3);
    const float inner = arguments.number(6, 0.0f, 180.0f), outer = arguments.number(7, 0.0f, 180.0f);
    if (inner > outer) {
        arguments.error(6,
                        words("the inner angle, ", in_quotes(arguments.word(6)), " degrees, is wider than the outer"));
    }
    // 180 degrees must not become more than pi by rounding.
    light.outer_angle = outer >= 180.0f ? 3.14159265f : outer * radians;
    light.inner_angle = inner >= outer ? light.outer_angle : inner * radians;
    light.has_falloff = read_falloff(arguments, 12);
    add(std::move(light), Light::Kind::spot, "spot", draft);
    draft.lights.back().inner_degrees = inner;
    draft.lights.back().outer_degrees = outer;
}

void read_quadric_light(const Arguments &arguments, SceneDraft &draft) {
    Light light = light_with_color(arguments, 10);
    light.quadric = read_quadric(arguments, 0);
    if (!quadric_problem(*light.quadric) && !quadric_shape(*light.quadric).is_bounded) {
        arguments.error(0, "a light must have bounds: only ellipsoids can glow");
    }
    add(std::move(light), Light::Kind::surface, "quadric", draft);
}

void read_nshadowrays(const Arguments &arguments, SceneDraft &draft) {
    const uint64_t count = arguments.whole_number_in(0, 0, max_samples);
    // Files with point lights only say 0.
    draft.shadow_rays = count == 0 ? 1 : static_cast<uint32_t>(count);
}

void read_lightresolution(const Arguments &arguments, SceneDraft &draft) {
    const uint64_t width = arguments.whole_number_in(0, 1, max_samples);
    const uint64_t height = arguments.whole_number_in(1, 1, max_samples);
    if (width * height > max_samples) {
        return arguments.error(0, words("the grid has ", width * height, " places, the limit is ", max_samples), {},
                               ErrorCode::limit_exceeded);
    }
    draft.grid_width = static_cast<uint32_t>(width);
    draft.grid_height = static_cast<uint32_t>(height);
}

} // namespace glint
