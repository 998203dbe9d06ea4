// glint_dump_obj FILE...: prints what read_obj() keeps of OBJ files, in the form of README.md, as the Rust program
// beside it prints what tobj reads.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string_view>

#include <glint/read.hpp>

#include "math/bits.hpp"

using namespace glint;

namespace {

void print_bits(std::initializer_list<float> numbers) {
    for (const float number : numbers) std::printf("%08" PRIx32, bit_cast<uint32_t>(number));
}

/// What a triangle has at one of its corners: position/texture coordinate/normal.
void print_corner(const Mesh &mesh, size_t triangle, uint32_t Triangle::*corner) {
    const Point &p = mesh.positions[mesh.triangles[triangle].*corner];
    std::putchar(' ');
    print_bits({p.x, p.y, p.z});
    std::putchar('/');
    if (!mesh.texcoord_corners.empty() && mesh.texcoord_corners[triangle].a != no_corner) {
        const glm::vec2 &t = mesh.texcoords[mesh.texcoord_corners[triangle].*corner];
        print_bits({t.x, t.y});
    }
    std::putchar('/');
    if (!mesh.normal_corners.empty() && mesh.normal_corners[triangle].a != no_corner) {
        const Vector &n = mesh.normals[mesh.normal_corners[triangle].*corner];
        print_bits({n.x, n.y, n.z});
    }
}

void print_mesh(const Mesh &mesh) {
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::putchar('f');
        for (const auto corner : {&Triangle::a, &Triangle::b, &Triangle::c}) print_corner(mesh, i, corner);
        std::putchar('\n');
    }
}

void print_looks(const Material &material) {
    const auto print_color = [](const Color &c) { print_bits({c.x, c.y, c.z}); };
    std::printf("looks ");
    print_color(material.color);
    std::putchar(' ');
    print_bits({material.specular});
    std::putchar(' ');
    print_color(material.highlight_color);
    for (const float number : {material.specular_exponent, material.transmission, material.ior}) {
        std::putchar(' ');
        print_bits({number});
    }
    std::puts(material.texture ? " textured" : " plain");
}

void print_refusal(const Error &error) {
    std::printf("refused: %s\n", error.diagnostics[0].message.c_str());
}

void print_as_mesh(const char *path) {
    std::printf("keeps positions\nfile %s\n", path);
    const Result<MeshFile> file = read_obj(path);
    if (!file.ok()) return print_refusal(file.error());
    print_mesh(*file->mesh);
}

void print_as_model(const char *path) {
    std::printf("keeps positions texcoords normals materials\nfile %s\n", path);
    ReadOptions options;
    // Textures are for others to read: here it matters only that there is one.
    options.read_texture = [](const std::filesystem::path &) { return Texture{1, 1, {Color(1.0f)}}; };
    const Result<ModelFile> file = read_model(path, options);
    if (!file.ok()) return print_refusal(file.error());
    for (const ModelPart &part : file->parts) {
        std::printf("material %s\n", part.material_name.c_str());
        if (!part.material_name.empty()) print_looks(part.material);
        print_mesh(*part.mesh);
    }
}

} // namespace

int main(int count, char **arguments) {
    const std::string_view how = count == 3 ? arguments[1] : "";
    if (how == "mesh") return print_as_mesh(arguments[2]), 0;
    if (how == "model") return print_as_model(arguments[2]), 0;
    return std::fputs("usage: glint_dump_obj mesh|model FILE\n", stderr), 2;
}
