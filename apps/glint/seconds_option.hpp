// --seconds: how long to measure.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace glint::cli {

/// Adds --seconds, from 0 to 3600. `target` must live as long as the parser.
CLI::Option *add_seconds(CLI::App &parser, double &target, const std::string &description);

} // namespace glint::cli
