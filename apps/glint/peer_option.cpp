// --peer: the ray tracer that Glint is measured beside.
#include "peer_option.hpp"

#include "bench/find_peer.hpp"

namespace glint::cli {

CLI::Option *add_peer(CLI::App &parser, std::string &target) {
    const CLI::Validator known(
        [](const std::string &name) {
            const auto peer = bench::find_peer(name);
            const bool unknown = !peer && peer.error().code == ErrorCode::bad_input;
            return unknown ? peer.error().diagnostics.front().message : std::string();
        },
        "");
    return parser.add_option("--peer", target, "The ray tracer to compare with: embree (default)")
        ->check(known)
        ->type_name("NAME");
}

} // namespace glint::cli
