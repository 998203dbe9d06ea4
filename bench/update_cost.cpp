// What it costs to move a scene's objects from one frame to the next.
#include "bench/update_cost.hpp"

#include <chrono>
#include <utility>

#include <glint/glint.hpp>

namespace glint::bench {
namespace {

using Clock = std::chrono::steady_clock;

double ms_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

Result<uint64_t> look(Renderer &renderer) {
    Result<Framebuffer> picture = Framebuffer::create(64, 48);
    if (!picture) return picture.error();
    const Result<RenderStatistics> done = renderer.render(*picture);
    if (!done) return done.error();
    return picture->radiance_hash();
}

} // namespace

Result<UpdateCost> measure_updates(const std::shared_ptr<const Scene> &scene, uint32_t frames) {
    if (!scene->animation()) return Error(ErrorCode::bad_input, "nothing moves in this scene");
    UpdateCost cost;
    for (const ObjectMotion &motion : scene->animation()->objects) {
        const Object &object = scene->objects()[motion.object];
        ++cost.moving_objects;
        cost.moving_triangles += object.mesh ? static_cast<uint32_t>(object.mesh->triangles.size()) : 0;
    }
    std::shared_ptr<const Accel> accel = Accel::build(scene);
    Renderer renderer(accel);
    std::shared_ptr<const Scene> last = scene;
    std::vector<double> edit_ms, accel_ms, update_ms;
    for (uint32_t frame = 1; frame <= frames; ++frame) {
        const Clock::time_point start = Clock::now();
        const auto moved = scene_at(scene, frame / 25.0);
        if (!moved) return moved.error();
        const Clock::time_point edited = Clock::now();
        accel = Accel::update(accel, *moved);
        renderer.set_accel(accel);
        last = *moved;
        const Clock::time_point done = Clock::now();
        edit_ms.push_back(ms_between(start, edited));
        accel_ms.push_back(ms_between(edited, done));
        update_ms.push_back(ms_between(start, done));
    }
    cost.updates = frames;
    cost.edit_ms = summarize(std::move(edit_ms));
    cost.accel_ms = summarize(std::move(accel_ms));
    cost.update_ms = summarize(std::move(update_ms));

    Renderer anew(Accel::build(last));
    const Result<uint64_t> updated = look(renderer), built = look(anew);
    if (!updated) return updated.error();
    if (!built) return built.error();
    if (*updated != *built) return Error(ErrorCode::bad_input, "an updated scene does not look as one built anew");
    return cost;
}

} // namespace glint::bench
