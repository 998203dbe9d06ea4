// glint render: a scene file becomes a picture.
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <glint/glint.hpp>
#include <glint/imageio.hpp>

#include "choice_option.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "frame_options.hpp"
#include "interrupt.hpp"
#include "isa_option.hpp"
#include "number_options.hpp"
#include "picture_file.hpp"
#include "progress_bar.hpp"
#include "render_statistics.hpp"
#include "sample_options.hpp"
#include "scene_options.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(Where the picture goes: to FILE; without -o to the scene's own 'output', relative to the
scene file's folder; without that to the scene's name with .png in the current folder, or
nowhere when --hash or --stats is given.

Examples:
  glint render cornell.sdl                          writes cornell.png
  glint render cornell.sdl -o big.exr --size 2048x2048 --depth 5
  glint render cornell.sdl --spp 16 --pattern stratified
  glint render cornell.sdl --hash --threads 1       prints two lines, writes nothing
  glint render juggling.sdl --frames 0..99 -o frame.%04d.png

Frame N of a scene that moves shows it N / fps seconds from its beginning. Without --frames a
picture shows the beginning.)";

constexpr double usual_fps = 25.0;

struct RenderCommandOptions {
    SceneOptions scene;
    std::string output;
    std::optional<Size> size;
    SampleOptions samples;
    std::optional<uint32_t> threads;
    AccelKind accel = AccelKind::automatic;
    Isa isa = best_isa();
    std::optional<FrameRange> frames;
    std::optional<uint32_t> fps;
    bool hash = false;
    bool stats = false;
};

class RenderJob {
public:
    explicit RenderJob(const RenderCommandOptions &options) : options_(options) {}

    ExitCode run() {
        const auto start = std::chrono::steady_clock::now();
        Result<SceneFile> file = read_scene(options_.scene.file, options_.scene.read_options(options_.scene.file));
        if (!file) return fail_reading(file.error());
        complain_about(*file);
        read_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        scene_ = file->scene;

        // Everything that can be refused is refused before the work, not after minutes of it.
        if (const ExitCode code = choose_size(); code != ExitCode::ok) return code;
        if (options_.frames) {
            if (const ExitCode code = choose_pattern(); code != ExitCode::ok) return code;
            return render_frames();
        }
        if (const ExitCode code = choose_target(*file); code != ExitCode::ok) return code;
        return render_and_report();
    }

private:
    ExitCode choose_size() {
        const PictureSettings &picture = scene_->picture();
        size_ = options_.size.value_or(Size{picture.width_px, picture.height_px});
        const uint64_t limit = options_.scene.pixel_limit();
        if (uint64_t{size_.width_px} * size_.height_px <= limit) return ExitCode::ok;
        complain(fmt::format("--size: {}x{} is more than {} pixels; raise the limit with --max-pixels", size_.width_px,
                             size_.height_px, limit));
        return ExitCode::usage;
    }

    ExitCode choose_target(const SceneFile &file) {
        const bool user_chose = !options_.output.empty();
        if (user_chose) {
            target_ = options_.output;
        } else if (file.output_file || !(options_.hash || options_.stats)) {
            Result<std::filesystem::path> chosen = default_picture_file(options_.scene, file);
            if (!chosen) return fail_reading(chosen.error());
            target_ = std::move(*chosen);
        }
        if (!target_) return ExitCode::ok;

        const Status writable = check_image_file(*target_);
        if (writable) return ExitCode::ok;
        const ExitCode code = fail(writable.error());
        if (writable.error().code != ErrorCode::bad_input) return code;
        return user_chose ? ExitCode::usage : ExitCode::bad_input; // whoever named the file
    }

    /// Where frames go.
    ExitCode choose_pattern() {
        if (!scene_->animation()) complain("nothing moves in this scene: all frames will be the same");
        if (options_.output.empty()) {
            if (options_.hash || options_.stats) return ExitCode::ok;
            complain("--frames: needs -o with a place for the frame's number, like -o frame.%04d.png");
            return ExitCode::usage;
        }
        Result<FramePattern> pattern = FramePattern::parse(options_.output);
        if (!pattern) {
            complain(pattern.error().text());
            return ExitCode::usage;
        }
        pattern_ = std::move(*pattern);
        target_ = pattern_->file(options_.frames->first);
        const Status writable = check_image_file(*target_);
        if (writable) return ExitCode::ok;
        const ExitCode code = fail(writable.error());
        return writable.error().code == ErrorCode::bad_input ? ExitCode::usage : code;
    }

