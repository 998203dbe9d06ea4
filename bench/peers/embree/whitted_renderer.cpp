// A Whitted renderer on Embree: tiles for all threads.
#include "bench/peers/embree/whitted_renderer.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/peers/embree/device.hpp"
#include "bench/peers/embree/flush_denormals.hpp"
#include "bench/peers/embree/geometry.hpp"
#include "bench/peers/embree/surface_table.hpp"
#include "bench/peers/embree/whitted_scene.hpp"
#include "bench/peers/stopwatch.hpp"
#include "threads/worker_pool.hpp"

namespace glint::bench::embree {
namespace {

/// Of the 32 bits that a mask has, one is for the objects.
constexpr size_t most_lights = 31;

TraceTile tile_for(const DeviceIsa &isa) {
    return isa.max_width == 16 ? avx512::trace_tile : isa.max_width == 8 ? avx2::trace_tile : sse4::trace_tile;
}

void set(float (&to)[3], const glm::vec3 &from) {
    to[0] = from.x, to[1] = from.y, to[2] = from.z;
}

/// What Embree can be told for one and the same picture.
struct Way {
    TreeKind tree;
    RTCIntersectContextFlags shadow_coherence, mirror_coherence;
};

class Renderer final : public PeerRenderer {
public:
    Renderer(std::shared_ptr<const Scene> scene, const DeviceIsa &isa, Device device, unsigned threads)
        : glint_scene_(std::move(scene)),
          isa_(isa),
          trace_tile_(tile_for(isa)),
          device_(std::move(device)),
          meshes_(*glint_scene_),
          surfaces_(*glint_scene_),
          pool_(threads) {
        for (unsigned i = 0; i < pool_.threads(); ++i) scratch_.emplace_back(scratch_floats);
    }

    /// Tries every tree with every hint on small frames, and stays with the fastest: all in turns, round after round,
    /// so that a slow moment of the machine does not decide. Fails where a frame has no memory.
    Status choose_way() {
        constexpr uint32_t side_px = 256;
        constexpr int least_rounds = 5;
        constexpr double least_ms = 600.0;
        constexpr auto coherent = RTC_INTERSECT_CONTEXT_FLAG_COHERENT,
                       incoherent = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        Result<Framebuffer> frame = Framebuffer::create(side_px, side_px, /*with_radiance=*/false);
        if (!frame) return frame.error();

        struct Trial {
            Way way;
            SceneHandle *scene;
            double fastest_ms = std::numeric_limits<double>::max();
        };
        const TreeKind trees[] = {low_tree, medium_tree, high_tree};
        SceneHandle scenes[std::size(trees)];
        std::vector<Trial> trials;
        for (size_t i = 0; i < std::size(trees); ++i) {
            scenes[i] = meshes_.build(device_.get(), trees[i]);
            for (const auto shadow : {coherent, incoherent}) {
                for (const auto mirror : {coherent, incoherent})
                    trials.push_back({{trees[i], shadow, mirror}, &scenes[i]});
            }
        }
        double spent_ms = 0.0;
        for (int round = 0; round < least_rounds || spent_ms < least_ms; ++round) {
            for (Trial &trial : trials) {
                way_ = trial.way;
                std::swap(scene_, *trial.scene);
                const double ms = time_ms([&] { render(*frame, glint_scene_->picture().max_depth); });
                std::swap(scene_, *trial.scene);
                trial.fastest_ms = std::min(trial.fastest_ms, ms);
                spent_ms += ms;
            }
        }
        const Trial &best = *std::min_element(
            trials.begin(), trials.end(), [](const Trial &a, const Trial &b) { return a.fastest_ms < b.fastest_ms; });
        way_ = best.way;
        scene_ = std::move(*best.scene);
        return Done{};
    }

    void render(Framebuffer &target, uint32_t max_depth) override {
        const WhittedScene scene = whitted_scene();
        const WhittedFrame frame = frame_of(target, max_depth);
        const uint32_t across = (frame.width_px + tile_px - 1) / tile_px;
        const uint32_t tiles = across * ((frame.height_px + tile_px - 1) / tile_px);
        std::atomic<uint32_t> next{0};
        pool_.run([&](unsigned worker) {
            const FlushDenormals mode;
            for (uint32_t tile; (tile = next.fetch_add(1, std::memory_order_relaxed)) < tiles;) {
                trace_tile_(scene, frame, tile % across * tile_px, tile / across * tile_px, scratch_[worker].get());
            }
        });
    }

    [[nodiscard]] std::string kernel() const override {
        const auto hint = [](RTCIntersectContextFlags flags) {
            return flags == RTC_INTERSECT_CONTEXT_FLAG_COHERENT ? " coherent" : " incoherent";
        };
        return std::string(isa_.name) + " packets of " + std::to_string(isa_.max_width) + ", " + way_.tree.name +
               " tree, shadows" + hint(way_.shadow_coherence) + ", mirrors" + hint(way_.mirror_coherence);
    }

private:
    [[nodiscard]] WhittedScene whitted_scene() const {
        WhittedScene scene{};
        scene.scene = scene_.get();
        scene.shadow_coherence = way_.shadow_coherence;
        scene.mirror_coherence = way_.mirror_coherence;
        scene.surfaces = surfaces_.columns();
        scene.surface_count = glint_scene_->surface_count();
        scene.object_count = static_cast<uint32_t>(glint_scene_->objects().size());
        scene.lights = surfaces_.lights().data();
        scene.light_count = static_cast<uint32_t>(surfaces_.lights().size());
        return scene;
    }

    [[nodiscard]] WhittedFrame frame_of(Framebuffer &target, uint32_t max_depth) const {
        const Camera &camera = glint_scene_->camera();
        WhittedFrame frame{};
        frame.width_px = target.width_px();
        frame.height_px = target.height_px();
        frame.max_depth = max_depth;
        frame.rgba8 = target.rgba8();
        set(frame.eye, camera.eye);
        set(frame.corner, camera.top_left - camera.eye);
        set(frame.right, camera.right / static_cast<float>(frame.width_px));
        set(frame.down, camera.down / static_cast<float>(frame.height_px));
        return frame;
    }

    std::shared_ptr<const Scene> glint_scene_;
    DeviceIsa isa_;
    TraceTile trace_tile_;
    Device device_;
    SharedMeshes meshes_;
    SceneHandle scene_;
    Way way_{};
    SurfaceTable surfaces_;
    WorkerPool pool_; // Glint's own, so that waking threads costs both the same
    std::vector<AlignedFloats> scratch_;
};

} // namespace

Result<std::unique_ptr<PeerRenderer>> make_renderer(std::shared_ptr<const Scene> scene, Isa isa, unsigned threads) {
    if (scene->lights().size() > most_lights) {
        return Error(ErrorCode::unsupported, "the Embree renderer takes at most 31 lights");
    }
    const std::vector<DeviceIsa> isas = isas_within(isa);
    if (isas.empty()) return Error(ErrorCode::unsupported, "Embree has no kernels for this machine");
    Result<Device> device = open_device(isas.back().name, 0);
    if (!device) return device.error();
    auto renderer = std::make_unique<Renderer>(std::move(scene), isas.back(), std::move(*device), threads);
    if (const Status chosen = renderer->choose_way(); !chosen) return chosen.error();
    return std::unique_ptr<PeerRenderer>(std::move(renderer));
}

} // namespace glint::bench::embree
