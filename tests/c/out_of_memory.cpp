// glint_out_of_memory: reads, builds, renders and refines through the C interface, once for every allocation, which
// fails.
//
// Each time there must be an error code or the right picture, and nothing may be left behind.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include <glint/glint.h>

#include "host/failing_memory.hpp"

namespace {

using namespace glint::test;

const char floor_text[] = "v -1 -0.8 -4\nv 1 -0.8 -4\nv 1 -0.8 -2\nv -1 -0.8 -2\nf 1 2 3\nf 1 3 4\n";
const char lamp_text[] = "v -0.2 0.9 -4\nv 0.2 0.9 -4\nv 0.2 0.9 -2\nf 1 2 3\n";
const char room_text[] = "eye 0 0 5.7\nsize 48 32\northo -1 -1 1 1\nbackground 0 0 1\nambient 1\nmax_depth 2\n"
                         "light lamp.obj 1 1 1 1\nobject floor.obj 1 0 0 0.3 0.7 0 0 0.2 0\n";
const char glass_text[] = "dialect glint\neye 0 0 5\nlight lamp.obj 1 1 1 1\n"
                          "objectquadric 1 1 1 0 0 0 0 0 0 -1 1 1 1 0 1 0 0 0.5 0.4 1.5\n";

glint_error read(const char *text, glint_scene **scene) {
    const glint_memory_file files[] = {{"floor.obj", floor_text, sizeof floor_text - 1},
                                       {"lamp.obj", lamp_text, sizeof lamp_text - 1}};
    glint_read_options options;
    glint_read_options_init(&options, sizeof options);
    options.memory_files = files;
    options.memory_file_count = 2;
    return glint_scene_read_text(text, std::strlen(text), "room.sdl", &options, scene);
}
glint_error read_room(glint_scene **scene) {
    return read(room_text, scene);
}
glint_error read_glass(glint_scene **scene) {
    return read(glass_text, scene);
}

/// A floor that has moved and a sun.
glint_error build(glint_scene **scene) {
    const float corners[] = {-1, -0.8f, -4, 1, -0.8f, -4, 1, -0.8f, -2, -1, -0.8f, -2};
    const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
    const float axis[3] = {0, 1, 0};
    const float texel[3] = {1, 0.5f, 0.25f};
    glint_object_pose pose = {};
    glint_pose_turned(axis, 0.25, nullptr, nullptr, &pose.pose);
    glint_mesh mesh;
    glint_mesh_init(&mesh, sizeof mesh);
    mesh.positions = mesh.texcoords = corners;
    mesh.position_count = mesh.texcoord_count = 4;
    mesh.triangles = faces;
    mesh.triangle_count = 2;
    glint_material material;
    glint_material_init(&material, sizeof material);
    material.texture = 0;
    glint_object object;
    glint_object_init(&object, sizeof object);
    object.name = "a name too long to be kept without any memory of its own";
    object.material = &material;
    object.mesh = 0;
    object.pose = &pose.pose;
    glint_light light;
    glint_light_init(&light, sizeof light);
    light.kind = GLINT_LIGHT_DIRECTIONAL;

    glint_scene_builder *builder = nullptr;
    glint_scene *still = nullptr;
    glint_error code = glint_scene_builder_create(&builder);
    if (code == GLINT_OK) code = glint_scene_builder_add_texture(builder, 1, 1, texel, nullptr);
    if (code == GLINT_OK) code = glint_scene_builder_add_mesh(builder, &mesh, nullptr);
    if (code == GLINT_OK) code = glint_scene_builder_add_object(builder, &object);
    if (code == GLINT_OK) code = glint_scene_builder_add_light(builder, &light);
    if (code == GLINT_OK) code = glint_scene_builder_build(builder, &still);
    if (code == GLINT_OK) code = glint_scene_move(still, &pose, 1, scene);
    glint_scene_release(still);
    glint_scene_builder_release(builder);
    return code;
}

/// Everything from the scene on; the picture's hashes are added up.
glint_error use(const glint_scene *scene, uint64_t &hash) {
    glint_renderer_options options;
    glint_renderer_options_init(&options, sizeof options);
    options.threads = 2;
    glint_renderer *renderer = nullptr;
    glint_framebuffer *picture = nullptr;
    glint_job *job = nullptr;
    glint_refiner *refiner = nullptr;
    glint_camera_control *control = nullptr;
    float lower[3], upper[3];
    glint_error code = glint_renderer_create(scene, &options, &renderer);
    if (code == GLINT_OK) code = glint_framebuffer_create(20, 20, 1, &picture);
    if (code == GLINT_OK) code = glint_renderer_render(renderer, picture, nullptr, nullptr);
    if (code == GLINT_OK) hash = glint_framebuffer_pixel_hash(picture);
    if (code == GLINT_OK) code = glint_renderer_start(renderer, picture, nullptr, nullptr, nullptr, &job);
    if (code == GLINT_OK) code = glint_job_wait(job, nullptr);
    if (code == GLINT_OK) code = glint_renderer_set_scene(renderer, scene);
    if (code == GLINT_OK) code = glint_refiner_create(nullptr, &refiner);
    for (int pass = 0; pass < 2; ++pass) {
        if (code == GLINT_OK) code = glint_refiner_next(refiner, renderer, picture, nullptr);
    }
    if (code == GLINT_OK) hash += glint_framebuffer_pixel_hash(picture);
    if (code == GLINT_OK) code = glint_camera_control_create(scene, 0, 0, &control);
    if (code == GLINT_OK) code = glint_scene_get_bounds(scene, lower, upper);
    glint_camera_control_release(control);
    glint_refiner_release(refiner);
    glint_job_release(job);
    glint_framebuffer_release(picture);
    glint_renderer_release(renderer);
    return code;
}

/// What the whole way from nothing to a picture ends with, and the picture.
glint_error go(glint_error (*make)(glint_scene **), uint64_t &hash) {
    glint_scene *scene = nullptr;
    glint_error code = make(&scene);
    if (code == GLINT_OK) code = use(scene, hash);
    if (code != GLINT_OK && scene) glint_last_error_message(scene);
    glint_scene_release(scene);
    return code;
}

bool stands(const char *name, glint_error (*make)(glint_scene **), bool for_good) {
    uint64_t expected = 0;
    if (go(make, expected) != GLINT_OK) return std::printf("%s: fails with all the memory there is\n", name), false;
    const int64_t live = live_allocations();
    int64_t refused = 0, n = 1;
    for (;; ++n) {
        uint64_t hash = 0;
        glint_error code;
        bool has_failed;
        {
            const FailingMemory failing(n, for_good);
            code = go(make, hash);
            has_failed = FailingMemory::has_failed();
        }
        refused += code == GLINT_ERROR_OUT_OF_MEMORY;
        const char *const problem = code != GLINT_OK && code != GLINT_ERROR_OUT_OF_MEMORY ? "ends with another error"
                                    : code == GLINT_OK && hash != expected                ? "gives another picture"
                                    : live_allocations() != live                          ? "leaves memory behind"
                                                                                          : nullptr;
        if (problem) {
            std::printf("%s: without allocation %" PRId64 "%s it %s (%s, %" PRId64 ")\n", name, n,
                        for_good ? " and all after it" : "", problem, glint_error_name(code),
                        live_allocations() - live);
            return false;
        }
        if (!has_failed) break;
    }
    std::printf("%s: %" PRId64 " allocations failed, %" PRId64 " runs refused\n", name, n - 1, refused);
    return refused > (n - 1) / 2;
}

} // namespace

int main() {
    bool is_good = true;
    // One that fails, as the last straw; and all of them from there on, so that no message finds memory either.
    for (const bool for_good : {false, true}) {
        is_good = stands("a room read from memory", read_room, for_good) && is_good;
        is_good = stands("a glass ball", read_glass, for_good) && is_good;
        is_good = stands("a scene that was built and moved", build, for_good) && is_good;
    }
    return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}
