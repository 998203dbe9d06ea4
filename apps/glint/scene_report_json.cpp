// What `glint info --json` prints for programs.
#include "scene_report.hpp"

#include <nlohmann/json.hpp>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const glm::vec3 &v) {
    return Json::array({v.x, v.y, v.z});
}

Json to_json(const Object &object) {
    const Material &m = object.material;
    return {{"name", object.name},
            {"shape", object.quadric ? "quadric" : "mesh"},
            {"triangles", object.mesh ? object.mesh->triangles.size() : 0},
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

Json to_json(const Light &light) {
    return {{"name", light.name},
            {"kind", kind_name(light.kind)},
            {"triangles", light.mesh ? light.mesh->triangles.size() : 0},
            {"color", to_json(light.color)},
            {"intensity", light.intensity}};
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

template <typename List> Json list_json(const List &list) {
    Json array = Json::array();
    for (const auto &item : list) array.push_back(to_json(item));
    return array;
}

} // namespace

std::string scene_report_json(const std::string &name, const SceneFile &file, const Accel &accel) {
    const Scene &scene = *file.scene;
    Json warnings = Json::array(), meshes = Json::array();
    for (const Diagnostic &warning : file.warnings) warnings.push_back(warning.text());
    for (const std::filesystem::path &mesh : file.mesh_files) meshes.push_back(mesh.string());

    const Json report = {{"scene", name},
                         {"dialect", {{"name", file.dialect}, {"reason", file.dialect_reason}}},
                         {"width", scene.picture().width_px},
                         {"height", scene.picture().height_px},
                         {"depth", scene.picture().max_depth},
                         {"background", to_json(scene.background())},
                         {"ambient", scene.ambient()},
                         {"camera", to_json(scene.camera())},
                         {"output", file.output_file ? Json(*file.output_file) : Json(nullptr)},
                         {"triangles", scene.triangle_count()},
                         {"objects", list_json(scene.objects())},
                         {"lights", list_json(scene.lights())},
                         {"mesh_files", std::move(meshes)},
                         {"tree", tree_json(accel)},
                         {"warnings", std::move(warnings)}};
    // A file name need not be UTF-8; JSON text must be.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace glint::cli
