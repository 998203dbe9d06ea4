// The command line: which command was asked for, and with which exit code it ends.
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "interrupt.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples = R"(Examples:
  glint render scenes/sdl/cornell.sdl -o cornell.png
  glint view scenes/sdl/cornell.sdl
  glint info scenes/sdl/cornell.sdl
  glint inspect scenes/sdl/cornell.sdl --pixel 120,200
  glint convert scenes/sdl/cornell.sdl
  glint bench table --sizes 128,256 --depths 1,2

Exit codes: 0 ok, 1 failure, 2 usage, 3 bad input, 130 interrupted.)";

/// What CLI11 leaves out when a required thing is missing: the word that may have been meant for it.
std::string not_understood(const CLI::App &parser) {
    const std::vector<std::string> rest = parser.remaining(/*recurse=*/true);
    return rest.empty() ? std::string() : "\nNot understood: " + rest.front();
}

/// Help and version texts end here too: CLI11 throws them.
ExitCode end_of_parsing(const CLI::App &parser, const CLI::ParseError &end) {
    std::ostringstream out, err;
    const bool asked_for = parser.exit(end, out, err) == 0;
    print(out.str());
    if (asked_for) return ExitCode::ok;
    std::string message = err.str();
    while (message.ends_with('\n')) message.pop_back();
    if (end.get_name() == "RequiredError") message += not_understood(parser);
    complain(message);
    return ExitCode::usage;
}

ExitCode run(int argc, char **argv) {
    CLI::App parser("Glint renders scenes by tracing rays on this machine's processors.", "glint");
    parser.set_version_flag("--version", version_text, "Print the versions of glint and what it is built on");
    parser.require_subcommand(1);
    parser.footer(examples);
    std::vector<Command> commands = {add_render_command(parser),  add_view_command(parser),
                                     add_info_command(parser),    add_inspect_command(parser),
                                     add_convert_command(parser), add_surfaces_command(parser)};
    CLI::App *bench = parser.add_subcommand("bench", "Measure this machine");
    bench->require_subcommand(1);
    for (const auto &add_command :
         {add_bench_table_command, add_bench_frame_command, add_bench_kernels_command, add_bench_moving_command,
          add_bench_read_command, add_bench_present_command, add_bench_upscale_command}) {
        commands.push_back(add_command(*bench));
    }
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError &end) {
        return end_of_parsing(parser, end);
    }
    for (const Command &command : commands) {
        if (command.parser->parsed()) return command.run();
    }
    return ExitCode::usage; // not reached: the parser requires a command
}

} // namespace
} // namespace glint::cli

int main(int argc, char **argv) {
    using namespace glint::cli;
    handle_interrupts();
    ExitCode code = ExitCode::failure;
    try {
        code = run(argc, argv);
    } catch (const std::bad_alloc &) {
        complain("out of memory");
    } catch (const std::exception &error) {
        complain(error.what());
    }
    if (!finish_output() && code == ExitCode::ok) code = ExitCode::failure;
    return static_cast<int>(code);
}
