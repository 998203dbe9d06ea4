// A picture to be rendered, as the kernels see it.
#include "render/kernel_frame.hpp"

#include "render/eye_media.hpp"
#include "scene/camera_check.hpp"

namespace glint {

Result<KernelFrame> kernel_frame(const Scene &scene, const KernelScene &kernel_scene, const RenderOptions &options,
                                 uint32_t width_px, uint32_t height_px) {
    if (options.camera) {
        if (auto problem = camera_problem(*options.camera)) return Error(ErrorCode::bad_input, std::move(*problem));
    }
    KernelFrame frame{};
    frame.camera = options.camera.value_or(scene.camera());
    frame.width_px = width_px;
    frame.height_px = height_px;
    frame.max_depth = options.max_depth.value_or(scene.picture().max_depth);
    const PictureSettings &picture = scene.picture();
    const uint32_t samples = options.samples_per_pixel.value_or(picture.samples_per_pixel);
    if (samples < 1 || samples > max_samples) {
        std::string problem = "a picture of ";
        problem += std::to_string(samples);
        problem += " samples a pixel, expected 1 to ";
        problem += std::to_string(max_samples);
        return Error(ErrorCode::bad_input, std::move(problem));
    }
    frame.samples = sample_grid(samples, options.pattern.value_or(picture.pattern), picture.seed);
    if (options.only_sample) {
        if (*options.only_sample >= samples) {
            return Error(ErrorCode::bad_input, "only sample " + std::to_string(*options.only_sample) + " of " +
                                                   std::to_string(samples) + ", expected one below that");
        }
        frame.samples = one_of(frame.samples, *options.only_sample);
    }
    frame.tone_scale = picture.tone_scale;
    frame.to_srgb = options.transfer == Transfer::srgb;
    if (kernel_scene.has_refraction) frame.eye_media = media_around(scene, frame.camera.eye);
    return frame;
}

} // namespace glint
