// What `glint info` prints for people.
#include "scene_report.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glint/quadric.hpp>

#include "render_statistics.hpp"

namespace glint::cli {
namespace {

// More surfaces than this would push everything else off the screen; --json has them all.
constexpr size_t most_listed = 32;

std::string triple(const glm::vec3 &v) {
    const glm::vec3 shown = v + 0.0f; // takes the sign off a -0
    return fmt::format("{:g} {:g} {:g}", shown.x, shown.y, shown.z);
}

/// What a quadric's measures are, with two blanks before each.
std::string measures(const Quadric &quadric) {
    const QuadricDescription description = describe_quadric(quadric);
    std::string text;
    if (description.centre) text += "  centre " + triple(*description.centre);
    if (description.axis) text += "  axis " + triple(*description.axis);
    if (!description.radii.empty()) text += description.radii.size() == 1 ? "  radius" : "  radii";
    for (const float radius : description.radii) text += fmt::format(" {:g}", radius);
    if (description.half_angle_degrees) text += fmt::format("  half angle {:g}", *description.half_angle_degrees);
    return text;
}

/// "12 triangles" or "sphere".
std::string shape_text(const Mesh *mesh, const std::optional<Quadric> &quadric) {
    if (quadric) return describe_quadric(*quadric).name;
    return mesh ? fmt::format("{} triangles", mesh->triangles.size()) : std::string();
}

std::string object_line(const Scene &scene, size_t i) {
    const Object &object = scene.objects()[i];
    const Material &m = object.material;
    std::string line =
        fmt::format("  {:<24} {:>19}  color {}  ka {:g} kd {:g} ks {:g} ke {:g} kr {:g} kt {:g} ior {:g}", object.name,
                    shape_text(object.mesh.get(), object.quadric), triple(m.color), m.ambient, m.diffuse, m.specular,
                    m.specular_exponent, m.reflection, m.transmission, m.ior);
    if (m.adds_to_local && m.reflection + m.transmission > 0.0f) line += " added";
    if (m.texture) line += fmt::format("  texture {}x{}", m.texture->width_px, m.texture->height_px);
    if (object.quadric) line += measures(*object.quadric);
    return line + '\n';
}

/// Where a light shines from and to, and how many shadow rays it gets, with two blanks before each.
std::string light_details(const Light &light, const Point &position) {
    constexpr float degrees = 57.2957795f;
    const std::string falloff = light.has_falloff ? "  falloff on" : "";
    switch (light.kind) {
    case Light::Kind::point:
        return "  at " + triple(position) + falloff;
    case Light::Kind::directional:
        return "  along " + triple(light.direction);
    case Light::Kind::spot:
        return fmt::format("  at {}  along {}  angles {:g} to {:g}{}", triple(position), triple(light.direction),
                           light.inner_angle * degrees, light.outer_angle * degrees, falloff);
    case Light::Kind::surface:
        break;
    }
    const std::string shape = light.quadric ? measures(*light.quadric) : "";
    if (light.grid_width > 0) {
        return fmt::format("{}  {}x{} shadow rays in a grid", shape, light.grid_width, light.grid_height);
    }
    if (light.shadow_rays > 1) return fmt::format("{}  {} shadow rays at random", shape, light.shadow_rays);
    return fmt::format("{}  1 shadow ray to {}", shape, triple(position));
}

std::string light_line(const Scene &scene, size_t i) {
    const Light &light = scene.lights()[i];
    const bool is_seen = light.kind == Light::Kind::surface;
    return fmt::format("  {:<24} {:>19}  color {}  intensity {:g}{}\n", light.name,
                       is_seen ? shape_text(light.mesh.get(), light.quadric) : "not seen", triple(light.color),
                       light.intensity, light_details(light, scene.light_positions()[i]));
}

std::string surface_lines(const Scene &scene, size_t count, std::string (*line)(const Scene &, size_t)) {
    std::string text;
    const size_t listed = std::min(count, most_listed);
    for (size_t i = 0; i < listed; ++i) text += line(scene, i);
    if (listed < count) text += fmt::format("  and {} more\n", count - listed);
    return text;
}

/// The dialect and why, then each kind of line that only some dialects have.
std::string dialect_lines(const SceneFile &file) {
    std::string text = fmt::format("dialect    {} ({})\n", file.dialect, file.dialect_reason);
    for (const DialectEvidence &evidence : file.dialect_evidence) {
        text += fmt::format("  line {:<6} {:<31} is {}\n", evidence.line, evidence.what,
                            fmt::join(evidence.dialects, " or "));
    }
    return text;
}

/// What most scenes leave as it is: told only where it is not.
std::string picture_extras(const Scene &scene) {
    const PictureSettings &picture = scene.picture();
    std::string text;
    if (picture.samples_per_pixel > 1 || picture.pattern != SamplePattern::centre) {
        text +=
            fmt::format("samples    {} a pixel, {}\n", picture.samples_per_pixel, sample_pattern_name(picture.pattern));
    }
    if (picture.seed != 0) text += fmt::format("seed       {}\n", picture.seed);
    if (picture.tone_scale > 0.0f) text += fmt::format("tone curve c / (c + {:g})\n", picture.tone_scale);
    if (picture.paths_per_pixel != 1) {
        text += fmt::format("paths      {} a pixel, for path tracers only\n", picture.paths_per_pixel);
    }
    if (scene.optics().fresnel) text += "fresnel    on\n";
    if (scene.optics().shadows_through_glass) text += "shadows    go through glass\n";
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
    text += dialect_lines(file);
    text += fmt::format("size       {}x{}\n", scene.picture().width_px, scene.picture().height_px);
    text += fmt::format("depth      {}\n", scene.picture().max_depth);
    text += fmt::format("background {}\n", triple(scene.background()));
    text += fmt::format("ambient    {:g}\n", scene.ambient());
    text += picture_extras(scene);
    text += camera_line(scene.camera());
    if (file.output_file) text += fmt::format("output     {}\n", *file.output_file);
    text += fmt::format("triangles  {}\n", scene.triangle_count());
    text += fmt::format("quadrics   {}\n", scene.quadric_surfaces().size());
    text += fmt::format("objects    {}\n", scene.objects().size());
    text += surface_lines(scene, scene.objects().size(), &object_line);
    text += fmt::format("lights     {}\n", scene.lights().size());
    text += surface_lines(scene, scene.lights().size(), &light_line);
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
