// What `glint info` prints for people.
#include "scene_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "render_statistics.hpp"

namespace glint::cli {
namespace {

// More surfaces than this would push everything else off the screen; --json has them all.
constexpr size_t most_listed = 32;

std::string triple(const glm::vec3 &v) {
    return fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z);
}

/// "12 triangles", or what a surface without a mesh is.
std::string shape_text(const Mesh *mesh) {
    return mesh ? fmt::format("{} triangles", mesh->triangles.size()) : "quadric";
}

std::string object_line(const Object &object) {
    const Material &m = object.material;
    return fmt::format("  {:<24} {:>19}  color {}  ka {:g} kd {:g} ks {:g} ke {:g} kr {:g} kt {:g} ior {:g}\n",
                       object.name, shape_text(object.mesh.get()), triple(m.color), m.ambient, m.diffuse, m.specular,
                       m.specular_exponent, m.reflection, m.transmission, m.ior);
}

std::string light_line(const Light &light) {
    const bool is_seen = light.kind == Light::Kind::surface;
    return fmt::format("  {:<24} {:>19}  color {}  intensity {:g}\n", light.name,
                       is_seen ? shape_text(light.mesh.get()) : "", triple(light.color), light.intensity);
}

template <typename Surface>
std::string surface_lines(const std::vector<Surface> &surfaces, std::string (*line)(const Surface &)) {
    std::string text;
    const size_t listed = std::min(surfaces.size(), most_listed);
    for (size_t i = 0; i < listed; ++i) text += line(surfaces[i]);
    if (listed < surfaces.size()) text += fmt::format("  and {} more\n", surfaces.size() - listed);
    return text;
}

std::string camera_line(const Camera &camera) {
    return fmt::format("camera     eye {}, window from {} along {} and {}\n", triple(camera.eye),
                       triple(camera.top_left), triple(camera.right), triple(camera.down));
}

} // namespace

std::string scene_report_text(const std::string &name, const SceneFile &file, const Accel &accel) {
    const Scene &scene = *file.scene;
    std::string text;
    text += fmt::format("scene      {}\n", name);
    text += fmt::format("dialect    {} ({})\n", file.dialect, file.dialect_reason);
    text += fmt::format("size       {}x{}\n", scene.picture().width_px, scene.picture().height_px);
    text += fmt::format("depth      {}\n", scene.picture().max_depth);
    text += fmt::format("background {}\n", triple(scene.background()));
    text += fmt::format("ambient    {:g}\n", scene.ambient());
    text += camera_line(scene.camera());
    if (file.output_file) text += fmt::format("output     {}\n", *file.output_file);
    text += fmt::format("triangles  {}\n", scene.triangle_count());
    text += fmt::format("objects    {}\n", scene.objects().size());
    text += surface_lines(scene.objects(), &object_line);
    text += fmt::format("lights     {}\n", scene.lights().size());
    text += surface_lines(scene.lights(), &light_line);
    text += fmt::format("meshes     {} file{}\n", file.mesh_files.size(), file.mesh_files.size() == 1 ? "" : "s");
    for (size_t i = 0; i < std::min(file.mesh_files.size(), most_listed); ++i) {
        text += fmt::format("  {}\n", file.mesh_files[i].string());
    }
    text += fmt::format("tree       {}\n", tree_text(accel));
    text += fmt::format("built in   {:.3f} ms\n", 1e3 * accel.statistics().build_seconds);
    text += fmt::format("warnings   {}\n", file.warnings.size());
    for (const Diagnostic &warning : file.warnings) text += warning.text() + '\n';
    return text;
}

} // namespace glint::cli
