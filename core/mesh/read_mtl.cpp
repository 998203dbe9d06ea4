// From the text of an MTL file to materials.
#include "mesh/read_mtl.hpp"

#include <algorithm>
#include <istream>
#include <map>
#include <utility>

#include "mesh/mtl_check.hpp"
#include "mesh/obj_rules.hpp"
#include "mesh/tinyobj.hpp"
#include "text/plain_text.hpp"

namespace glint {

namespace {

MtlMaterial material_of(const MtlEntry &entry, const tinyobj::material_t &read) {
    MtlMaterial result;
    result.name = entry.name;
    Material &material = result.material;
    material.color = entry.has_color ? Color(read.diffuse[0], read.diffuse[1], read.diffuse[2]) : Color(1.0f);
    material.ambient = 1.0f;
    material.diffuse = 1.0f;
    const Color highlight(read.specular[0], read.specular[1], read.specular[2]);
    material.specular = std::max({highlight.x, highlight.y, highlight.z});
    if (material.specular > 0.0f) material.highlight_color = highlight / material.specular;
    material.specular_exponent = read.shininess;
    material.transmission = 1.0f - read.dissolve;
    material.ior = read.ior >= least_ior ? read.ior : 1.0f;
    if (entry.texture) {
        result.texture = read.diffuse_texname;
        result.texture_place = *entry.texture;
    }
    return result;
}

/// Whether tinyobjloader found the materials that check_mtl() found, with values that it lets pass.
bool matches(const std::vector<MtlEntry> &entries, const std::map<std::string, int> &numbers,
             const std::vector<tinyobj::material_t> &materials) {
    const auto in_range = [](float value, float highest) { return value >= 0.0f && value <= highest; };
    const auto is_color = [&](const tinyobj::real_t *c) {
        return in_range(c[0], 1.0f) && in_range(c[1], 1.0f) && in_range(c[2], 1.0f);
    };
    const auto is_valid = [&](const tinyobj::material_t &m) {
        return is_color(m.diffuse) && is_color(m.specular) && in_range(m.shininess, max_intensity) &&
               in_range(m.dissolve, 1.0f) && in_range(m.ior, greatest_ior);
    };
    return entries.size() == materials.size() && entries.size() == numbers.size() &&
           std::all_of(materials.begin(), materials.end(), is_valid);
}

} // namespace

Result<MtlFile> read_mtl_text(TextFile text, const std::string &name) {
    Problems problems(name);
    const auto body = plain_text_of(text, problems);
    if (!body) return problems.take_error();
    const std::vector<MtlEntry> entries = check_mtl(*body, problems);
    if (!problems.ok()) return problems.take_error();

    MtlFile file;
    if (!entries.empty()) { // of none, tinyobjloader would make one
        std::map<std::string, int> numbers;
        std::vector<tinyobj::material_t> materials;
        TextStream buffer(*body);
        std::istream stream(&buffer);
        tinyobj::LoadMtl(&numbers, &materials, &stream, nullptr, nullptr);
        if (!matches(entries, numbers, materials)) {
            tell_of_other_reading(problems);
            return problems.take_error();
        }
        file.materials.reserve(entries.size());
        for (size_t i = 0; i < entries.size(); ++i) file.materials.push_back(material_of(entries[i], materials[i]));
    }
    file.warnings = problems.take_warnings();
    return file;
}

} // namespace glint
