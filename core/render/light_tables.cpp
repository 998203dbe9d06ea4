// A scene's lights, arranged for the kernels.
#include "render/light_tables.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/light_places.hpp"
#include "math/unit.hpp"

namespace glint {

namespace {

/// What does not depend on the place.
LightShading light_shading(const Light &light, const Point &position, uint32_t first, uint32_t count) {
    LightShading shading{};
    shading.kind = light.kind;
    shading.has_falloff = light.has_falloff;
    shading.position = position;
    shading.direction = unit(light.direction);
    shading.emission = light.color * light.intensity;
    shading.first_triangle = first;
    shading.triangle_count = count;
    if (light.kind == Light::Kind::spot) {
        const double inner = std::cos(double(light.inner_angle)), outer = std::cos(double(light.outer_angle));
        shading.cos_outer = static_cast<float>(outer);
        shading.inverse_fade = inner - outer > 1e-30 ? static_cast<float>(1.0 / (inner - outer)) : 1e30f;
    }
    return shading;
}

/// Whether it shines from places on its mesh.
bool has_area(const Light &light) {
    return light.mesh && !light.position;
}

} // namespace

uint32_t LightTables::entries_of(const Light &light) {
    if (!has_area(light)) return 1;
    const uint32_t cells = light.grid_width * light.grid_height;
    return cells > 0 ? cells : light.shadow_rays;
}

void LightTables::add(const Light &light, const Point &position, uint32_t first, uint32_t count) {
    LightShading entry = light_shading(light, position, first, count);
    const uint32_t cells = light.grid_width * light.grid_height;
    const uint32_t places = entries_of(light);
    if (!has_area(light) || (places == 1 && cells == 0)) {
        entries_.push_back(entry);
        return;
    }
    auto area = std::make_unique<Area>();
    area->mesh = light.mesh;
    area->cumulative = cumulative_area(*light.mesh);
    area->view = {area->mesh.get(), area->cumulative.data()};
    entry.emission = entry.emission * (1.0f / static_cast<float>(places));
    for (uint32_t i = 0; i < places; ++i) {
        if (cells > 0) {
            const auto middle = [](uint32_t cell, uint32_t of) {
                return (static_cast<float>(cell) + 0.5f) / static_cast<float>(of);
            };
            entry.position = place_on(area->view, middle(i % light.grid_width, light.grid_width),
                                      middle(i / light.grid_width, light.grid_height));
        } else {
            entry.area = &area->view;
            entry.sample = i;
            entry.sample_count = places;
        }
        entries_.push_back(entry);
    }
    areas_.push_back(std::move(area));
}

bool LightTables::are_plain() const {
    return std::all_of(entries_.begin(), entries_.end(), [](const LightShading &light) {
        const bool has_place = light.kind == Light::Kind::surface || light.kind == Light::Kind::point;
        return has_place && !light.has_falloff && !light.area;
    });
}

} // namespace glint
