// Ending a command because something went wrong.
#include "failure.hpp"

#include "console.hpp"

namespace glint::cli {

ExitCode fail(const Error &error) {
    complain(error.text());
    return error.code == ErrorCode::cancelled ? ExitCode::interrupted : ExitCode::failure;
}

ExitCode fail_reading(const Error &error) {
    complain(error.text());
    return ExitCode::bad_input;
}

} // namespace glint::cli
