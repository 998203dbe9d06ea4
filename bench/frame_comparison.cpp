// Whole frames of Glint and of a peer, in turns.
#include "bench/frame_comparison.hpp"

#include <optional>

#include <glint/renderer.hpp>

#include "bench/interleaved.hpp"
#include "bench/own_processor.hpp"

namespace glint::bench {
namespace {

/// Glint's frames and the peer's of one cell.
class Contest {
public:
    Contest(Renderer &renderer, PeerRenderer &peer) : renderer_(renderer), peer_(peer) {}

    Result<FrameCell> measure(uint32_t size_px, uint32_t depth, double min_seconds) {
        Result<Framebuffer> ours = Framebuffer::create(size_px, size_px, /*with_radiance=*/false);
        Result<Framebuffer> theirs = Framebuffer::create(size_px, size_px, /*with_radiance=*/false);
        if (!ours) return ours.error();
        if (!theirs) return theirs.error();

        std::optional<Error> failure;
        const auto render_ours = [&] {
            const auto rendered = renderer_.render(*ours, {.max_depth = depth, .camera = {}});
            if (!rendered) failure = rendered.error();
        };
        const auto render_theirs = [&] { peer_.render(*theirs, depth); };

        FrameCell cell{};
        cell.width_px = cell.height_px = size_px;
        cell.depth = depth;
        render_ours();
        if (failure) return *failure;
        render_theirs();
        cell.difference = compare_pictures(*ours, *theirs);

        const Frames our_frames(render_ours);
        const Frames their_frames(render_theirs);
        take_turns(our_frames, their_frames, 0.1 * min_seconds, failure); // warms caches and wakes threads
        const Turns turns = take_turns(our_frames, their_frames, min_seconds, failure);
        if (failure) return *failure;
        cell.frames = turns.glint_ms.size();
        cell.glint_ms = summarize(turns.glint_ms);
        cell.peer_ms = summarize(turns.peer_ms);
        return cell;
    }

private:
    template <typename Render> class Frames {
    public:
        explicit Frames(const Render &render) : render_(render) {}
        void prepare() const {}
        void run() const { render_(); }

    private:
        const Render &render_;
    };

    template <typename Glint, typename Theirs> static Turns
    take_turns(const Glint &glint, const Theirs &theirs, double min_seconds, const std::optional<Error> &failure) {
        constexpr size_t min_frames = 20;
        Turns turns;
        double spent_ms = 0.0;
        while (!failure && (turns.glint_ms.size() < min_frames || spent_ms < 1000.0 * min_seconds)) {
            spent_ms += time_ms([&] { turns.take(glint, theirs); });
        }
        return turns;
    }

    Renderer &renderer_;
    PeerRenderer &peer_;
};

} // namespace

Result<FrameComparison> compare_frames(const std::shared_ptr<const Accel> &accel, const Peer &peer,
                                       const FrameComparisonOptions &options) {
    FrameComparison comparison;
    const std::shared_ptr<const Scene> scene(accel, &accel->scene());
    for (const unsigned threads : options.threads) {
        const OwnProcessor processor;
        const auto ours = processor.start_others(
            [&] { return std::make_unique<Renderer>(accel, RendererOptions{.threads = threads, .isa = options.isa}); });
        const auto theirs = processor.start_others([&] { return peer.renderer(scene, options.isa, threads); });
        if (!theirs) return theirs.error();
        comparison.isa = isa_name(ours->isa());

        Contest contest(*ours, **theirs);
        for (const uint32_t size_px : options.sizes_px) {
            for (const uint32_t depth : options.depths) {
                if (options.on_cell) options.on_cell(size_px, depth, threads);
                Result<FrameCell> cell = contest.measure(size_px, depth, options.min_seconds);
                if (!cell) return cell.error();
                cell->threads = ours->threads();
                cell->peer_kernel = (*theirs)->kernel();
                comparison.cells.push_back(std::move(*cell));
            }
        }
    }
    return comparison;
}

} // namespace glint::bench
