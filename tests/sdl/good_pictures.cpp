// glint_good_pictures [SCENE...]: prints the lines of tests/sdl/good/hashes.txt as they are now, by the scalar kernel,
// for the scenes named or for all.
#include <cstdio>

#include "sdl/good_corpus.hpp"

using namespace glint;
using namespace glint::test;

int main(int count, char **arguments) {
    std::vector<std::string> scenes(arguments + 1, arguments + count);
    if (scenes.empty()) scenes = good_scenes();
    try {
        for (const std::string &scene : scenes) {
            const PictureHashes hashes = picture_of_good_scene(scene, Isa::scalar);
            std::printf("%s %s %s\n", scene.c_str(), hashes.pixels.c_str(), hashes.radiance.c_str());
        }
    } catch (const std::exception &error) {
        return std::fprintf(stderr, "%s\n", error.what()), 1;
    }
    return 0;
}
