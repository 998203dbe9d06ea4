// Rays of one's own against a scene's triangles: what is hit, and whether anything is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <glint/accel.hpp>
#include <glint/export.hpp>
#include <glint/isa.hpp>

namespace glint {

/// Rays org + t * dir with 0 < t < t_max, coordinate by coordinate: each pointer leads to `count` floats. Directions
/// need not have unit length; they are finite and not zero, and coordinates are at most max_coordinate.
///
/// Rays that stand near each other are traced together, in groups of up to 256: order them so that neighbours go the
/// same way (pixels by blocks of 4 x 4 in tiles of 16 x 16, shadow rays of neighbouring points from one light).
/// Order changes the speed only.
struct RayBatch {
    size_t count = 0;
    const float *org_x = nullptr, *org_y = nullptr, *org_z = nullptr;
    const float *dir_x = nullptr, *dir_y = nullptr, *dir_z = nullptr;
    const float *t_max = nullptr;
};

/// The triangle_id of a ray that hits nothing.
inline constexpr uint32_t no_triangle = UINT32_MAX;

/// Where the rays of a batch end; each pointer leads to `count` elements.
struct HitBatch {
    float *t = nullptr; ///< t_max where nothing is hit
    /// In the scene's numbering, in which quadrics come behind the triangles; of several at the same t the lowest.
    uint32_t *triangle_id = nullptr;
};

/// Answers questions about rays on the calling thread. Immutable: any number of threads may ask at once.
class GLINT_API RayQuery {
public:
    /// `isa` is one of available_isas(); any other counts as Isa::scalar.
    explicit RayQuery(std::shared_ptr<const Accel> accel, Isa isa = best_isa());
    ~RayQuery();
    RayQuery(const RayQuery &) = delete;
    RayQuery &operator=(const RayQuery &) = delete;

    /// The nearest hit of every ray.
    void closest_hits(const RayBatch &rays, const HitBatch &hits) const;
    /// Sets occluded[i] to 1 where anything is hit, else to 0.
    void any_hits(const RayBatch &rays, uint8_t *occluded) const;

    [[nodiscard]] Isa isa() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace glint
