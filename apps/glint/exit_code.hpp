// How the program ends: what scripts may rely on.
#pragma once

namespace glint::cli {

enum class ExitCode {
    ok = 0,
    failure = 1,       ///< the system or the machine refused: disk full, no such device, library missing
    usage = 2,         ///< the command line makes no sense
    bad_input = 3,     ///< the scene, or a file it names, cannot be used
    interrupted = 130, ///< SIGINT or SIGTERM, as a shell reports them
};

} // namespace glint::cli
