// Any text as an SDL file beside the meshes of scene/: a scene that is valid and can be rendered, or reasons.
#include <cmath>
#include <cstdint>
#include <utility>

#include <glint/animation.hpp>

#include "fuzz/budget.hpp"
#include "fuzz/scene_place.hpp"
#include "fuzz/verdict.hpp"
#include "sdl/read_scene.hpp"
#include "support/picture.hpp"
#include "support/text_in_memory.hpp"

namespace {

using namespace glint;

constexpr uint32_t edge_px = 4, depth = 2;

/// Rays that a picture of this scene takes at most, as its file asks for samples and shadow rays.
double most_rays(const Scene &scene) {
    double shadow_rays = 0.0;
    for (const Light &light : scene.lights()) {
        const double grid = double(light.grid_width) * light.grid_height;
        shadow_rays += grid > 0.0 ? grid : light.shadow_rays;
    }
    constexpr double paths = 1 + 2 + 4; // each ray may mirror and refract
    return edge_px * edge_px * paths * scene.picture().samples_per_pixel * (1.0 + shadow_rays);
}

void require_picture(const std::shared_ptr<const Scene> &scene) {
    const Framebuffer picture = test::render(scene, edge_px, edge_px, depth, 1);
    for (uint32_t i = 0; i < edge_px * edge_px * 3; ++i) {
        fuzz::require(std::isfinite(picture.radiance()[i]), "a pixel is not finite");
        fuzz::require(picture.radiance()[i] >= 0.0f, "a pixel is negative");
    }
}

/// What moves is valid at any moment, or there is a reason: the eye may come to its target.
void require_later_moment(const std::shared_ptr<const Scene> &scene) {
    const auto later = scene_at(scene, 1.0);
    if (!later.ok()) return fuzz::require(!later.error().text().empty(), "a moment that fails has no reason");
    fuzz::require_valid(**later);
    require_picture(*later);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    TextFile text = test::text_in_memory({reinterpret_cast<const char *>(data), size});

    const fuzz::Budget budget;
    const Result<SceneFile> file = read_scene_text(std::move(text), fuzz::scene_file(), fuzz::scene_options());
    budget.require_kept();
    if (!file.ok()) {
        fuzz::require_reasons(file.error());
        return 0;
    }
    fuzz::require_valid(*file->scene);
    fuzz::require_words(file->warnings);
    if (most_rays(*file->scene) >= 100'000) return 0;
    require_picture(file->scene);
    if (file->scene->animation()) require_later_moment(file->scene);
    return 0;
}
