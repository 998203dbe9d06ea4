// glint_bad_messages FOLDER: prints what messages.txt of that folder of tests/sdl/bad should say.
#include <cstdio>

#include "sdl/bad_corpus.hpp"

int main(int count, char **arguments) {
    if (count != 2) return std::fputs("usage: glint_bad_messages FOLDER\n", stderr), 2;
    const std::string folder = arguments[1];
    for (const std::string &name : glint::test::bad_files(folder)) {
        std::printf("== %s\n%s\n", name.c_str(), glint::test::said_about(folder, name).c_str());
    }
    return 0;
}
