// glint_random_calls [COUNT [SEED]]: calls all functions of the C interface in random order with random arguments.
//
// Handles come from a small pool: made or failed ones, NULL, ones of another kind. They are released in any order,
// while jobs still work with them. What must hold after each call is checked; the sanitizers see the rest.
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <glint/glint.h>

#include "c/random_values.hpp"

namespace {

using glint::test::Roomy;

[[noreturn]] void give_up(const char *what, const char *why) {
    std::fprintf(stderr, "%s: %s\n", what, why);
    std::abort();
}

constexpr uint32_t slots = 3;
const char *const texts[] = {
    "eye 0 0 5.7\nsize 12 8\northo -1 -1 1 1\nbackground 0 0 1\nambient 1\nmax_depth 2\nlight lamp.obj 1 1 1 1\n"
    "object floor.obj 1 0 0 0.3 0.7 0 0 0.2 0\n",
    "dialect glint\neye 0 0 5\nlight lamp.obj 1 1 1 1\nobjectquadric 1 1 1 0 0 0 0 0 0 -1 1 1 1 0 1 0 0 0.5 0.4 1.5\n",
    "eye 0 0,5 5.7\n",
    "",
};
const char floor_text[] = "v -1 -0.8 -4\nv 1 -0.8 -4\nv 1 -0.8 -2\nv -1 -0.8 -2\nf 1 2 3\nf 1 3 4\n";
const char lamp_text[] = "v -0.2 0.9 -4\nv 0.2 0.9 -4\nv 0.2 0.9 -2\nf 1 2 3\n";

/// Handles of one kind.
template <typename H> struct Pool {
    void (*release)(H *);
    H *handles[slots] = {};
};

/// The host: its threads' tasks, its memory.
struct Host {
    std::mutex lock;
    std::vector<glint_task *> kept;
    std::atomic<uint32_t> tasks = 0, done = 0;

    static void submit(void *user, glint_task *task) {
        Host &host = *static_cast<Host *>(user);
        switch (host.tasks++ % 3) {
        case 0:
            return glint_task_run(task);
        case 1:
            return glint_task_release(task);
        default:
            const std::lock_guard guard(host.lock);
            host.kept.push_back(task);
        }
    }
    static void be_told(void *user) { ++static_cast<Host *>(user)->done; }
    /// Runs or gives up all that is kept, in no order.
    void work(glint::test::RandomValues &random) {
        std::vector<glint_task *> tasks_now;
        {
            const std::lock_guard guard(lock);
            tasks_now.swap(kept);
        }
        for (glint_task *task : tasks_now) random.once_in(4) ? glint_task_release(task) : glint_task_run(task);
    }
};

class Caller {
public:
    explicit Caller(uint64_t seed) : random_(seed) { list_calls(); }
    ~Caller();

    void call() { calls_[random_.below(static_cast<uint32_t>(calls_.size()))](); }

    /// Prints how often functions did what they were asked for and how often they refused; each must have done both.
    [[nodiscard]] bool report() const;

private:
    void list_calls();
    void list_scene_calls();
    void list_builder_calls();
    void list_renderer_calls();
    void list_view_calls();

    void often(uint32_t times, const std::function<void()> &call) { calls_.insert(calls_.end(), times, call); }

    /// A handle of the pool's; now and then NULL or one of another kind.
    template <typename H> H *any(Pool<H> &pool) {
        if (random_.once_in(40)) return reinterpret_cast<H *>(framebuffers_.handles[random_.below(slots)]);
        H *handle = nullptr;
        for (int tries = 0; !handle && tries < 4; ++tries) handle = pool.handles[random_.below(slots)];
        return random_.once_in(30) ? nullptr : handle;
    }

    glint_error check(glint_error code, const char *what) {
        if (code < GLINT_OK || code > GLINT_ERROR_OUT_OF_MEMORY) give_up(what, glint_error_name(code));
        Tally &tally = tallies_[what];
        ++(code == GLINT_OK ? tally.successes : tally.failures);
        return code;
    }

