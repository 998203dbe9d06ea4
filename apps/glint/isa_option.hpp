// --isa: which vector instructions trace.
#pragma once

#include <CLI/CLI.hpp>

#include <glint/isa.hpp>

namespace glint::cli {

/// Adds --isa, which the environment variable GLINT_ISA gives where the command line does not. A name that is unknown
/// or not available ends the parse with a message that says which there are. `target` must live as long as the parser.
CLI::Option *add_isa(CLI::App &parser, Isa &target);

} // namespace glint::cli
