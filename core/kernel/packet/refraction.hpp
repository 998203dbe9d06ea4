// Transmitted rays where surfaces part media. The arithmetic is that of kernel/refraction.hpp, operation by operation;
// read that first.
#pragma once

#include "kernel/packet/surface_lanes.hpp"
#include "kernel/packet/tile_work.hpp"

namespace glint::HWY_NAMESPACE {

/// Media of a vector of rays, the innermost first.
struct MediaLanes {
    Uints inside[Media::most];
};

HWY_INLINE MediaLanes media_at(const RayLevel &level, uint32_t ray) {
    MediaLanes media;
    for (int i = 0; i < Media::most; ++i) media.inside[i] = hn::Load(uints, level.media[i] + ray);
    return media;
}
HWY_INLINE void set_media(RayLevel &level, uint32_t ray, const MediaLanes &media) {
    for (int i = 0; i < Media::most; ++i) hn::Store(media.inside[i], uints, level.media[i] + ray);
}

HWY_INLINE Uints either(FloatMask first, Uints a, Uints b) {
    return hn::IfThenElse(hn::RebindMask(uints, first), a, b);
}
HWY_INLINE MediaLanes either(FloatMask first, const MediaLanes &a, const MediaLanes &b) {
    MediaLanes media;
    for (int i = 0; i < Media::most; ++i) media.inside[i] = either(first, a.inside[i], b.inside[i]);
    return media;
}

HWY_INLINE MediaLanes media_behind(const MediaLanes &media, Uints surface) {
    // Leaving: from the surface's own place on, all move inwards. Entering: all move outwards.
    MediaLanes left, entered;
    FloatMask found = hn::RebindMask(floats, hn::Eq(media.inside[0], surface));
    for (int i = 0; i < Media::most; ++i) {
        if (i > 0) found = hn::Or(found, hn::RebindMask(floats, hn::Eq(media.inside[i], surface)));
        const Uints next = i + 1 < Media::most ? media.inside[i + 1] : hn::Set(uints, no_surface);
        left.inside[i] = either(found, next, media.inside[i]);
        entered.inside[i] = i == 0 ? surface : media.inside[i - 1];
    }
    return either(found, left, entered);
}

/// Index of refraction of the medium that each ray runs in.
HWY_INLINE Floats innermost_ior(const KernelScene &scene, const MediaLanes &media, uint32_t lanes) {
    alignas(64) uint32_t inside[lane_count];
    hn::Store(media.inside[0], uints, inside);
    return DistinctLanes(inside, lanes).floats_of([&](uint32_t surface) {
        return surface == no_surface ? 1.0f : scene.surfaces[surface].ior;
    });
}

struct RefractedLanes {
    Points dir;
    Floats reflection; ///< share that is mirrored instead
    MediaLanes media;
};

/// refract() in every lane; others than the given ones hold nothing of use.
HWY_INLINE RefractedLanes refract(const KernelScene &scene, const MediaLanes &media, Uints surface, const Points &dir,
                                  const Points &normal, uint32_t lanes) {
    const Floats one = splat(1.0f), zero = hn::Zero(floats);
    RefractedLanes result;
    result.media = media_behind(media, surface);
    const Floats from = innermost_ior(scene, media, lanes), to = innermost_ior(scene, result.media, lanes);
    const FloatMask bends = hn::Ne(from, to);
    const Floats eta = from / to;
    const Floats cos_in = hn::Neg(dot(dir, normal));
    const Floats squared = one - (eta * eta) * (one - cos_in * cos_in);
    const FloatMask gets_through = hn::Gt(squared, zero);
    const Floats cos_out = hn::Sqrt(hn::IfThenElse(gets_through, squared, one));
    const Floats along_normal = eta * cos_in - cos_out;
    const Points bent = normalized(sum(scaled(dir, eta), scaled(normal, along_normal)));
    result.dir = either(hn::And(bends, gets_through), bent, dir);
    Floats mirrored = zero;
    if (scene.fresnel) {
        const Floats parallel = (to * cos_in - from * cos_out) / (to * cos_in + from * cos_out);
        const Floats across = (from * cos_in - to * cos_out) / (from * cos_in + to * cos_out);
        const Floats share = splat(0.5f) * (parallel * parallel + across * across);
        mirrored = hn::IfThenElse(hn::Lt(share, one), share, one);
    }
    result.reflection = hn::IfThenElse(bends, hn::IfThenElse(gets_through, mirrored, one), zero);
    return result;
}

} // namespace glint::HWY_NAMESPACE