    /// Puts into a slot what `create` leaves, after releasing what was there.
    template <typename H, typename Create> void make(Pool<H> &pool, const char *what, Create &&create) {
        if (random_.once_in(50)) {
            if (check(create(nullptr), what) == GLINT_OK) give_up(what, "made something nowhere");
            return;
        }
        H *made = nullptr;
        const glint_error code = check(create(&made), what);
        if (!made) give_up(what, "left no handle");
        if ((*glint_last_error_message(made) == '\0') != (code == GLINT_OK))
            give_up(what, "does not say why it failed");
        // What failed is seldom kept, or there would be little else.
        if (code == GLINT_OK || random_.once_in(8)) std::swap(made, pool.handles[random_.below(slots)]);
        pool.release(made);
    }

    template <typename H> void list_release(Pool<H> &pool) {
        often(1, [&] {
            H *&slot = pool.handles[random_.below(slots)];
            if (random_.once_in(3)) pool.release(std::exchange(slot, nullptr));
        });
    }

    /// Calls `get` for a struct that the library fills, and holds it to writing nothing when it fails.
    template <typename T, typename Get> void look(const char *what, Get &&get) {
        Roomy<T> place;
        T *const given = random_.once_in(30) ? nullptr : place.sized(random_);
        place.remember();
        if (check(get(given), what) != GLINT_OK && !place.is_untouched()) give_up(what, "wrote something and failed");
    }
    /// The same of a struct without a size.
    template <typename T, typename Get> void look_at_plain(const char *what, Get &&get) {
        T place;
        std::memset(&place, 0x5a, sizeof place);
        const T before = place;
        if (check(get(random_.once_in(30) ? nullptr : &place), what) != GLINT_OK &&
            std::memcmp(&place, &before, sizeof place) != 0) {
            give_up(what, "wrote something and failed");
        }
    }

    glint_camera camera() {
        glint_camera made = {{0, 0, 5.7f}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0}};
        if (random_.once_in(3)) random_.fill(made.eye);
        if (random_.once_in(6)) random_.fill(made.top_left);
        if (random_.once_in(6)) random_.fill(made.right);
        return made;
    }
    glint_pose pose() {
        float axis[3], by[3];
        random_.fill(axis), random_.fill(by);
        glint_pose made = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
        check(glint_pose_turned(axis, random_.number(), nullptr, random_.once_in(2) ? by : nullptr, &made), "turned");
        if (random_.once_in(10)) random_.fill(made.y);
        return made;
    }
    const glint_render_options *render_options(Roomy<glint_render_options> &options, glint_camera &place) {
        if (random_.once_in(4)) return nullptr;
        glint_render_options_init(options.get(), sizeof(glint_render_options));
        place = camera();
        if (random_.once_in(3)) options->camera = &place;
        if (random_.once_in(2))
            options->max_depth = random_.one_of({-1, 0, 1, 3, 1000, 1001, -2, INT32_MAX, INT32_MIN});
        if (random_.once_in(3)) options->samples_per_pixel = random_.one_of({-1, 0, 1, 2, 4, 4097, -2, INT32_MIN});
        if (random_.once_in(3)) options->pattern = random_.choice(3);
        if (random_.once_in(3)) options->transfer = random_.choice(2);
        return options.sized(random_);
    }
    static const void *pixels_of(const glint_framebuffer *framebuffer) {
        glint_pixels pixels = {};
        pixels.size = sizeof pixels;
        return glint_framebuffer_get_pixels(framebuffer, &pixels) == GLINT_OK ? pixels.rgba8 : nullptr;
    }
    /// One that no job draws into: to look at its pixels or to draw there too would be the caller's race.
    glint_framebuffer *quiet_framebuffer() {
        glint_framebuffer *const framebuffer = any(framebuffers_);
        const void *const pixels = pixels_of(framebuffer);
        for (glint_job *job : jobs_.handles) {
            if (pixels && job && drawn_into_[job] == pixels) glint_job_wait(job, nullptr);
        }
        return framebuffer;
    }
    glint_render_statistics *statistics(Roomy<glint_render_statistics> &place) {
        return random_.once_in(2) ? nullptr : place.sized(random_);
    }

