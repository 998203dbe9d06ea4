// Every ray behind one pixel, written down while the scalar kernel traces them.
#include <glint/ray_tree.hpp>

#include <limits>
#include <new>

#include "accel/accel_impl.hpp"
#include "kernel/ray_recorder.hpp"
#include "math/unit.hpp"
#include "render/kernel_frame.hpp"
#include "render/shading_tables.hpp"

namespace glint {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// The scene's light that a kernel's light is an entry of.
uint32_t light_of(const Scene &scene, uint32_t entry) {
    uint32_t light = 0;
    for (uint32_t entries; entry >= (entries = LightTables::entries_of(scene.lights()[light])); ++light) {
        entry -= entries;
    }
    return light;
}

class Recorder final : public RayRecorder {
public:
    Recorder(const Accel &accel, const KernelScene &kernel_scene, std::vector<TracedRay> &rays)
        : accel_(accel), kernel_scene_(kernel_scene), rays_(rays) {}

    void meets(const PendingRay &pending, const Hit &hit) override {
        TracedRay ray;
        if (pending_.empty()) {
            sample_ = samples_++;
        } else {
            ray.kind = pending_.back().kind;
            ray.parent = pending_.back().parent;
            pending_.pop_back();
        }
        ray.origin = pending.ray.org;
        ray.direction = pending.ray.dir;
        ray.weight = pending.weight;
        ray.distance = infinite;
        if (hit.triangle_id != no_triangle) {
            ray.distance = hit.t;
            ends_at(ray, surface_of(hit));
        }
        current_ = static_cast<uint32_t>(rays_.size());
        add(ray);
    }

    void casts(uint32_t entry, const ShadowRay &shadow, const SurfacePoint &point, float share) override {
        TracedRay ray;
        ray.kind = RayKind::shadow;
        ray.parent = current_;
        ray.light = light_of(accel_.scene(), entry);
        ray.light_name = accel_.scene().lights()[ray.light].name;
        ray.light_share = share;
        const LightShading &light = kernel_scene_.lights[entry];
        // It is traced from the light, but for directional light, and told from the point.
        const bool is_reversed = light.kind != Light::Kind::directional;
        const float length = std::sqrt(dot(shadow.ray.dir, shadow.ray.dir));
        ray.origin = is_reversed ? shadow.ray.org + shadow.ray.dir : shadow.ray.org;
        ray.direction = unit(is_reversed ? -shadow.ray.dir : shadow.ray.dir);
        ray.distance = is_reversed ? length : infinite;
        ends_at(ray, {true, ray.light});
        if (share < 1.0f) {
            InTheWay in_the_way{};
            (void)share_through_glass(kernel_scene_, light, shadow.ray, shadow.t_max, point.left, &in_the_way);
            const Hit &hit = is_reversed ? in_the_way.last : in_the_way.first;
            ray.distance = length * (is_reversed ? 1.0f - hit.t : hit.t);
            ends_at(ray, surface_of(hit));
        }
        add(ray);
    }

    void lights(const Color &color) override {
        if (!is_full_) rays_.back().local_color = color;
    }

    void shows(float weight, const Color &color) override {
        if (is_full_) return;
        rays_[current_].local_weight = weight;
        rays_[current_].local_color = color;
        for (size_t shadow = current_ + 1; shadow < rays_.size(); ++shadow) rays_[shadow].weight = weight;
    }

    void sends(bool mirrored) override {
        pending_.push_back({mirrored ? RayKind::mirror : RayKind::transmitted, current_});
    }

    [[nodiscard]] bool is_full() const { return is_full_; }

private:
    struct Pending {
        RayKind kind;
        uint32_t parent;
    };

    [[nodiscard]] SurfaceRef surface_of(const Hit &hit) const {
        return accel_.scene().surface(kernel_scene_.geometry.surfaces[hit.triangle_id].surface);
    }

    void ends_at(TracedRay &ray, const SurfaceRef &surface) const {
        const Scene &scene = accel_.scene();
        ray.target = surface.is_light ? RayTarget::light : RayTarget::object;
        ray.target_index = surface.index;
        ray.target_name = surface.is_light ? scene.lights()[surface.index].name : scene.objects()[surface.index].name;
    }

    void add(TracedRay &ray) {
        if (rays_.size() == max_tree_rays) is_full_ = true;
        if (is_full_) return;
        ray.sample = sample_;
        ray.level = ray.parent == no_ray ? 0 : rays_[ray.parent].level + 1;
        rays_.push_back(std::move(ray));
    }

    const Accel &accel_;
    const KernelScene &kernel_scene_;
    std::vector<TracedRay> &rays_;
    std::vector<Pending> pending_; ///< what the kernel has pending
    uint32_t current_ = 0;         ///< the last ray that is no shadow ray
    uint32_t samples_ = 0, sample_ = 0;
    bool is_full_ = false;
};

/// From the last ray to the first, so that each is complete before it is added to its parent.
void sum_contributions(std::vector<TracedRay> &rays) {
    for (size_t i = rays.size(); i-- > 0;) {
        TracedRay &ray = rays[i];
        if (ray.kind == RayKind::shadow) {
            ray.contribution = ray.weight * ray.local_color;
            continue;
        }
        ray.contribution += ray.local_weight * ray.local_color;
        if (ray.parent != no_ray) rays[ray.parent].contribution += ray.contribution;
    }
}

void append(std::string &text, const char *words, uint32_t number) {
    text += words;
    text += std::to_string(number);
}

std::string pixel_text(uint32_t x, uint32_t y) {
    std::string text;
    append(text, "pixel ", x);
    append(text, ",", y);
    return text;
}

} // namespace

Result<RayTree> trace_ray_tree(const Accel &accel, const RenderOptions &options, uint32_t width_px, uint32_t height_px,
                               uint32_t x, uint32_t y) try {
    if (x >= width_px || y >= height_px) {
        std::string problem = pixel_text(x, y);
        append(problem, " lies outside of a picture of ", width_px);
        append(problem, " x ", height_px);
        return Error(ErrorCode::bad_input, std::move(problem) + " pixels");
    }
    const ShadingTables tables(accel.scene());
    const KernelScene kernel_scene = tables.kernel_scene(accel);
    Result<KernelFrame> frame = kernel_frame(accel.scene(), kernel_scene, options, width_px, height_px);
    if (!frame) return std::move(frame).error();

    RayTree tree;
    tree.width_px = width_px;
    tree.height_px = height_px;
    tree.x = x;
    tree.y = y;
    tree.samples = frame->samples.columns * frame->samples.rows;
    tree.max_depth = frame->max_depth;
    Recorder recorder(accel, kernel_scene, tree.rays);
    KernelScratch scratch;
    tree.color = pixel_color(kernel_scene, *frame, x, y, scratch, &recorder);
    if (recorder.is_full()) {
        std::string problem = pixel_text(x, y);
        append(problem, " has more rays than ", max_tree_rays);
        return Error(ErrorCode::limit_exceeded, std::move(problem), "choose a smaller depth or fewer samples");
    }
    for (int channel = 0; channel < 3; ++channel) tree.rgba8[channel] = pixel_byte(*frame, tree.color[channel]);
    tree.rgba8[3] = 255;
    sum_contributions(tree.rays);
    return tree;
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

} // namespace glint
