// A scene's surfaces and lights as the Whitted renderer wants them.
#include "bench/peers/embree/surface_table.hpp"

#include <algorithm>

namespace glint::bench::embree {
namespace {

/// What shines, or is not there, answers no light.
Material dark() {
    Material material;
    material.diffuse = 0.0f;
    return material;
}

} // namespace

SurfaceTable::SurfaceTable(const Scene &scene)
    : rows_((scene.surface_count() + 1 + 15) / 16 * 16), floats_(rows_ * column_count) {
    std::fill_n(floats_.get(), rows_ * column_count, 0.0f);
    uint32_t row = 0;
    for (const Object &object : scene.objects()) {
        const Material &material = object.material;
        set_row(row++, material.color * (material.ambient * scene.ambient()), material);
    }
    for (size_t i = 0; i < scene.lights().size(); ++i) {
        const Light &light = scene.lights()[i];
        const Color emission = light.color * light.intensity;
        const Point &position = scene.light_positions()[i];
        lights_.push_back({position.x, position.y, position.z, emission.x, emission.y, emission.z, ~(2u << i)});
        set_row(row++, emission, dark());
    }
    set_row(row, scene.background(), dark());
}

SurfaceColumns SurfaceTable::columns() const {
    return {column(0), column(1), column(2), column(3), column(4),
            column(5), column(6), column(7), column(8), column(9)};
}

void SurfaceTable::set_row(uint32_t row, const Color &glow, const Material &material) {
    const Color diffuse = material.color * material.diffuse;
    const float values[column_count] = {glow.x,
                                        glow.y,
                                        glow.z,
                                        diffuse.x,
                                        diffuse.y,
                                        diffuse.z,
                                        material.specular,
                                        material.specular_exponent,
                                        material.reflection,
                                        material.transmission};
    for (uint32_t i = 0; i < column_count; ++i) column(i)[row] = values[i];
}

} // namespace glint::bench::embree
