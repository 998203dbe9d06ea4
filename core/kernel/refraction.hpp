// What becomes of a ray where a transmissive surface parts two media.
//
// Which side of a surface is inside is not asked of its winding, which in old files is anybody's guess: a ray that
// meets a surface it is not inside of goes in, any other comes out. The media that a ray is inside of are a stack, the
// innermost first; it runs in that one, in vacuum where there is none. Coming out of a medium that lies deeper in the
// stack (two overlap) changes nothing but the stack. Of more than Media::most the outermost are forgotten.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include "kernel/kernel.hpp"
#include "math/vec.hpp"

namespace glint {

inline float innermost_ior(const KernelScene &scene, const Media &media) {
    return media.inside[0] == no_surface ? 1.0f : scene.surfaces[media.inside[0]].ior;
}

/// The media behind a surface.
inline Media media_behind(const Media &media, uint32_t surface) {
    Media behind{};
    int place = 0;
    while (place < Media::most && media.inside[place] != surface) ++place;
    if (place == Media::most) {
        behind.inside[0] = surface;
        for (int i = 1; i < Media::most; ++i) behind.inside[i] = media.inside[i - 1];
        return behind;
    }
    for (int i = 0; i < Media::most; ++i) {
        const int from = i < place ? i : i + 1;
        behind.inside[i] = from < Media::most ? media.inside[from] : no_surface;
    }
    return behind;
}

struct Refraction {
    glm::vec3 dir;    ///< of the transmitted ray, unit length
    float reflection; ///< share of the light that is mirrored instead: 1 where none gets through
    Media media;      ///< of the transmitted ray
};

/// Snell's law, in the form of Heckbert (1989, "Derivation of refraction formulas", in Glassner, "An introduction to
/// ray tracing"); total internal reflection where it has no solution; Fresnel's equations for unpolarised light where
/// the scene asks. `normal` faces the ray, both are unit vectors.
inline Refraction refract(const KernelScene &scene, const Media &media, uint32_t surface, const glm::vec3 &dir,
                          const glm::vec3 &normal) {
    Refraction result{dir, 0.0f, media_behind(media, surface)};
    const float from = innermost_ior(scene, media), to = innermost_ior(scene, result.media);
    if (from == to) return result;
    const float eta = from / to;
    const float cos_in = -dot(dir, normal);
    const float squared = 1.0f - (eta * eta) * (1.0f - cos_in * cos_in);
    if (!(squared > 0.0f)) {
        result.reflection = 1.0f;
        return result;
    }
    const float cos_out = std::sqrt(squared);
    const float along_normal = eta * cos_in - cos_out;
    result.dir = normalize({eta * dir.x + along_normal * normal.x, eta * dir.y + along_normal * normal.y,
                            eta * dir.z + along_normal * normal.z});
    if (scene.fresnel) {
        const float parallel = (to * cos_in - from * cos_out) / (to * cos_in + from * cos_out);
        const float across = (from * cos_in - to * cos_out) / (from * cos_in + to * cos_out);
        const float share = 0.5f * (parallel * parallel + across * across);
        result.reflection = share < 1.0f ? share : 1.0f;
    }
    return result;
}

} // namespace glint
