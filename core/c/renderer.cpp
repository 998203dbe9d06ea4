// Renderers for C: their options, their trees, their threads.
#include <algorithm>
#include <span>

#include "c/render_handles.hpp"
#include "c/scene_handle.hpp"
#include "c/sized.hpp"

struct glint_task {
    std::function<void()> work;
};

namespace glint {

namespace {

static_assert(static_cast<int>(AccelKind::brute) == GLINT_ACCEL_BRUTE && static_cast<int>(Isa::wasm) == GLINT_ISA_WASM);

constexpr uint32_t most_threads = 1024;
/// Of recursive rays, as SceneLimits has it: the stacks of threads allow for so much.
constexpr int32_t greatest_depth = 1000;

glint_renderer_options default_renderer_options() {
    glint_renderer_options options = {};
    options.size = sizeof options;
    options.isa = GLINT_ISA_BEST;
    return options;
}

glint_render_options default_render_options() {
    return {sizeof(glint_render_options), nullptr, GLINT_AS_SCENE, GLINT_AS_SCENE, GLINT_AS_SCENE,
            GLINT_TRANSFER_LINEAR};
}

/// Hands tasks to the host as C knows them.
SubmitTask submit_to(glint_submit_function submit, void *user) {
    if (!submit) return {};
    return [submit, user](std::function<void()> work) { submit(user, new glint_task{std::move(work)}); };
}

bool is_available(int32_t isa) {
    const std::span<const Isa> there = available_isas();
    return std::any_of(there.begin(), there.end(), [&](Isa i) { return static_cast<int32_t>(i) == isa; });
}

/// A tree of the scene: one that another renderer has, where it was made by threads of our own. A host's may be gone
/// with the renderer it was given to.
std::shared_ptr<const Accel> accel_of(const glint_scene &scene, const AccelOptions &options) {
    if (options.submit) return Accel::build(scene.scene, options);
    const std::lock_guard lock(scene.accels_lock);
    std::weak_ptr<const Accel> &kept = scene.accels[static_cast<int>(options.kind)];
    std::shared_ptr<const Accel> accel = kept.lock();
    if (!accel) kept = accel = Accel::build(scene.scene, options);
    return accel;
}

} // namespace

const char *convert(const glint_render_options *given, RenderOptions &options) {
    glint_render_options asked = default_render_options();
    if (!take(given, asked)) return "the options are not a valid struct: see their size";
    if (asked.max_depth < GLINT_AS_SCENE || asked.max_depth > greatest_depth) {
        return "max_depth is neither GLINT_AS_SCENE nor from 0 to 1000";
    }
    if (asked.samples_per_pixel < GLINT_AS_SCENE) return "samples_per_pixel is below 0";
    if (asked.pattern < GLINT_AS_SCENE || asked.pattern > static_cast<int32_t>(SamplePattern::jittered)) {
        return "there is no such pattern of samples";
    }
    if (asked.transfer < GLINT_TRANSFER_LINEAR || asked.transfer > GLINT_TRANSFER_SRGB) {
        return "there is no such transfer curve";
    }
    options = {};
    if (asked.camera) options.camera = camera_of(*asked.camera);
    if (asked.max_depth >= 0) options.max_depth = static_cast<uint32_t>(asked.max_depth);
    if (asked.samples_per_pixel >= 0) options.samples_per_pixel = static_cast<uint32_t>(asked.samples_per_pixel);
    if (asked.pattern >= 0) options.pattern = static_cast<SamplePattern>(asked.pattern);
    options.transfer = static_cast<Transfer>(asked.transfer);
    return nullptr;
}

glint_error report(Handle &handle, const Result<RenderStatistics> &result, glint_render_statistics *place) {
    if (!result) return handle.fail(result.error());
    if (!place) return GLINT_OK;
    return give(place, glint_render_statistics{sizeof *place, result->seconds, result->primary_rays,
                                               result->shadow_rays, result->secondary_rays});
}

const char *problem_of(const glint_renderer *renderer, const glint_framebuffer *framebuffer,
                       const glint_render_statistics *place) {
    if (!is_made(renderer)) return "there is no renderer";
    if (!is_made(framebuffer)) return "there is no framebuffer";
    return place && !is_sized(place) ? "the statistics are not a valid struct: see their size" : nullptr;
}

} // namespace glint

