// What the program says: results on standard output, everything else on standard error.
#include "console.hpp"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include <unistd.h>

namespace glint::cli {
namespace {

// The first thing that went wrong with standard output; 0 = nothing. One process, one standard output.
int output_error = 0;

} // namespace

void print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() && output_error == 0) output_error = errno;
}

bool finish_output() {
    if (std::fflush(stdout) != 0 && output_error == 0) output_error = errno;
    if (output_error == 0) return true;
    complain("cannot write to standard output: " + std::error_code(output_error, std::generic_category()).message());
    return false;
}

void complain(std::string_view text) {
    std::string line = "glint: ";
    line += text;
    line += '\n';
    // In one piece, so that lines of several processes do not mix. There is nowhere left to report a failure to.
    static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

bool someone_watches() {
    return ::isatty(STDERR_FILENO) == 1;
}

} // namespace glint::cli
