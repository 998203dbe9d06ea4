// Arranges a scene's materials and lights for the kernels.
#include "render/shading_tables.hpp"

#include "math/unit.hpp"
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
    shading.replaced = material.adds_to_local ? 0.0f : 1.0f;
    shading.ior = material.ior;
    shading.highlight_color = material.highlight_color;
    shading.texture = material.texture.get();
    return shading;
}

/// What the corners of a mesh's triangles have, for surfaces whose shading asks.
std::vector<TriangleDetail> details_of(const Mesh &mesh) {
    std::vector<TriangleDetail> details;
    details.reserve(mesh.triangles.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto at = [](const Triangle &t, int corner) { return corner == 0 ? t.a : corner == 1 ? t.b : t.c; };
        const Triangle &t = mesh.triangles[i];
        TriangleDetail detail{};
        detail.corners = {mesh.positions[t.a], mesh.positions[t.b], mesh.positions[t.c]};
        for (int corner = 0; corner < 3; ++corner) {
            detail.normals[corner] = glm::vec3(0.0f);
            detail.texcoords[corner] = glm::vec2(0.0f);
            if (!mesh.normal_corners.empty() && mesh.normal_corners[i].a != no_corner) {
                detail.normals[corner] = unit(mesh.normals[at(mesh.normal_corners[i], corner)]);
            }
            if (!mesh.texcoord_corners.empty() && mesh.texcoord_corners[i].a != no_corner) {
                detail.texcoords[corner] = mesh.texcoords[at(mesh.texcoord_corners[i], corner)];
            }
        }
        details.push_back(detail);
    }
    return details;
}

} // namespace

ShadingTables::ShadingTables(const Scene &scene) {
    uint32_t first_triangle = 0, first_quadric = scene.triangle_count();
    for (uint32_t s = 0; s < scene.surface_count(); ++s) {
        const SurfaceRef ref = scene.surface(s);
        const Mesh *const mesh = scene.surface_mesh(s);
        const auto triangles = mesh ? static_cast<uint32_t>(mesh->triangles.size()) : 0;
        const uint32_t quadrics = scene.surface_quadric(s) ? 1 : 0;
        if (ref.is_light) {
            const Light &light = scene.lights()[ref.index];
            lights_.add(light, scene.light_positions()[ref.index], mesh ? first_triangle : first_quadric,
                        triangles + quadrics);
            SurfaceShading shading{};
            shading.is_light = true;
            shading.emission = light.color * light.intensity;
            surfaces_.push_back(shading);
        } else {
            add_object(scene.objects()[ref.index], scene.ambient(), first_triangle);
        }
        first_triangle += triangles;
        first_quadric += quadrics;
    }
}

void ShadingTables::add_object(const Object &object, float ambient, uint32_t first_triangle) {
    SurfaceShading shading = shading_of(object.material, ambient);
    shading.first_triangle = first_triangle;
    shading.is_smooth = object.mesh && !object.mesh->normal_corners.empty();
    if (!object.mesh || object.mesh->texcoord_corners.empty()) shading.texture = nullptr;
    if (shading.is_smooth || shading.texture) {
        details_.push_back(details_of(*object.mesh));
        shading.details = details_.back().data(); // which stays where it is when the list of them grows
    }
    surfaces_.push_back(shading);
}

KernelScene ShadingTables::kernel_scene(const Accel &accel) const {
    const Scene &of = accel.scene();
    KernelScene scene{};
    scene.geometry = view_of(accel);
    scene.surfaces = surfaces_.data();
    scene.lights = lights_.entries().data();
    scene.light_count = static_cast<uint32_t>(lights_.entries().size());
    scene.seed = of.picture().seed;
    scene.background = of.background();
    scene.fresnel = of.optics().fresnel;
    scene.shadows_through_glass = of.optics().shadows_through_glass;
    scene.is_lit_plainly = lights_.are_plain() && !scene.shadows_through_glass;
    for (const SurfaceShading &surface : surfaces_) {
        const bool lets_through = surface.transmission > 0.0f;
        scene.has_refraction = scene.has_refraction || (lets_through && surface.ior != 1.0f);
        scene.may_branch = scene.may_branch || (lets_through && (surface.reflection > 0.0f || scene.fresnel));
        scene.has_additions = scene.has_additions || (!surface.is_light && surface.replaced == 0.0f);
        scene.has_details = scene.has_details || surface.details;
        const bool is_plain = surface.is_light || (!surface.details && surface.highlight_color == Color(1.0f));
        scene.is_lit_plainly = scene.is_lit_plainly && is_plain;
    }
    // Points near the world's origin have small coordinates but no smaller errors: let no offset fall below 2^-28 of
    // the scene's reach.
    const Box &bounds = scene.geometry.bounds;
    const float lo = max_abs(bounds.lo), hi = max_abs(bounds.hi);
    scene.offset_floor = 0x1p-8f * (lo > hi ? lo : hi);
    return scene;
}

} // namespace glint
