// The picture of a camera that rests, in passes.
#include <glint/refiner.hpp>

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>

#include "threads/parallel_for.hpp"
#include "view/average.hpp"

namespace glint {

namespace {

/// Samples of the grid of 4 x 4, row by row, in the order they are taken: by pairs that lie opposite each other about
/// the pixel's centre, so that the picture stays where it is, and the innermost first, so that it does not jump when
/// the sample in the centre makes way. Orders were compared by what is left to the last picture (PSNR).
constexpr uint32_t order[Refiner::samples] = {5, 10, 3, 12, 6, 9, 0, 15, 1, 14, 7, 8, 2, 13, 4, 11};

/// Pixels that are looked at between two looks at the control.
constexpr size_t band_px = 1 << 14;

} // namespace

struct Refiner::Impl {
    RenderOptions options;
    uint32_t width_px = 0, height_px = 0;
    bool has_centre = false;   ///< whether the first pass is done
    bool has_shown = false;    ///< whether all samples taken were shown
    bool is_adding = false;    ///< whether `sample` is complete and not in all of the sums
    uint32_t samples_done = 0; ///< in all of the sums
    std::optional<Framebuffer> sample;
    std::unique_ptr<float[]> sums; ///< linear R, G, B
    std::vector<uint8_t> is_added; ///< of a band of pixels: whether `sample` is in its sums

    void restart() {
        has_centre = has_shown = is_adding = false;
        samples_done = 0;
    }

    Status take_memory();
    Result<RenderStatistics> take_sample(Renderer &renderer, RenderControl *control);
    bool show(const Renderer &renderer, Framebuffer &target, const RenderControl *control);
    void show_band(size_t band, Framebuffer &target, float tone_scale);
};

Status Refiner::Impl::take_memory() {
    if (sample && sample->width_px() == width_px && sample->height_px() == height_px) return Done{};
    const size_t pixels = size_t{width_px} * height_px;
    sample = std::nullopt;
    Result<Framebuffer> framebuffer = Framebuffer::create(width_px, height_px);
    if (!framebuffer) return framebuffer.error();
    sums.reset(new (std::nothrow) float[pixels * 3]);
    if (!sums) return Error(ErrorCode::out_of_memory, "no memory for the sums of a picture's samples");
    is_added.assign((pixels + band_px - 1) / band_px, 0);
    sample = std::move(framebuffer).value();
    return Done{};
}

Result<RenderStatistics> Refiner::Impl::take_sample(Renderer &renderer, RenderControl *control) {
    if (const Status status = take_memory(); !status) return status.error();
    RenderOptions one = options;
    one.samples_per_pixel = samples;
    one.pattern = SamplePattern::centre;
    one.only_sample = order[samples_done];
    Result<RenderStatistics> statistics = renderer.render(*sample, one, control);
    if (statistics) {
        is_adding = true;
        is_added.assign(is_added.size(), 0);
    }
    return statistics;
}

/// Adds the sample to the sums, where that is to do, and fills the target with the averages. A band after the other,
/// each of them to the end: false where the control stopped it, and then it may be done again.
bool Refiner::Impl::show(const Renderer &renderer, Framebuffer &target, const RenderControl *control) {
    const float tone_scale = renderer.accel().scene().picture().tone_scale;
    has_shown = false;
    parallel_for(is_added.size(), Crew(renderer.threads(), renderer.submit()), [&](size_t band, unsigned) {
        if (!control || !control->cancelled()) show_band(band, target, tone_scale);
    });
    if (control && control->cancelled()) return false;
    if (is_adding) ++samples_done;
    is_adding = false;
    return has_shown = true;
}

void Refiner::Impl::show_band(size_t band, Framebuffer &target, float tone_scale) {
    const size_t pixels = size_t{width_px} * height_px;
    const size_t begin = band * band_px, end = std::min(pixels, begin + band_px);
    if (is_adding && !is_added[band]) {
        float *const to = sums.get() + 3 * begin;
        if (samples_done == 0) std::fill(to, to + 3 * (end - begin), 0.0f);
        add_to(to, sample->radiance() + 3 * begin, 3 * (end - begin));
        is_added[band] = 1;
    }
    const float share = 1.0f / static_cast<float>(samples_done + (is_adding ? 1 : 0));
    const Averaging how{share, tone_scale, options.transfer == Transfer::srgb};
    const size_t light_stride = target.radiance_stride_bytes() / sizeof(float);
    // By rows, since the target may have gaps between them.
    for (size_t at = begin; at < end;) {
        const size_t y = at / width_px, x = at % width_px;
        const size_t count = std::min(end - at, width_px - x);
        show_average(sums.get() + 3 * at, how, count, target.rgba8() + y * target.rgba8_stride_bytes() + 4 * x,
                     target.has_radiance() ? target.radiance() + y * light_stride + 3 * x : nullptr);
        at += count;
    }
}

Refiner::Refiner(const RenderOptions &options) : impl_(std::make_unique<Impl>()) {
    impl_->options = options;
}
Refiner::~Refiner() = default;
Refiner::Refiner(Refiner &&) noexcept = default;
Refiner &Refiner::operator=(Refiner &&) noexcept = default;

void Refiner::restart(const RenderOptions &options) {
    impl_->options = options;
    impl_->restart();
}

bool Refiner::done() const {
    return impl_->samples_done == samples && impl_->has_shown;
}

uint32_t Refiner::samples_done() const {
    return impl_->samples_done;
}

Result<RenderStatistics> Refiner::next(Renderer &renderer, Framebuffer &target, RenderControl *control) try {
    Impl &impl = *impl_;
    const auto start = std::chrono::steady_clock::now();
    if (target.width_px() != impl.width_px || target.height_px() != impl.height_px) {
        impl.restart();
        impl.width_px = target.width_px();
        impl.height_px = target.height_px();
    }
    if (!impl.has_centre) {
        RenderOptions centre = impl.options;
        centre.samples_per_pixel = 1;
        centre.pattern = SamplePattern::centre;
        centre.only_sample = std::nullopt;
        Result<RenderStatistics> statistics = renderer.render(target, centre, control);
        impl.has_centre = statistics.ok();
        return statistics;
    }
    RenderStatistics statistics;
    if (!impl.is_adding && impl.samples_done < samples) {
        Result<RenderStatistics> taken = impl.take_sample(renderer, control);
        if (!taken) return taken;
        statistics = *taken;
    }
    if (!impl.show(renderer, target, control)) return Error(ErrorCode::cancelled, "the refinement was cancelled");
    statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return statistics;
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

} // namespace glint
