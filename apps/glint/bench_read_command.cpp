// glint bench read: what reading a mesh costs, beside tinyobjloader.
#include <memory>
#include <string>

#include "bench/read_comparison.hpp"
#include "bench/report.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "seconds_option.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(Both read the whole file from the start, in turns; Glint with all its checks, and with
tinyobjloader inside.

Examples:
  glint bench read scenes/sdl/generated/sphereflake_gold.obj
  glint bench read bunny.obj --seconds 10 --json read.json)";

struct BenchReadOptions {
    std::string mesh_file, json_file;
    double min_seconds = 2.0;
};

ExitCode run(const BenchReadOptions &options) {
    const Result<bench::ReadReport> report = bench::compare_reading(options.mesh_file, options.min_seconds);
    if (!report) return fail_reading(report.error());
    print(bench::to_text(*report));
    if (!options.json_file.empty()) {
        const Status written = bench::write_report(options.json_file, bench::to_json(*report));
        if (!written) return fail(written.error());
    }
    return ExitCode::ok;
}

} // namespace

Command add_bench_read_command(CLI::App &bench) {
    auto options = std::make_shared<BenchReadOptions>();
    CLI::App *read = bench.add_subcommand("read", "Reading a mesh, beside tinyobjloader");
    read->add_option("MESH", options->mesh_file, "An OBJ file")->required()->type_name("");
    add_seconds(*read, options->min_seconds, "Read for at least this long (default 2)");
    read->add_option("--json", options->json_file, "Write the figures as JSON")->type_name("FILE");
    read->footer(examples);
    return {read, [options] { return run(*options); }};
}

} // namespace glint::cli
