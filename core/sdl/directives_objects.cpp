// The directives that add objects: meshes and quadrics, with the dialects' orders of numbers for a material.
#include <string>
#include <utility>

#include "sdl/arguments.hpp"
#include "sdl/directives.hpp"
#include "sdl/read_shapes.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// The tolerance is the scene builder's: decimals such as 0.7 + 0.3 may round to a little more than 1. NaN, which was
/// told of already, is not too much.
bool is_more_than_all(float sum) {
    return sum > 1.0f + 1e-6f;
}

/// Shares of the colour must not be more than all of it. `at` is the place of kr.
void check_shares(const Arguments &arguments, size_t at, const Material &material) {
    if (!is_more_than_all(material.reflection + material.transmission)) return;
    arguments.error(
        at,
        words("kr + kt is more than 1 (", in_quotes(arguments.word(at)), " + ", in_quotes(arguments.word(at + 1)), ")"),
        "kr and kt are shares of the surface's colour");
}

/// More light than comes in is no error in dialects that add it to the local colour; but two rays from each hit, with
/// nothing lost, would never come to an end.
void limit_shares(const Arguments &arguments, size_t at, Material &material) {
    const float sum = material.reflection + material.transmission;
    if (!is_more_than_all(sum)) return;
    material.reflection /= sum;
    material.transmission /= sum;
    // Rounding must not bring the sum above 1 again.
    if (material.reflection + material.transmission > 1.0f) material.transmission = 1.0f - material.reflection;
    arguments.problems().warn(arguments.place(at),
                              words("kr + kt is more than 1 (", in_quotes(arguments.word(at)), " + ",
                                    in_quotes(arguments.word(at + 1)), "); both are scaled to add up to 1"));
}

/// The index of refraction at argument i. What lets nothing through needs none, and some files say 0 there.
float read_ior(const Arguments &arguments, size_t i, float transmission) {
    if (transmission == 0.0f) {
        const float ignored = arguments.number(i, 0.0f, greatest_ior);
        return ignored >= least_ior ? ignored : 1.0f;
    }
    return arguments.number(i, least_ior, greatest_ior);
}

/// r g b ka kd ks, which all dialects have, from argument i on.
Material read_base(const Arguments &arguments, size_t i) {
    const auto fraction = [&](size_t n) { return arguments.number(i + n, 0.0f, 1.0f); };
    Material material;
    material.color = arguments.numbers(i, 0.0f, 1.0f);
    material.ambient = fraction(3);
    material.diffuse = fraction(4);
    material.specular = fraction(5);
    return material;
}

/// r g b ka kd ks ke kr kt
Material read_mobile2013_material(const Arguments &arguments, size_t i) {
    Material material = read_base(arguments, i);
    material.specular_exponent = arguments.number(i + 6, 0.0f, max_intensity);
    material.reflection = arguments.number(i + 7, 0.0f, 1.0f);
    material.transmission = arguments.number(i + 8, 0.0f, 1.0f);
    check_shares(arguments, i + 7, material);
    return material;
}

/// r g b ka kd ks kt n [ior]
Material read_path2005_material(const Arguments &arguments, size_t i) {
    Material material = read_base(arguments, i);
    material.transmission = arguments.number(i + 6, 0.0f, 1.0f);
    material.specular_exponent = arguments.number(i + 7, 0.0f, max_intensity);
    if (arguments.count() > i + 8) material.ior = read_ior(arguments, i + 8, material.transmission);
    return material;
}

/// r g b ka kd ks n kr kt ior
Material read_ray2005_material(const Arguments &arguments, size_t i) {
    Material material = read_base(arguments, i);
    material.specular_exponent = arguments.number(i + 6, 0.0f, max_intensity);
    material.reflection = arguments.number(i + 7, 0.0f, 1.0f);
    material.transmission = arguments.number(i + 8, 0.0f, 1.0f);
    material.ior = read_ior(arguments, i + 9, material.transmission);
    limit_shares(arguments, i + 7, material);
    return material;
}

void add_mesh(const Arguments &arguments, SceneDraft &draft, const Vector &offset, Material material) {
    ObjectDraft entry;
    entry.offset = offset;
    Object object;
    object.name = std::string(arguments.word(0));
    object.material = std::move(material);
    object.mesh = read_mesh(arguments, 0, draft, offset, &entry.file);
    entry.parts.push_back(std::move(object));
    draft.objects.push_back(std::move(entry));
}

void add_quadric(SceneDraft &draft, const Quadric &quadric, Material material) {
    Object object;
    object.name = "quadric";
    object.material = std::move(material);
    object.quadric = quadric;
    ObjectDraft entry;
    entry.parts.push_back(std::move(object));
    draft.objects.push_back(std::move(entry));
}

} // namespace

void read_mobile2013_object(const Arguments &arguments, SceneDraft &draft) {
    add_mesh(arguments, draft, Vector(0.0f), read_mobile2013_material(arguments, 1));
}

void read_path2005_object(const Arguments &arguments, SceneDraft &draft) {
    add_mesh(arguments, draft, Vector(0.0f), read_path2005_material(arguments, 1));
}

void read_moved_object(const Arguments &arguments, SceneDraft &draft) {
    const Vector offset = arguments.point(1);
    add_mesh(arguments, draft, offset, read_ray2005_material(arguments, 4));
}

void read_mtl_object(const Arguments &arguments, SceneDraft &draft) {
    draft.objects.push_back(read_model(arguments, 0, draft));
}

void read_ray2005_quadric(const Arguments &arguments, SceneDraft &draft) {
    add_quadric(draft, read_quadric(arguments, 0), read_ray2005_material(arguments, 10));
}

void read_cg_quadric(const Arguments &arguments, SceneDraft &draft) {
    add_quadric(draft, read_cg_quadric_coefficients(arguments, 0), read_ray2005_material(arguments, 10));
}

void read_path2005_quadric(const Arguments &arguments, SceneDraft &draft) {
    add_quadric(draft, read_quadric(arguments, 0), read_path2005_material(arguments, 10));
}

} // namespace glint
