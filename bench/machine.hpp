// The machine that a measurement was taken on.
#pragma once

#include <string>

namespace glint::bench {

/// Facts without which a timing means nothing. Empty strings where the system does not tell.
struct Machine {
    std::string cpu;         ///< the processor's name
    unsigned processors = 0; ///< logical ones that this process may use
    std::string os;          ///< e.g. "Debian GNU/Linux 12 (bookworm)"
    std::string kernel;      ///< e.g. "Linux 6.1.0 x86_64"
    std::string compiler;    ///< that built the library
    std::string glint;       ///< the library's version
};

[[nodiscard]] Machine describe_machine();

} // namespace glint::bench
