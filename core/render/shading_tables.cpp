// A scene's materials and lights, arranged for the kernels.
#include "render/shading_tables.hpp"

#include "render/geometry_view.hpp"

namespace glint {

namespace {

SurfaceShading shading_of(const Material &material, float ambient_intensity) {
    SurfaceShading shading{};
    shading.ambient_color = material.color * (material.ambient * ambient_intensity);
    shading.diffuse_color = material.color * material.diffuse;
    shading.specular = material.specular;
    shading.exponent = material.specular_exponent;
    shading.reflection = material.reflection;
    shading.transmission = material.transmission;
    return shading;
}

} // namespace

ShadingTables::ShadingTables(const Accel &accel) : accel_(accel) {
    const Scene &scene = accel.scene();
    for (const Object &object : scene.objects()) surfaces_.push_back(shading_of(object.material, scene.ambient()));
    uint32_t first_triangle = 0;
    for (const Object &object : scene.objects()) {
        if (object.mesh) first_triangle += static_cast<uint32_t>(object.mesh->triangles.size());
    }
    for (size_t i = 0; i < scene.lights().size(); ++i) {
        const Light &light = scene.lights()[i];
        const Color emission = light.color * light.intensity;
        const auto triangle_count = light.mesh ? static_cast<uint32_t>(light.mesh->triangles.size()) : 0;
        lights_.push_back({scene.light_positions()[i], emission, first_triangle, triangle_count});
        first_triangle += triangle_count;
        SurfaceShading shading{};
        shading.is_light = true;
        shading.emission = emission;
        surfaces_.push_back(shading);
    }
}

KernelScene ShadingTables::kernel_scene() const {
    KernelScene scene{};
    scene.geometry = view_of(accel_);
    scene.surfaces = surfaces_.data();
    scene.lights = lights_.data();
    scene.light_count = static_cast<uint32_t>(lights_.size());
    for (const SurfaceShading &surface : surfaces_) {
        scene.may_branch = scene.may_branch || (surface.reflection > 0.0f && surface.transmission > 0.0f);
    }
    scene.background = accel_.scene().background();
    // Points near the world's origin have small coordinates but no smaller errors: let no offset fall below 2^-28 of
    // the scene's reach.
    const Box &bounds = scene.geometry.bounds;
    const float lo = max_abs(bounds.lo), hi = max_abs(bounds.hi);
    scene.offset_floor = 0x1p-8f * (lo > hi ? lo : hi);
    return scene;
}

} // namespace glint
