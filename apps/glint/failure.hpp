// Ending a command because something went wrong.
#pragma once

#include <glint/result.hpp>

#include "exit_code.hpp"

namespace glint::cli {

/// Says what went wrong on standard error; the exit code to end with.
[[nodiscard]] ExitCode fail(const Error &error);

/// The same for a scene that could not be read: whatever the reason, the way out is another file or another flag.
[[nodiscard]] ExitCode fail_reading(const Error &error);

} // namespace glint::cli