    glint::test::RandomValues random_;
    std::vector<std::function<void()>> calls_;
    struct Tally {
        uint64_t successes = 0, failures = 0;
    };
    std::map<std::string, Tally> tallies_;
    Host host_;
    std::map<const glint_job *, const void *> drawn_into_;
    alignas(16) uint8_t memory_[4 * 40 * 32];
    float floats_[3 * 40 * 32];

    Pool<glint_scene> scenes_{glint_scene_release};
    Pool<glint_scene_builder> builders_{glint_scene_builder_release};
    Pool<glint_framebuffer> framebuffers_{glint_framebuffer_release};
    Pool<glint_renderer> renderers_{glint_renderer_release};
    Pool<glint_job> jobs_{glint_job_release};
    Pool<glint_governor> governors_{glint_governor_release};
    Pool<glint_camera_control> controls_{glint_camera_control_release};
    Pool<glint_refiner> refiners_{glint_refiner_release};
};

Caller::~Caller() {
    const auto release_all = [](auto &pool) {
        for (auto *handle : pool.handles) pool.release(handle);
    };
    // Jobs last: they hold on to what they need.
    release_all(framebuffers_), release_all(renderers_), release_all(refiners_), release_all(scenes_);
    release_all(builders_), release_all(governors_), release_all(controls_), release_all(jobs_);
    host_.work(random_);
}

void Caller::list_calls() {
    list_release(scenes_);
    list_release(builders_);
    list_release(framebuffers_);
    list_release(renderers_);
    list_release(jobs_);
    list_release(governors_);
    list_release(controls_);
    list_release(refiners_);
    often(2, [&] { glint_error_name(random_.choice(10)), glint_isa_name(random_.choice(6)); });
    often(2, [&] { look<glint_version>("version", glint_get_version); });
    often(4, [&] {
        const void *const all[] = {any(scenes_),    any(builders_), any(framebuffers_), any(renderers_),
                                   any(governors_), any(controls_), any(refiners_),     nullptr};
        if (!glint_last_error_message(all[random_.below(8)])) give_up("message", "NULL");
    });
    list_scene_calls();
    list_builder_calls();
    list_renderer_calls();
    list_view_calls();
}

