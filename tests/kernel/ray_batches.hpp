// Batches of rays that send packet kernels down every way they have: beams that hold, beams that fall apart, single
// rays.
#pragma once

#include <string_view>
#include <vector>

#include <glint/ray_query.hpp>

#include "accel/ray_sets.hpp"

namespace glint::test {

/// The rays of a RayBatch, and where they lie.
struct RayRows {
    std::vector<float> org_x, org_y, org_z, dir_x, dir_y, dir_z, t_max;

    void add(const Ray &ray, float limit);
    [[nodiscard]] size_t count() const { return t_max.size(); }
    [[nodiscard]] RayBatch batch() const;
};

/// The endless list of batches that belongs to a mesh. Kinds take turns.
class BatchSet {
public:
    explicit BatchSet(const Mesh &mesh);

    /// Some 250 rays on average, at most 700. Limits are one and all FLT_MAX, random, or those of shadow rays.
    [[nodiscard]] RayRows batch(uint32_t number) const;

private:
    [[nodiscard]] Point special_point(Random &random, uint32_t triangle) const;
    [[nodiscard]] Point any_origin(Random &random) const;
    [[nodiscard]] std::vector<Ray> rays(Random &random, uint32_t kind, uint32_t number, uint32_t count) const;

    const Mesh &mesh_;
    RaySet singles_;
    Point center_;
    float reach_;
};

} // namespace glint::test
