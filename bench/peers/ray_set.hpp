// Rays that several tracers are asked about: the same numbers for all.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glint/ray_query.hpp>

namespace glint::bench {

enum class RayQuestion {
    closest_hit, ///< which triangle is hit first, and where
    any_hit,     ///< whether there is any
};

/// Rays coordinate by coordinate, as a RayBatch wants them, and what is asked about them.
struct RaySet {
    std::string name; ///< e.g. "primary"
    RayQuestion question;
    std::vector<float> org_x, org_y, org_z, dir_x, dir_y, dir_z, t_max;

    RaySet(std::string name_, RayQuestion question_) : name(std::move(name_)), question(question_) {}

    [[nodiscard]] size_t size() const { return t_max.size(); }
    void add(const Point &org, const Vector &dir, float t_max_) {
        org_x.push_back(org.x), org_y.push_back(org.y), org_z.push_back(org.z);
        dir_x.push_back(dir.x), dir_y.push_back(dir.y), dir_z.push_back(dir.z);
        t_max.push_back(t_max_);
    }
    /// Rays first <= i < first + count; valid as long as the set is and no ray is added.
    [[nodiscard]] RayBatch batch(size_t first, size_t count) const {
        return {count,
                org_x.data() + first,
                org_y.data() + first,
                org_z.data() + first,
                dir_x.data() + first,
                dir_y.data() + first,
                dir_z.data() + first,
                t_max.data() + first};
    }
};

/// What became of every ray of a set.
struct RayAnswers {
    std::vector<float> t;              ///< of a closest hit
    std::vector<uint32_t> triangle_id; ///< of a closest hit; no_triangle where nothing is hit
    std::vector<uint8_t> occluded;     ///< of any_hit: 1 where something is hit, else 0

    explicit RayAnswers(const RaySet &rays) {
        if (rays.question == RayQuestion::any_hit) {
            occluded.resize(rays.size());
        } else {
            t.resize(rays.size());
            triangle_id.resize(rays.size());
        }
    }
};

} // namespace glint::bench
