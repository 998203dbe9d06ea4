// glint_dump_obj FILE...: prints what read_obj() keeps of OBJ files, in the form of README.md, as the Rust program
// beside it prints what tobj reads.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

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

void print_file(const char *path) {
    std::printf("file %s\n", path);
    const Result<MeshFile> file = read_obj(path);
    if (!file.ok()) {
        std::printf("refused: %s\n", file.error().diagnostics[0].message.c_str());
        return;
    }
    const Mesh &mesh = *file->mesh;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::putchar('f');
        for (const auto corner : {&Triangle::a, &Triangle::b, &Triangle::c}) print_corner(mesh, i, corner);
        std::putchar('\n');
    }
}

} // namespace

int main(int count, char **arguments) {
    std::puts("keeps positions");
    for (int i = 1; i < count; ++i) print_file(arguments[i]);
    return 0;
}
