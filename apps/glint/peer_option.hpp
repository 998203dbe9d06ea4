// --peer: the ray tracer that Glint is measured beside.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace glint::cli {

/// Adds --peer; an unknown name ends the parse. `target` must live as long as the parser.
CLI::Option *add_peer(CLI::App &parser, std::string &target);

} // namespace glint::cli