void Caller::list_scene_calls() {
    often(1, [&] {
        Roomy<glint_read_options> options;
        glint_read_options_init(options.get(), sizeof(glint_read_options));
        glint_memory_file files[] = {{"floor.obj", floor_text, sizeof floor_text - 1},
                                     {"lamp.obj", lamp_text, sizeof lamp_text - 1}};
        Roomy<glint_file_source> source;
        source->user = this;
        source->read = [](void *, const char *path, uint64_t max_bytes, glint_file *file) -> glint_error {
            const bool is_lamp = std::string(path) == "lamp.obj";
            if (!is_lamp && std::string(path) != "floor.obj") return GLINT_ERROR_NOT_FOUND;
            const char *const text = is_lamp ? lamp_text : floor_text;
            glint_file_allocate(file, std::strlen(text) / 2); // another takes its place
            void *const bytes = glint_file_allocate(file, std::strlen(text));
            if (bytes) std::memcpy(bytes, text, std::strlen(text));
            return max_bytes > 1 && !bytes ? GLINT_ERROR_OUT_OF_MEMORY : GLINT_OK;
        };
        if (random_.once_in(3)) options->files = source.sized(random_);
        if (random_.once_in(20)) source->read = nullptr;
        if (!options->files || random_.once_in(10)) {
            options->memory_files = files;
            options->memory_file_count = 2 - random_.below(20) / 19;
            if (random_.once_in(30)) files[1].path = nullptr;
            if (random_.once_in(30)) files[1].bytes = nullptr;
        }
        if (random_.once_in(20)) options->dialect = random_.one_of({"path2005", "", "none"});
        if (random_.once_in(20)) options->max_file_bytes = random_.below(100);
        if (random_.once_in(20)) options->max_pixels = random_.below(100);
        if (random_.once_in(20)) options->max_triangles = random_.below(4);
        if (random_.once_in(20)) options->max_depth = random_.below(4);
        if (random_.once_in(20)) options->reserved = 1;
        const char *const text = texts[random_.once_in(4) ? random_.below(4) : random_.below(2)];
        const glint_read_options *const given = random_.once_in(30) ? nullptr : options.sized(random_);
        const char *const name = random_.once_in(30) ? nullptr : "room.sdl";
        make(scenes_, "read", [&](glint_scene **place) {
            if (random_.once_in(10)) return glint_scene_read(name, given, place);
            if (random_.once_in(30)) return glint_scene_read_text(nullptr, random_.below(2), name, given, place);
            return glint_scene_read_text(text, std::strlen(text), name, given, place);
        });
    });
    often(3, [&] {
        look<glint_scene_info>("info", [&](auto *place) { return glint_scene_get_info(any(scenes_), place); });
    });
    often(3, [&] {
        const uint32_t index = random_.count(4) - 1;
        look<glint_diagnostic>("diagnostic",
                               [&](auto *place) { return glint_scene_get_diagnostic(any(scenes_), index, place); });
        look<glint_object_info>("object",
                                [&](auto *place) { return glint_scene_get_object(any(scenes_), index, place); });
    });
    often(3, [&] {
        float lower[3], upper[3];
        check(glint_scene_get_bounds(any(scenes_), lower, random_.once_in(9) ? nullptr : upper), "bounds");
        look_at_plain<glint_camera>("camera", [&](auto *place) { return glint_scene_get_camera(any(scenes_), place); });
    });
    often(3, [&] {
        float eye[3], target[3], up[3];
        random_.fill(eye), random_.fill(target), random_.fill(up);
        look_at_plain<glint_camera>("look_at", [&](auto *place) {
            return glint_camera_look_at(random_.once_in(20) ? nullptr : eye, target, up, random_.real(), 2.0f, place);
        });
        pose();
    });
    often(2, [&] {
        const glint_object_pose poses[2] = {{random_.below(3), pose()}, {random_.below(4), pose()}};
        make(scenes_, "move", [&](glint_scene **place) {
            return glint_scene_move(any(scenes_), random_.once_in(20) ? nullptr : poses, random_.below(3), place);
        });
    });
    often(1, [&] {
        make(scenes_, "at", [&](glint_scene **place) { return glint_scene_at(any(scenes_), random_.number(), place); });
    });
}

