// glint bench kernels: rays a second, class by class, beside another ray tracer.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glint/glint.hpp>

#include "bench/comparison_report.hpp"
#include "bench/find_peer.hpp"
#include "bench/report.hpp"
#include "bench/unsupported_feature.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "isa_option.hpp"
#include "named_scene.hpp"
#include "number_options.hpp"
#include "peer_option.hpp"
#include "scene_options.hpp"
#include "seconds_option.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(Both tracers get the same rays: primary, shadow, mirror and diffuse ones; a scene's light
meshes are left out, since shadow rays start on them. They take turns of some ten thousand
rays; the peer uses the fastest of its kernels that the instruction set allows. Building is
measured too. Hit counts that differ by more than 0.01 % of the rays end in exit code 1.

Examples:
  glint bench kernels --scene sphereflake --threads 1,2
  glint bench kernels --mesh bunny.obj --isa avx2 --json bunny.json)";

struct BenchKernelsOptions {
    SceneOptions scene;
    std::string mesh_file;
    std::string peer = "embree";
    bench::KernelComparisonOptions comparison;
    std::optional<uint32_t> size;
    std::string json_file;
};

/// What is traced, and from where it is looked at.
struct Subject {
    std::string name;
    std::shared_ptr<const Scene> scene;
    bench::Viewpoint viewpoint;
};

Result<Subject> read_mesh_subject(const BenchKernelsOptions &options) {
    const Result<MeshFile> file = read_obj(options.mesh_file, options.scene.read_options(options.mesh_file));
    if (!file) return file.error();
    for (const Diagnostic &warning : file->warnings) complain(warning.text());
    SceneBuilder builder;
    builder.add_object({"mesh", file->mesh, Material{}});
    auto scene = builder.build();
    if (!scene) return scene.error();
    return Subject{options.mesh_file, *scene, bench::viewpoint_framing(**scene)};
}

Result<Subject> read_scene_subject(const BenchKernelsOptions &options) {
    const Result<std::filesystem::path> path = find_scene(options.scene.file);
    if (!path) return path.error();
    const Result<SceneFile> file = read_scene(*path, options.scene.read_options(*path));
    if (!file) return file.error();
    complain_about(*file);
    SceneBuilder builder;
    for (const Object &object : file->scene->objects()) builder.add_object(object);
    builder.set_camera(file->scene->camera());
    auto scene = builder.build();
    if (!scene) return scene.error();
    return Subject{scene_name(options.scene.file), *scene, bench::viewpoint_of(*file->scene)};
}

Result<bench::KernelReport> measure(const Subject &subject, const bench::Peer &peer,
                                    const bench::KernelComparisonOptions &options) {
    bench::KernelReport report;
    report.machine = bench::describe_machine();
    report.peer = peer.name();
    report.mesh = subject.name;
    report.triangles = subject.scene->triangle_count();
    report.isa = isa_name(options.isa);

    auto classes = bench::compare_kernels(Accel::build(subject.scene), subject.viewpoint, peer, options);
    if (!classes) return classes.error();
    report.classes = std::move(*classes);
    for (const unsigned threads : options.threads) {
        if (options.on_progress) options.on_progress("measuring builds");
        auto build = bench::compare_builds(subject.scene, peer, options.isa, threads, options.min_seconds);
        if (!build) return build.error();
        report.builds.push_back(*build);
    }
    return report;
}

ExitCode run(BenchKernelsOptions &options) {
    const auto peer = bench::find_peer(options.peer);
    if (!peer) return fail(peer.error());
    const Result<Subject> subject =
        options.mesh_file.empty() ? read_scene_subject(options) : read_mesh_subject(options);
    if (!subject) return fail_reading(subject.error());
    if (const auto shape = bench::unsupported_shape(*subject->scene)) {
        complain(subject->name + ": the peer cannot trace " + *shape + "; there is nothing to compare");
        return ExitCode::bad_input;
    }
    if (options.size) options.comparison.size_px = *options.size;
    if (someone_watches()) {
        options.comparison.on_progress = [](const std::string &what) { complain(what); };
    }

    const Result<bench::KernelReport> report = measure(*subject, **peer, options.comparison);
    if (!report) return fail(report.error());
    print(bench::to_text(*report));
    if (!options.json_file.empty()) {
        const Status written = bench::write_report(options.json_file, bench::to_json(*report));
        if (!written) return fail(written.error());
    }
    for (const bench::ClassRow &row : report->classes) {
        if (row.agreement.hits_equal()) continue;
        complain(row.ray_class + " rays: Glint hits " + std::to_string(row.agreement.glint_hits) + ", the peer " +
                 std::to_string(row.agreement.peer_hits) + " of " + std::to_string(row.agreement.rays));
        return ExitCode::failure;
    }
    return ExitCode::ok;
}

} // namespace

Command add_bench_kernels_command(CLI::App &bench) {
    auto options = std::make_shared<BenchKernelsOptions>();
    CLI::App *kernels = bench.add_subcommand("kernels", "Rays a second and building, beside another ray tracer");
    CLI::Option *scene =
        kernels
            ->add_option("--scene", options->scene.file,
                         "A scene file, or the name of one of Glint's scenes (default: cornell, the paper's)")
            ->type_name("NAME|FILE");
    kernels->add_option("--mesh", options->mesh_file, "An OBJ file instead of a scene")
        ->type_name("FILE")
        ->excludes(scene);
    add_peer(*kernels, options->peer);
    add_number(*kernels, "--size", options->size, {1, 16384}, "Width and height of the picture (default 1024)");
    add_numbers(*kernels, "--threads", options->comparison.threads, thread_bounds, "Numbers of threads (default 1)");
    add_isa(*kernels, options->comparison.isa);
    add_seconds(*kernels, options->comparison.min_seconds, "Time each class at least this long (default 2)");
    kernels->add_option("--json", options->json_file, "Write the figures as JSON")->type_name("FILE");
    add_scene_options(*kernels, options->scene);
    kernels->footer(examples);
    return {kernels, [options] { return run(*options); }};
}

} // namespace glint::cli
