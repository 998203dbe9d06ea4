// What `glint info --json` prints for programs.
#include "scene_report.hpp"

#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include <glint/quadric.hpp>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const glm::vec3 &v) {
    return Json::array({v.x, v.y, v.z});
}

Json to_json(float value) {
    return value;
}

Json to_json(const Quadric &q);

template <typename Value> Json or_null(const std::optional<Value> &value) {
    return value ? to_json(*value) : Json(nullptr);
}

Json to_json(const Quadric &q) {
    const QuadricDescription description = describe_quadric(q);
    return {{"name", description.name},
            {"coefficients", {q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.j, q.k}},
            {"centre", or_null(description.centre)},
            {"axis", or_null(description.axis)},
            {"radii", description.radii},
            {"half_angle_degrees", or_null(description.half_angle_degrees)}};
}

Json to_json(const Object &object) {
    const Material &m = object.material;
    return {{"name", object.name},
            {"shape", object.quadric ? "quadric" : "mesh"},
            {"triangles", object.mesh ? object.mesh->triangles.size() : 0},
            {"quadric", or_null(object.quadric)},
            {"color", to_json(m.color)},
            {"ka", m.ambient},
            {"kd", m.diffuse},
            {"ks", m.specular},
            {"ke", m.specular_exponent},
            {"kr", m.reflection},
            {"kt", m.transmission},
            {"ior", m.ior},
            {"reflection_adds", m.adds_to_local}};
}

const char *kind_name(Light::Kind kind) {
    switch (kind) {
    case Light::Kind::surface:
        return "surface";
    case Light::Kind::point:
        return "point";
    case Light::Kind::directional:
        return "directional";
    case Light::Kind::spot:
        return "spot";
    }
    return "";
}

/// `position` is where a single shadow ray to the light aims.
Json to_json(const Light &light, const Point &position) {
    constexpr float degrees = 57.2957795f;
    const bool is_surface = light.kind == Light::Kind::surface, is_spot = light.kind == Light::Kind::spot;
    const bool has_direction = is_spot || light.kind == Light::Kind::directional;
    const bool has_grid = light.grid_width > 0;
    return {{"name", light.name},
            {"kind", kind_name(light.kind)},
            {"triangles", light.mesh ? light.mesh->triangles.size() : 0},
            {"quadric", or_null(light.quadric)},
            {"color", to_json(light.color)},
            {"intensity", light.intensity},
            {"position", light.kind == Light::Kind::directional ? Json(nullptr) : to_json(position)},
            {"direction", has_direction ? to_json(light.direction) : Json(nullptr)},
            {"inner_degrees", is_spot ? Json(light.inner_angle * degrees) : Json(nullptr)},
            {"outer_degrees", is_spot ? Json(light.outer_angle * degrees) : Json(nullptr)},
            {"falloff", light.has_falloff},
            {"shadow_rays", is_surface && has_grid ? light.grid_width * light.grid_height : light.shadow_rays},
            {"shadow_grid", has_grid ? Json::array({light.grid_width, light.grid_height}) : Json(nullptr)}};
}

Json to_json(const Camera &camera) {
    return {{"eye", to_json(camera.eye)},
            {"top_left", to_json(camera.top_left)},
            {"right", to_json(camera.right)},
            {"down", to_json(camera.down)}};
}

Json tree_json(const Accel &accel) {
    const AccelStatistics &tree = accel.statistics();
    const double triangles = tree.triangles == 0 ? 1.0 : tree.triangles;
    return {{"kind", accel_kind_name(accel.kind())},
            {"triangles", tree.triangles},
            {"nodes", tree.nodes},
            {"leaves", tree.leaves},
            {"empty_leaves", tree.empty_leaves},
            {"references", tree.references},
            {"references_per_triangle", static_cast<double>(tree.references) / triangles},
            {"depth", tree.depth},
            {"sah_cost", tree.sah_cost},
            {"bytes", tree.bytes},
            {"bytes_per_triangle", static_cast<double>(tree.bytes) / triangles},
            {"build_ms", 1e3 * tree.build_seconds}};
}

Json objects_json(const Scene &scene) {
    Json array = Json::array();
    for (const Object &object : scene.objects()) array.push_back(to_json(object));
    return array;
}

Json lights_json(const Scene &scene) {
    Json array = Json::array();
    for (size_t i = 0; i < scene.lights().size(); ++i) {
        array.push_back(to_json(scene.lights()[i], scene.light_positions()[i]));
    }
    return array;
}

Json dialect_json(const SceneFile &file) {
    Json evidence = Json::array();
    for (const DialectEvidence &one : file.dialect_evidence) {
        evidence.push_back({{"line", one.line}, {"what", one.what}, {"dialects", one.dialects}});
    }
    return {{"name", file.dialect}, {"reason", file.dialect_reason}, {"evidence", std::move(evidence)}};
}

} // namespace

std::string scene_report_json(const std::string &name, const SceneFile &file, const Accel &accel) {
    const Scene &scene = *file.scene;
    Json warnings = Json::array(), meshes = Json::array();
    for (const Diagnostic &warning : file.warnings) warnings.push_back(warning.text());
    for (const std::filesystem::path &mesh : file.mesh_files) meshes.push_back(mesh.string());

    const Json report = {{"scene", name},
                         {"dialect", dialect_json(file)},
                         {"width", scene.picture().width_px},
                         {"height", scene.picture().height_px},
                         {"depth", scene.picture().max_depth},
                         {"samples_per_pixel", scene.picture().samples_per_pixel},
                         {"pattern", sample_pattern_name(scene.picture().pattern)},
                         {"seed", scene.picture().seed},
                         {"tone_scale", scene.picture().tone_scale},
                         {"paths_per_pixel", scene.picture().paths_per_pixel},
                         {"fresnel", scene.optics().fresnel},
                         {"shadows_through_glass", scene.optics().shadows_through_glass},
                         {"background", to_json(scene.background())},
                         {"ambient", scene.ambient()},
                         {"camera", to_json(scene.camera())},
                         {"output", file.output_file ? Json(*file.output_file) : Json(nullptr)},
                         {"triangles", scene.triangle_count()},
                         {"quadrics", scene.quadric_surfaces().size()},
                         {"objects", objects_json(scene)},
                         {"lights", lights_json(scene)},
                         {"mesh_files", std::move(meshes)},
                         {"tree", tree_json(accel)},
                         {"warnings", std::move(warnings)}};
    // A file name need not be UTF-8; JSON text must be.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace glint::cli
