// Whitted ray tracing on Embree's packets, a tile at a time: what Glint's frames are compared with.
//
// Compiled once for each instruction set, with the widest packets that Embree has for it. A tile's pixels are traced by
// blocks (4 x 4 for 16 rays); their mirrored and transmitted rays are put side by side into full packets, level by
// level. The shading is that of core/kernel/scalar_kernel.cpp but for rounding. Shadow rays run from the light, as ours
// do: with one origin for all, Embree is some 5 % faster than the other way.
#include <embree3/rtcore.h>

#include "bench/peers/embree/packets.hpp"
#include "bench/peers/embree/simd.hpp"
#include "bench/peers/embree/whitted_scene.hpp"

namespace glint::bench::embree::GLINT_PEER_ISA {
namespace {

using Packet = Packets<width>;

constexpr float least_branch_weight = 1.0f / 4096.0f;
/// Origins of new rays are moved off the surface by this share of the largest number that went into them.
constexpr float offset_of_scale = 0x1p-18f;

constexpr int block_width = width == 4 ? 2 : 4, block_height = width / block_width;
constexpr int tile_pixels = tile_px * tile_px;

struct Vec {
    Float x, y, z;
};
inline Vec operator+(const Vec &a, const Vec &b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec &a, const Vec &b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(const Vec &a, const Float &s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Float dot(const Vec &a, const Vec &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Float max_abs(const Vec &a) {
    return max(max(abs(a.x), abs(a.y)), abs(a.z));
}
inline Vec spread(const float (&v)[3]) {
    return {all(v[0]), all(v[1]), all(v[2])};
}

/// Rays that wait to be traced: a packet at a time goes in and comes out.
class Queue {
public:
    explicit Queue(float *memory) : memory_(memory) {}

    [[nodiscard]] uint32_t size() const { return size_; }
    void clear() { size_ = 0; }
    [[nodiscard]] Float get(uint32_t field, uint32_t first) const {
        return load<Float>(memory_ + field * stride + first);
    }
    /// Adds the lanes of the mask.
    void add(const Vec &org, const Vec &dir, const Float &weight, const Int &pixel, unsigned mask) {
        const Float fields[fields_waiting] = {org.x, org.y, org.z, dir.x, dir.y, dir.z, weight, (Float)pixel};
        constexpr unsigned full = (1u << width) - 1u;
        float *const to = memory_ + size_;
        for (uint32_t f = 0; f < fields_waiting; ++f) {
            store_unaligned(to + f * stride, mask == full ? fields[f] : compress(fields[f], mask));
        }
        size_ += static_cast<uint32_t>(__builtin_popcount(mask));
    }

private:
    static constexpr uint32_t stride = most_waiting + 16;
    float *memory_;
    uint32_t size_ = 0;
};

/// Surface properties of a packet's hits.
struct Properties {
    Vec glow, diffuse;
    Float specular, exponent, reflection, transmission;
};

/// Properties by surface number: from a register where the whole table fits into one, by a broadcast where all rays hit
/// the same surface, else by gathers.
inline Properties properties_of(const WhittedScene &scene, const Int &surface) {
    const SurfaceColumns &s = scene.surfaces;
    const auto with = [&](const auto &entry) {
        return Properties{{entry(s.glow_r), entry(s.glow_g), entry(s.glow_b)},
                          {entry(s.diffuse_r), entry(s.diffuse_g), entry(s.diffuse_b)},
                          entry(s.specular),
                          entry(s.exponent),
                          entry(s.reflection),
                          entry(s.transmission)};
    };
    if (scene.surface_count < width) return with([&](const float *column) { return look_up(column, surface); });
    const int first = surface[0];
    if (bits(surface != first) == 0) return with([&](const float *column) { return all(column[first]); });
    return with([&](const float *column) { return gather(column, surface); });
}

class TileTracer {
public:
    TileTracer(const WhittedScene &scene, const WhittedFrame &frame, float *scratch)
        : scene_(scene), frame_(frame), now_(scratch), next_(scratch + scratch_floats / 2) {
        rtcInitIntersectContext(&closest_);
        rtcInitIntersectContext(&shadow_);
        closest_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        shadow_.flags = scene.shadow_coherence;
        store(rays_.ray.time, all(0.0f));
        store(rays_.ray.mask, all(-1));
        store(rays_.ray.id, all(0));
        store(rays_.ray.flags, all(0));
        store(rays_.ray.tnear, all(0.0f));
        store(shadow_rays_.time, all(0.0f));
        store(shadow_rays_.id, all(0));
        store(shadow_rays_.flags, all(0));
        store(shadow_rays_.tnear, all(0.0f));
    }

    void trace(uint32_t x0, uint32_t y0) {
        for (int i = 0; i < tile_pixels; i += width) {
            const Vec black{all(0.0f), all(0.0f), all(0.0f)};
            set_color(i, black);
        }
        for (int i = 0; i < tile_pixels; i += width) trace_block(x0, y0, i);
        closest_.flags = scene_.mirror_coherence;
        for (depth_ = 1; next_.size() > 0; ++depth_) {
            const Queue swapped = now_;
            now_ = next_;
            next_ = swapped;
            next_.clear();
            for (uint32_t first = 0; first < now_.size(); first += width) trace_waiting(first);
        }
        for (int i = 0; i < tile_pixels; i += width) write_block(x0, y0, i);
    }

private:
    static constexpr int blocks_across = tile_px / block_width;

    /// Pixels of a block, from the tile's corner.
    static void pixels_of(int first, Int &x, Int &y) {
        Int lane;
        for (int i = 0; i < width; ++i) lane[i] = i;
        const int block = first / width;
        x = lane % block_width + block % blocks_across * block_width;
        y = lane / block_width + block / blocks_across * block_height;
    }

    void trace_block(uint32_t x0, uint32_t y0, int first) {
        Int px, py;
        pixels_of(first, px, py);
        px += static_cast<int>(x0);
        py += static_cast<int>(y0);
        const Int valid = (px < static_cast<int>(frame_.width_px)) & (py < static_cast<int>(frame_.height_px));
        if (bits(valid) == 0) return;
        const Float u = __builtin_convertvector(px, Float) + 0.5f, v = __builtin_convertvector(py, Float) + 0.5f;
        const Vec dir = spread(frame_.corner) + spread(frame_.right) * u + spread(frame_.down) * v;
        Int pixel;
        for (int i = 0; i < width; ++i) pixel[i] = first + i;
        trace_packet(spread(frame_.eye), dir * rsqrt(dot(dir, dir)), all(1.0f), pixel, valid, first);
    }

    void trace_waiting(uint32_t first) {
        Int lane;
        for (int i = 0; i < width; ++i) lane[i] = i;
        const Int valid = lane < static_cast<int>(now_.size() - first);
        const Vec org{now_.get(0, first), now_.get(1, first), now_.get(2, first)};
        const Vec dir{now_.get(3, first), now_.get(4, first), now_.get(5, first)};
        const Int pixel = (Int)now_.get(7, first);
        const int begin = pixel[0];
        const bool in_a_row = bits((pixel != begin + lane) | ~valid) == 0;
        trace_packet(org, dir, now_.get(6, first), pixel, valid, in_a_row ? begin : -1);
    }

    /// Traces and shades a packet. `first` is the first of its pixels where these follow each other, else -1.
    void trace_packet(const Vec &org, const Vec &dir, const Float &weight, const Int &pixel, const Int &valid,
                      int first) {
        store(rays_.ray.org_x, org.x);
        store(rays_.ray.org_y, org.y);
        store(rays_.ray.org_z, org.z);
        store(rays_.ray.dir_x, dir.x);
        store(rays_.ray.dir_y, dir.y);
        store(rays_.ray.dir_z, dir.z);
        store(rays_.ray.tfar, all(3e38f));
        store(rays_.hit.geomID, all(-1));
        Packet::intersect(reinterpret_cast<const int *>(&valid), scene_.scene, &closest_, &rays_);

        const Int geometry = load<Int>(rays_.hit.geomID);
        const int background = static_cast<int>(scene_.surface_count);
        const Int surface = geometry < 0 ? all(background) : geometry;
        const Int is_object = (geometry >= 0) & (geometry < static_cast<int>(scene_.object_count));
        const Properties properties = properties_of(scene_, surface);
        if (bits(is_object) == 0) {
            add_color(properties.glow * weight, pixel, valid, first);
            return;
        }

        const Vec way = dir * load<Float>(rays_.ray.tfar);
        const Vec point = org + way;
        Vec normal{load<Float>(rays_.hit.Ng_x), load<Float>(rays_.hit.Ng_y), load<Float>(rays_.hit.Ng_z)};
        const Float n_d = dot(normal, dir);
        const Float unit = rsqrt(dot(normal, normal));
        normal = normal * (n_d > 0.0f ? -unit : unit);
        const Vec off = normal * (offset_of_scale * max(max_abs(point), max_abs(way)));

        Vec color = properties.glow;
        Float share = all(1.0f);
        if (depth_ < frame_.max_depth) {
            Float reflection = properties.reflection, transmission = properties.transmission;
            if (bits(is_object & ((reflection > 0.0f) | (transmission > 0.0f))) != 0) {
                const Int both = (reflection > 0.0f) & (transmission > 0.0f);
                const Int faint_mirror = both & (weight * reflection < least_branch_weight);
                const Int faint_glass = both & (weight * transmission < least_branch_weight);
                reflection = faint_mirror ? all(0.0f) : reflection;
                transmission = faint_glass ? all(0.0f) : transmission;
                share = 1.0f - reflection - transmission;
                if (const unsigned through = bits(is_object & (transmission > 0.0f))) {
                    next_.add(point - off, dir, weight * transmission, pixel, through);
                }
                if (const unsigned mirrored = bits(is_object & (reflection > 0.0f))) {
                    const Vec back = dir - normal * (2.0f * dot(normal, dir));
                    next_.add(point + off, back, weight * reflection, pixel, mirrored);
                }
            }
        }
        const Int shaded = is_object & (share > 0.0f);
        for (uint32_t i = 0; i < scene_.light_count; ++i) {
            add_light(scene_.lights[i], point, point + off, normal, dir, properties, shaded, color);
        }
        add_color(color * (weight * share), pixel, valid, first);
    }

    /// Adds the light's share to the colour where the light reaches `end`, the points moved off their surfaces.
    void add_light(const WhittedLight &light, const Vec &point, const Vec &end, const Vec &normal, const Vec &dir,
                   const Properties &properties, const Int &shaded, Vec &color) {
        const Vec position{all(light.x), all(light.y), all(light.z)};
        const Vec delta = position - point;
        const Float n_delta = dot(normal, delta);
        const Int faces = shaded & (n_delta > 0.0f);
        if (bits(faces) == 0) return;

        const Vec from_light = end - position;
        store(shadow_rays_.org_x, position.x);
        store(shadow_rays_.org_y, position.y);
        store(shadow_rays_.org_z, position.z);
        store(shadow_rays_.dir_x, from_light.x);
        store(shadow_rays_.dir_y, from_light.y);
        store(shadow_rays_.dir_z, from_light.z);
        store(shadow_rays_.tfar, all(1.0f));
        store(shadow_rays_.mask, all(static_cast<int>(light.ray_mask)));
        Packet::occluded(reinterpret_cast<const int *>(&faces), scene_.scene, &shadow_, &shadow_rays_);
        const Int reached = faces & (load<Float>(shadow_rays_.tfar) > 0.0f);
        if (bits(reached) == 0) return;

        const Float inverse_distance = rsqrt(dot(delta, delta));
        const Float n_l = n_delta * inverse_distance;
        Float highlight = all(0.0f);
        if (bits(reached & (properties.specular > 0.0f)) != 0) {
            // R.V with R = 2 (N.L) N - L and V = -D.
            const Float r_v = dot(delta, dir) * inverse_distance - 2.0f * n_l * dot(normal, dir);
            highlight = properties.specular * power(max(r_v, all(0.0f)), properties.exponent);
        }
        const Float zero = all(0.0f);
        color.x += reached ? light.r * (properties.diffuse.x * n_l + highlight) : zero;
        color.y += reached ? light.g * (properties.diffuse.y * n_l + highlight) : zero;
        color.z += reached ? light.b * (properties.diffuse.z * n_l + highlight) : zero;
    }

    void set_color(int first, const Vec &color) {
        store(red_ + first, color.x);
        store(green_ + first, color.y);
        store(blue_ + first, color.z);
    }

    void add_color(const Vec &color, const Int &pixel, const Int &valid, int first) {
        if (first >= 0) {
            store_unaligned(red_ + first, load_unaligned(red_ + first) + color.x);
            store_unaligned(green_ + first, load_unaligned(green_ + first) + color.y);
            store_unaligned(blue_ + first, load_unaligned(blue_ + first) + color.z);
            return;
        }
        for (unsigned rest = bits(valid); rest != 0; rest &= rest - 1) {
            const int i = __builtin_ctz(rest);
            red_[pixel[i]] += color.x[i];
            green_[pixel[i]] += color.y[i];
            blue_[pixel[i]] += color.z[i];
        }
    }

    static Float load_unaligned(const float *from) {
        Float x;
        __builtin_memcpy(&x, from, sizeof x);
        return x;
    }

    static Int to_byte(const Float &color) {
        return __builtin_convertvector(255.0f * min(max(color, all(0.0f)), all(1.0f)) + 0.5f, Int);
    }

    void write_block(uint32_t x0, uint32_t y0, int first) {
        const Int rgba = to_byte(load<Float>(red_ + first)) | to_byte(load<Float>(green_ + first)) << 8 |
                         to_byte(load<Float>(blue_ + first)) << 16 | static_cast<int>(0xff000000u);
        const int block = first / width;
        const uint32_t x = x0 + static_cast<uint32_t>(block % blocks_across * block_width);
        const uint32_t y = y0 + static_cast<uint32_t>(block / blocks_across * block_height);
        if (x >= frame_.width_px) return;
        const uint32_t columns = frame_.width_px - x < block_width ? frame_.width_px - x : block_width;
        for (uint32_t row = 0; row < block_height && y + row < frame_.height_px; ++row) {
            uint8_t *const to = frame_.rgba8 + (uint64_t{y + row} * frame_.width_px + x) * 4;
            const char *const from = reinterpret_cast<const char *>(&rgba) + row * block_width * 4;
            if (columns == block_width)
                __builtin_memcpy(to, from, block_width * 4);
            else
                __builtin_memcpy(to, from, columns * 4);
        }
    }

    const WhittedScene &scene_;
    const WhittedFrame &frame_;
    uint32_t depth_ = 0;
    Queue now_, next_;
    RTCIntersectContext closest_, shadow_;
    alignas(64) typename Packet::RayHit rays_;
    alignas(64) typename Packet::Ray shadow_rays_;
    // Colours of the tile's pixels, block by block.
    alignas(64) float red_[tile_pixels];
    alignas(64) float green_[tile_pixels];
    alignas(64) float blue_[tile_pixels];
};

} // namespace

void trace_tile(const WhittedScene &scene, const WhittedFrame &frame, uint32_t x0, uint32_t y0, float *scratch) {
    TileTracer(scene, frame, scratch).trace(x0, y0);
}

} // namespace glint::bench::embree::GLINT_PEER_ISA
