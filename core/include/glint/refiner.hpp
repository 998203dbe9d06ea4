// The picture of a camera that rests: full resolution first, then smoother from pass to pass.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glint/export.hpp>
#include <glint/framebuffer.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>

namespace glint {

/// Renders one picture in passes, each of which gives a whole picture to show:
///
///     Refiner refiner(options);
///     while (!refiner.done()) {
///         if (!refiner.next(renderer, picture, &control)) break; // cancelled
///         show(picture);
///     }
///
/// The first pass is the picture of one sample in each pixel's centre, the bytes that Renderer::render() gives with
/// `samples_per_pixel = 1, pattern = centre`. Each of the 16 passes after it renders one of the samples of the grid
/// that `samples_per_pixel = 16, pattern = centre` has and shows the average of those there are, in linear light. That
/// grid has no sample in the centre, so the first picture is in none of the averages; the grid's samples nearest to the
/// centre come first, and opposite ones by pairs, so that the picture neither jumps nor drifts. The last picture is
/// that of Renderer::render() with these 16 samples, but that floats are added up in another order: a few bytes in a
/// million are one off. One thread at a time calls it; the control may be cancelled from any.
class GLINT_API Refiner {
public:
    static constexpr uint32_t samples = 16; ///< of the last picture, a pixel

    /// Begins anew, for pictures with these options; samples_per_pixel and pattern are the refiner's own.
    explicit Refiner(const RenderOptions &options = {});
    ~Refiner();
    Refiner(Refiner &&) noexcept;
    Refiner &operator=(Refiner &&) noexcept;

    /// Forgets all passes, as when the camera has moved; keeps the memory.
    void restart(const RenderOptions &options);

    /// Whether the last pass is done.
    [[nodiscard]] bool done() const;
    /// Samples of the grid that the picture shows: 0 before the second pass, 16 when done.
    [[nodiscard]] uint32_t samples_done() const;

    /// Renders the next pass and fills the target with the picture, all of it, also where it is another framebuffer
    /// than last time. A target of another size begins anew. Once done() it only fills the target again.
    ///
    /// Fails with `cancelled` when the control says so, within one tile's work: then the target's pixels are of several
    /// pictures, but no pass is lost or counted twice, and next() may go on. Fails as Renderer::render() does, and with
    /// out_of_memory, also for the sums (28 bytes a pixel); then it may go on as well.
    [[nodiscard]] Result<RenderStatistics> next(Renderer &renderer, Framebuffer &target,
                                                RenderControl *control = nullptr);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace glint
