// glint_check_pictures ISA PIXELS SCENE...: renders the golden pictures of some scenes, those of at most so many
// pixels, with one instruction set and prints the table's lines as they are now; exit code 1 where one has changed. For
// machines that have no GoogleTest.
#include <cstdio>
#include <cstdlib>

#include "golden/golden_table.hpp"
#include "support/picture.hpp"

using namespace glint;
using namespace glint::test;

namespace {

const std::filesystem::path source = GLINT_SOURCE_DIR;

/// The number of the scene's pictures that are as they were; throws where there are none, or one is not.
int check_scene(const std::string &scene, Isa isa, uint64_t most_pixels) {
    const auto file = read_scene(source / "scenes" / "sdl" / (scene + ".sdl"));
    if (!file) throw std::runtime_error(file.error().text());
    const auto accel = Accel::build(file->scene);
    int pictures = 0, changed = 0;
    for (Golden golden : golden_table(source / "tests" / "golden" / "pictures.txt")) {
        if (golden.scene != scene || uint64_t{golden.width} * golden.height > most_pixels) continue;
        const Framebuffer picture = render(accel, golden.width, golden.height, golden.depth, {2, isa});
        const bool is_the_same = hashes_of(picture) == golden.hashes;
        golden.hashes = hashes_of(picture);
        std::ostringstream line;
        line << golden;
        std::printf("%s%s\n", line.str().c_str(), is_the_same ? "" : " CHANGED");
        ++pictures;
        changed += !is_the_same;
    }
    if (pictures == 0) throw std::runtime_error("there are no pictures of " + scene);
    if (changed > 0) throw std::runtime_error(std::to_string(changed) + " pictures of " + scene + " have changed");
    return pictures;
}

} // namespace

int main(int count, char **arguments) {
    if (count < 4) return std::fputs("usage: glint_check_pictures ISA PIXELS SCENE...\n", stderr), 2;
    const Result<Isa> isa = find_isa(arguments[1]);
    if (!isa) return std::fprintf(stderr, "%s\n", isa.error().text().c_str()), 2;
    int pictures = 0;
    try {
        const uint64_t most_pixels = std::strtoull(arguments[2], nullptr, 10);
        for (int i = 3; i < count; ++i) pictures += check_scene(arguments[i], *isa, most_pixels);
    } catch (const std::exception &error) {
        return std::fprintf(stderr, "%s\n", error.what()), 1;
    }
    std::printf("%d pictures as they were, with %s\n", pictures, arguments[1]);
    return 0;
}