void Caller::list_builder_calls() {
    often(1, [&] { make(builders_, "builder", glint_scene_builder_create); });
    often(3, [&] {
        static constexpr float corners[] = {-1, -0.8f, -4, 1, -0.8f, -4, 1, 0.8f, -2, -1, -0.8f, -2};
        static constexpr uint32_t faces[] = {0, 1, 2, 0, 2, 3, GLINT_NONE, 7, 9};
        Roomy<glint_mesh> mesh;
        glint_mesh_init(mesh.get(), sizeof(glint_mesh));
        mesh->positions = random_.once_in(20) ? nullptr : corners;
        mesh->position_count = random_.once_in(20) ? random_.below(5) : 4;
        mesh->triangles = random_.once_in(20) ? nullptr : faces;
        mesh->triangle_count = random_.once_in(20) ? random_.below(4) : 2;
        if (random_.once_in(20)) mesh->triangle_count = SIZE_MAX / 2;
        if (random_.once_in(5)) mesh->normals = corners, mesh->normal_count = 4;
        if (random_.once_in(5)) mesh->texcoords = corners, mesh->texcoord_count = 4;
        if (random_.once_in(5)) mesh->normal_corners = mesh->texcoord_corners = faces;
        uint32_t index = 0;
        check(glint_scene_builder_add_mesh(any(builders_), random_.once_in(20) ? nullptr : mesh.sized(random_),
                                           random_.once_in(2) ? &index : nullptr),
              "mesh");
    });
    often(2, [&] {
        float texels[12];
        random_.fill(texels);
        check(glint_scene_builder_add_texture(any(builders_),
                                              random_.once_in(10) ? random_.one_of({0u, 1u, UINT32_MAX}) : 2,
                                              2 * random_.below(2), random_.once_in(10) ? nullptr : texels, nullptr),
              "texture");
    });
    often(4, [&] {
        Roomy<glint_material> material;
        glint_material_init(material.get(), sizeof(glint_material));
        if (random_.once_in(3)) material->reflection = std::abs(random_.real());
        if (random_.once_in(5)) material->transmission = random_.real(), material->ior = 1.5f;
        if (random_.once_in(5)) random_.fill(material->color);
        if (random_.once_in(5)) material->texture = random_.below(3);
        Roomy<glint_object> object;
        glint_object_init(object.get(), sizeof(glint_object));
        glint_quadric ball = {};
        float centre[3];
        random_.fill(centre);
        check(glint_quadric_sphere(random_.once_in(2) ? centre : nullptr, random_.real(), &ball), "sphere");
        const glint_pose where = pose();
        if (random_.once_in(2)) object->name = "thing";
        if (random_.once_in(2)) object->material = material.sized(random_);
        if (random_.once_in(3))
            object->quadric = &ball;
        else
            object->mesh = random_.below(2);
        if (random_.once_in(3)) object->pose = &where;
        check(glint_scene_builder_add_object(any(builders_), random_.once_in(20) ? nullptr : object.sized(random_)),
              "object");
    });
    often(3, [&] {
        Roomy<glint_light> light;
        glint_light_init(light.get(), sizeof(glint_light));
        float position[3];
        random_.fill(position);
        light->kind = random_.choice(4);
        if (light->kind == GLINT_LIGHT_SURFACE)
            light->mesh = random_.below(2);
        else
            light->position = position;
        light->outer_angle = 1.0f;
        if (random_.once_in(3)) light->inner_angle = random_.real();
        if (random_.once_in(3)) random_.fill(light->direction);
        if (random_.once_in(5)) light->shadow_rays = random_.below(4);
        if (random_.once_in(5)) light->grid_width = light->grid_height = random_.below(3);
        check(glint_scene_builder_add_light(any(builders_), random_.once_in(20) ? nullptr : light.sized(random_)),
              "light");
    });
    often(2, [&] {
        const glint_camera made = camera();
        check(glint_scene_builder_set_camera(any(builders_), random_.once_in(20) ? nullptr : &made), "set camera");
        Roomy<glint_scene_settings> settings;
        glint_scene_settings_init(settings.get(), sizeof(glint_scene_settings));
        if (random_.once_in(5)) random_.fill(settings->background);
        if (random_.once_in(5)) settings->max_depth = random_.count(5);
        if (random_.once_in(5)) settings->width_px = random_.count(40);
        if (random_.once_in(5)) settings->tone_scale = random_.real();
        if (random_.once_in(5)) settings->pattern = random_.choice(3);
        if (random_.once_in(5)) settings->fresnel = settings->shadows_through_glass = 1;
        check(glint_scene_builder_set_settings(any(builders_), random_.once_in(20) ? nullptr : settings.sized(random_)),
              "settings");
    });
    often(1, [&] {
        make(scenes_, "build", [&](glint_scene **place) { return glint_scene_builder_build(any(builders_), place); });
    });
}