    ExitCode render_frames() {
        const double fps = options_.fps ? static_cast<double>(*options_.fps) : usual_fps;
        std::shared_ptr<const Accel> accel =
            Accel::build(scene_, {.kind = options_.accel, .threads = options_.threads.value_or(0)});
        Renderer renderer(accel, {.threads = options_.threads.value_or(0), .isa = options_.isa});
        const bool with_radiance = options_.hash || (target_ && image_needs_radiance(*target_));
        Result<Framebuffer> picture = Framebuffer::create(size_.width_px, size_.height_px, with_radiance);
        if (!picture) return fail(picture.error());

        RenderControl control;
        const InterruptGuard guard(control);
        for (uint32_t frame = options_.frames->first; frame <= options_.frames->last; ++frame) {
            const auto scene = scene_at(scene_, frame / fps);
            if (!scene) return fail(scene.error());
            accel = Accel::update(accel, *scene);
            renderer.set_accel(accel);
            const Result<RenderStatistics> statistics = render(renderer, *picture, control);
            if (!statistics) return fail(statistics.error());
            if (options_.hash) {
                print(fmt::format("frame {} pixels {:016x} radiance {:016x}\n", frame, picture->pixel_hash(),
                                  picture->radiance_hash()));
            }
            if (pattern_) {
                const std::filesystem::path file = pattern_->file(frame);
                if (const Status written = write_image(file, *picture, &control); !written)
                    return fail(written.error());
                print(fmt::format("wrote {} ({}x{})\n", file.string(), size_.width_px, size_.height_px));
            }
            if (options_.stats) print(render_statistics_text(renderer, *statistics, read_seconds_));
        }
        return ExitCode::ok;
    }

    ExitCode render_and_report() {
        const unsigned threads = options_.threads.value_or(0);
        Renderer renderer(Accel::build(scene_, {.kind = options_.accel, .threads = threads}),
                          {.threads = threads, .isa = options_.isa});
        const bool with_radiance = options_.hash || (target_ && image_needs_radiance(*target_));
        Result<Framebuffer> picture = Framebuffer::create(size_.width_px, size_.height_px, with_radiance);
        if (!picture) return fail(picture.error());

        RenderControl control;
        const InterruptGuard guard(control);
        const Result<RenderStatistics> statistics = render(renderer, *picture, control);
        if (!statistics) return fail(statistics.error());

        if (options_.hash) {
            print(fmt::format("pixels {:016x}\nradiance {:016x}\n", picture->pixel_hash(), picture->radiance_hash()));
        }
        if (target_) {
            if (const Status written = write_image(*target_, *picture, &control); !written)
                return fail(written.error());
            print(fmt::format("wrote {} ({}x{})\n", target_->string(), size_.width_px, size_.height_px));
        }
        if (options_.stats) print(render_statistics_text(renderer, *statistics, read_seconds_));
        return ExitCode::ok;
    }

    Result<RenderStatistics> render(Renderer &renderer, Framebuffer &picture, RenderControl &control) const {
        const ProgressBar progress(control);
        return renderer.render(picture, options_.samples.render_options(), &control);
    }

    const RenderCommandOptions &options_;
    std::shared_ptr<const Scene> scene_;
    Size size_{};
    std::optional<std::filesystem::path> target_;
    std::optional<FramePattern> pattern_; ///< of frames
    double read_seconds_ = 0.0;
};

} // namespace

Command add_render_command(CLI::App &parser) {
    auto options = std::make_shared<RenderCommandOptions>();
    CLI::App *render = parser.add_subcommand("render", "Render a scene to an image file");
    render->add_option("SCENE", options->scene.file, "The scene file (SDL)")->required()->type_name("");
    std::string extensions;
    for (const std::string &extension : image_extensions()) extensions += (extensions.empty() ? "" : " ") + extension;
    render->add_option("-o,--output", options->output, "Image file, in the format of its extension: " + extensions)
        ->type_name("FILE");
    add_size(*render, "--size", options->size, "Picture size (default: the scene's)");
    add_sample_options(*render, options->samples);
    add_number(*render, "--threads", options->threads, thread_bounds, "Threads (default: one a processor)");
    add_choice(*render, "--accel", options->accel,
               {{"automatic", AccelKind::automatic},
                {"kdtree", AccelKind::kdtree},
                {"bvh", AccelKind::bvh},
                {"brute", AccelKind::brute}},
               "How rays find triangles: a kd-tree or, for many triangles, a bounding volume hierarchy "
               "(automatic), one of them, or testing all");
    add_isa(*render, options->isa);
    CLI::Option *frames = add_frame_range(*render, "--frames", options->frames,
                                          "Render these frames of a scene that moves; -o then has a %d");
    add_number(*render, "--fps", options->fps, {1, 100'000}, "Frames a second of the scene's time (default 25)")
        ->needs(frames);
    render->add_flag("--hash", options->hash, "Print XXH3-64 hashes of the picture's bytes and of its linear floats");
    render->add_flag("--stats", options->stats, "Print times, rays and the tree's figures");
    add_scene_options(*render, options->scene);
    render->footer(examples);
    return {render, [options] { return RenderJob(*options).run(); }};
}

} // namespace glint::cli
