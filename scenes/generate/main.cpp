// glint_scenes: writes the large meshes of scenes/sdl, which are made rather than stored.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "generate/models.hpp"
#include "generate/obj_writer.hpp"

int main(int argument_count, char **arguments) {
    if (argument_count != 2 || arguments[1][0] == '-') {
        std::fputs("usage: glint_scenes FOLDER\nWrites the generated OBJ files of Glint's own scenes into FOLDER.\n",
                   stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = arguments[1];
        std::filesystem::create_directories(folder);
        for (const auto &model : glint::scenes::models())
            for (const auto &file : model.make()) glint::scenes::write_obj(file, folder);
    } catch (const std::exception &problem) {
        std::fprintf(stderr, "glint_scenes: %s\n", problem.what());
        return 1;
    }
    return 0;
}