void Caller::list_renderer_calls() {
    often(2, [&] {
        make(framebuffers_, "framebuffer", [&](glint_framebuffer **place) {
            if (random_.once_in(20))
                return glint_framebuffer_create(UINT32_MAX, random_.one_of({0u, UINT32_MAX}), 1, place);
            if (random_.once_in(2))
                return glint_framebuffer_create(random_.below(32), random_.below(24), random_.choice(2), place);
            const size_t stride = random_.once_in(3) ? 4 * random_.below(41) : 0;
            return glint_framebuffer_wrap(random_.below(33), random_.below(33), random_.once_in(9) ? nullptr : memory_,
                                          stride, random_.once_in(2) ? floats_ : nullptr, 3 * stride, place);
        });
    });
    often(3, [&] {
        look<glint_pixels>("pixels",
                           [&](auto *place) { return glint_framebuffer_get_pixels(any(framebuffers_), place); });
    });
    often(1, [&] { glint_framebuffer_pixel_hash(quiet_framebuffer()); });
    often(1, [&] {
        Roomy<glint_renderer_options> options;
        glint_renderer_options_init(options.get(), sizeof(glint_renderer_options));
        options->threads = random_.once_in(20) ? random_.one_of({1025u, UINT32_MAX}) : 1 + random_.below(2);
        if (random_.once_in(4)) options->isa = random_.choice(6);
        if (random_.once_in(2)) options->accel = random_.choice(4);
        if (random_.once_in(2)) options->submit = Host::submit, options->submit_user = &host_, options->threads = 3;
        if (random_.once_in(20)) options->reserved = 1;
        // Its default is as many threads as there are processors: too many to start and end all the time.
        const glint_renderer_options *const given = options.sized(random_);
        make(renderers_, "renderer",
             [&](glint_renderer **place) { return glint_renderer_create(any(scenes_), given, place); });
    });
    often(2, [&] { check(glint_renderer_set_scene(any(renderers_), any(scenes_)), "set scene"); });
    often(2, [&] { glint_renderer_threads(any(renderers_)), glint_renderer_isa(any(renderers_)); });
    often(2, [&] {
        const glint_camera made = camera();
        look<glint_pick>("pick", [&](auto *place) {
            return glint_renderer_pick(any(renderers_), random_.once_in(2) ? &made : nullptr, random_.number(),
                                       random_.number(), place);
        });
    });
    often(1, [&] {
        Roomy<glint_render_options> options;
        Roomy<glint_render_statistics> place;
        glint_camera seen;
        check(glint_renderer_render(any(renderers_), quiet_framebuffer(), render_options(options, seen),
                                    statistics(place)),
              "render");
    });
    often(1, [&] {
        Roomy<glint_render_options> options;
        glint_camera seen;
        const glint_render_options *const given = render_options(options, seen);
        make(jobs_, "start", [&](glint_job **place) {
            glint_framebuffer *const framebuffer = quiet_framebuffer();
            const glint_error code = glint_renderer_start(any(renderers_), framebuffer, given,
                                                          random_.once_in(2) ? Host::be_told : nullptr, &host_, place);
            if (code == GLINT_OK) drawn_into_[*place] = pixels_of(framebuffer);
            return code;
        });
    });
    often(3, [&] {
        glint_job *const job = any(jobs_);
        if (const double progress = glint_job_progress(job); !(progress >= 0.0 && progress <= 1.0)) {
            give_up("progress", "is no share");
        }
        if (random_.once_in(3)) glint_job_cancel(job);
        if (const int32_t is_done = glint_job_is_done(job); is_done != 0 && is_done != 1) give_up("done", "is no bool");
    });
    often(1, [&] {
        Roomy<glint_render_statistics> place;
        check(glint_job_wait(any(jobs_), statistics(place)), "wait");
    });
    often(1, [&] { host_.work(random_); });
}