using namespace glint;

void glint_task_run(glint_task *task) {
    const std::unique_ptr<glint_task> ours(task);
    if (ours) ours->work();
}

void glint_task_release(glint_task *task) {
    delete task;
}

glint_error glint_renderer_options_init(glint_renderer_options *options, size_t size) {
    return init(options, size, default_renderer_options());
}

glint_error glint_renderer_create(const glint_scene *scene, const glint_renderer_options *options,
                                  glint_renderer **renderer) {
    return create(renderer, [&](glint_renderer &handle) -> glint_error {
        glint_renderer_options given = default_renderer_options();
        if (!is_made(scene)) return handle.refuse("there is no scene");
        if (!take(options, given)) return handle.refuse("the options are not a valid struct: see their size");
        if (given.threads > most_threads) return handle.refuse("more than 1024 threads");
        if (given.accel < GLINT_ACCEL_AUTOMATIC || given.accel > GLINT_ACCEL_BRUTE) {
            return handle.refuse("there is no such structure to find triangles by");
        }
        if (given.isa < GLINT_ISA_BEST || given.isa > GLINT_ISA_WASM) {
            return handle.refuse("there is no such instruction set");
        }
        if (given.isa != GLINT_ISA_BEST && !is_available(given.isa)) {
            return handle.fail(GLINT_ERROR_UNSUPPORTED, "this machine or build does not have the instruction set");
        }
        const Isa isa = given.isa == GLINT_ISA_BEST ? best_isa() : static_cast<Isa>(given.isa);
        const SubmitTask submit = submit_to(given.submit, given.submit_user);
        handle.accel_options = {static_cast<AccelKind>(given.accel), given.threads, submit};
        handle.accel = accel_of(*scene, handle.accel_options);
        handle.renderer = std::make_shared<Renderer>(handle.accel, RendererOptions{given.threads, isa, submit});
        return GLINT_OK;
    });
}

void glint_renderer_release(glint_renderer *renderer) {
    release(renderer);
}

glint_error glint_renderer_set_scene(glint_renderer *renderer, const glint_scene *scene) {
    return call(renderer, [&](glint_renderer &handle) -> glint_error {
        if (!is_made(scene)) return handle.refuse("there is no scene");
        std::shared_ptr<const Accel> accel = scene->scene->is_edit_of(handle.accel->scene())
                                                 ? Accel::update(handle.accel, scene->scene)
                                                 : accel_of(*scene, handle.accel_options);
        handle.renderer->set_accel(accel);
        handle.accel = std::move(accel);
        return GLINT_OK;
    });
}

uint32_t glint_renderer_threads(const glint_renderer *renderer) {
    return is_made(renderer) ? renderer->renderer->threads() : 0;
}

int32_t glint_renderer_isa(const glint_renderer *renderer) {
    return is_made(renderer) ? static_cast<int32_t>(renderer->renderer->isa()) : GLINT_ISA_BEST;
}

const char *glint_isa_name(int32_t isa) {
    if (isa < GLINT_ISA_SCALAR || isa > GLINT_ISA_WASM) return "";
    return isa_name(static_cast<Isa>(isa)).data();
}

glint_error glint_render_options_init(glint_render_options *options, size_t size) {
    return init(options, size, default_render_options());
}

glint_error glint_renderer_render(glint_renderer *renderer, glint_framebuffer *framebuffer,
                                  const glint_render_options *options, glint_render_statistics *statistics) {
    return call(renderer, [&](glint_renderer &handle) -> glint_error {
        if (const char *const problem = problem_of(renderer, framebuffer, statistics)) return handle.refuse(problem);
        RenderOptions converted;
        if (const char *const problem = convert(options, converted)) return handle.refuse(problem);
        return report(handle, handle.renderer->render(*framebuffer->picture, converted), statistics);
    });
}
