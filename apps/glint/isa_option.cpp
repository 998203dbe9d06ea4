// --isa: which vector instructions trace.
#include "isa_option.hpp"

#include <string>

namespace glint::cli {

CLI::Option *add_isa(CLI::App &parser, Isa &target) {
    const auto read = [&parser, &target](const std::string &name) {
        if (!parser.parsed()) return; // the environment is read for every command, also for those that do not run
        const Result<Isa> isa = find_isa(name);
        if (!isa) throw CLI::ValidationError("--isa", isa.error().diagnostics.front().message);
        target = *isa;
    };
    return parser
        .add_option_function<std::string>("--isa", read, "Instruction set that traces (default: the best there is)")
        ->envname("GLINT_ISA")
        ->type_name("NAME");
}

} // namespace glint::cli