void Caller::list_view_calls() {
    often(1, [&] {
        Roomy<glint_governor_options> options;
        glint_governor_options_init(options.get(), sizeof(glint_governor_options));
        if (random_.once_in(3)) options->target_fps = 500.0 + 600.0 * random_.number();
        if (random_.once_in(3)) options->least_scale = random_.real();
        if (random_.once_in(3)) options->greatest_depth = random_.count(5);
        const glint_governor_options *const given = random_.once_in(5) ? nullptr : options.sized(random_);
        make(governors_, "governor", [&](glint_governor **place) { return glint_governor_create(given, place); });
    });
    often(5, [&] {
        glint_frame_quality quality = {1.0f, 1};
        check(glint_governor_get_quality(any(governors_), random_.once_in(20) ? nullptr : &quality), "quality");
        if (random_.once_in(10)) quality.scale = random_.real();
        const glint_frame_times times = {std::abs(random_.number()), random_.number(), std::abs(random_.number()),
                                         random_.number()};
        check(glint_governor_measured(any(governors_), &quality, random_.once_in(20) ? nullptr : &times), "measured");
        if (random_.once_in(9)) check(glint_governor_set_greatest_depth(any(governors_), random_.count(5)), "depth");
        uint32_t width_px, height_px;
        check(glint_scaled_size(random_.count(2000), random_.count(2000), random_.real(), &width_px,
                                random_.once_in(9) ? nullptr : &height_px),
              "scaled size");
    });
    often(1, [&] {
        make(controls_, "control", [&](glint_camera_control **place) {
            return random_.once_in(2)
                       ? glint_camera_control_create(any(scenes_), 0, 0, place)
                       : glint_camera_control_create(any(scenes_), random_.count(99), random_.count(99), place);
        });
    });
    often(6, [&] {
        glint_camera_control *const control = any(controls_);
        const auto some = [&] { return random_.number(); };
        switch (random_.below(7)) {
        case 0:
            check(glint_camera_control_orbit(control, some(), some()), "orbit");
            break;
        case 1:
            check(glint_camera_control_pan(control, some(), some(), some(), some(), some()), "pan");
            break;
        case 2:
            check(glint_camera_control_zoom(control, some(), some(), some(), some()), "zoom");
            break;
        case 3:
            check(glint_camera_control_fly(control, some(), some(), some(), some()), "fly");
            break;
        case 4:
            check(glint_camera_control_reset(control), "reset");
            break;
        case 5:
            check(glint_camera_control_frame(control), "frame");
            break;
        default:
            check(glint_camera_control_resize(control, random_.count(2000), random_.count(2000)), "resize");
        }
        look_at_plain<glint_camera>("camera",
                                    [&](auto *place) { return glint_camera_control_get_camera(control, place); });
    });
    often(1, [&] {
        Roomy<glint_render_options> options;
        glint_camera seen;
        const glint_render_options *const given = render_options(options, seen);
        make(refiners_, "refiner", [&](glint_refiner **place) { return glint_refiner_create(given, place); });
        check(glint_refiner_restart(any(refiners_), given), "restart");
    });
    often(1, [&] {
        Roomy<glint_render_statistics> place;
        check(glint_refiner_next(any(refiners_), any(renderers_), quiet_framebuffer(), statistics(place)), "next");
    });
    often(2, [&] {
        if (random_.once_in(4)) glint_refiner_cancel(any(refiners_));
        glint_refiner_is_done(any(refiners_));
        if (glint_refiner_samples_done(any(refiners_)) > 16) give_up("samples", "too many");
    });
}

bool Caller::report() const {
    bool is_good = true;
    for (const auto &[what, tally] : tallies_) {
        std::printf("%14s: %8" PRIu64 " did, %8" PRIu64 " refused\n", what.c_str(), tally.successes, tally.failures);
        is_good = is_good && tally.successes > 0 && tally.failures > 0;
    }
    return is_good;
}

} // namespace

int main(int argc, char **argv) {
    const uint64_t count = argc > 1 ? static_cast<uint64_t>(std::strtod(argv[1], nullptr)) : 100000;
    const uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    Caller caller(seed);
    for (uint64_t i = 0; i < count; ++i) caller.call();
    std::printf("%" PRIu64 " random calls from seed %" PRIu64 "\n", count, seed);
    return caller.report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
