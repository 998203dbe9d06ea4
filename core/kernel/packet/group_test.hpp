// A group of rays against triangles: what a leaf holds is culled against the rays' beam, and settled for all rays at
// once where it can be.
#pragma once

#include "kernel/packet/block_beams.hpp"
#include "kernel/packet/block_reach.hpp"
#include "kernel/packet/triangle_test.hpp"

namespace glint::HWY_NAMESPACE {

/// What is asked of a ray: the closest hit, or whether there is any. Shadow rays pass through their light's own mesh.
struct TraceQuestion {
    const GeometryView &geometry;
    uint32_t first_passed = 0, passed_count = 0; ///< triangles that do not block
};

/// After this many triangles in a group's beam it pays to look at each block's own beam first.
inline constexpr uint32_t block_beams_after = 8;

template <bool shares_origin, bool any_hit> class GroupTest {
public:
    /// `rays` holds what RayGroup says; of the selected rays those that are hit are deselected where any hit will do.
    HWY_INLINE GroupTest(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, const Beam &beam,
                         const RayEnds *ends)
        : question_(question),
          beam_(beam),
          rays_(rays),
          selection_(selection),
          corners_{hn::Zero(floats), hn::Zero(floats), hn::Zero(floats)} {
        for (uint32_t &id : seen_) id = no_triangle;
        reach_ = beam.slack * 0x1p20f;
        if (ends) {
            ends_ = *ends;
            has_ends_ = true;
        }
    }

    /// True when there is nothing left to trace.
    HWY_NOINLINE bool visit_leaf(uint32_t first_reference, uint32_t count) {
        const uint32_t *words = question_.geometry.leaf_words + words_per_reference * size_t{first_reference};
        dirty_blocks_ = 0;
        for (uint32_t first = 0; first < count; first += lane_count) {
            const uint32_t valid = count - first >= lane_count ? all_lanes : (1u << (count - first)) - 1;
            const BeamCorners corners(beam_.axes, words, count, first);
            uint32_t entered = triangles_in_beam(beam_, corners) & valid;
            if (entered == 0) continue;
            steps_ += 2 * static_cast<uint32_t>(__builtin_popcount(entered));
            // Nearest first, as long as they are not beyond what all rays hit.
            alignas(64) float depth[lane_count];
            if constexpr (!any_hit) hn::Store(min3(corners.z[0], corners.z[1], corners.z[2]), floats, depth);
            while (entered != 0) {
                uint32_t nearest = lowest_bit(entered);
                if constexpr (!any_hit) {
                    for (uint32_t rest = entered & (entered - 1); rest != 0; rest &= rest - 1) {
                        if (depth[lowest_bit(rest)] < depth[nearest]) nearest = lowest_bit(rest);
                    }
                    if (depth[nearest] > beam_.z_end) break;
                }
                entered &= ~(1u << nearest);
                test(words, count, first + nearest);
            }
        }
        if (dirty_blocks_ == 0) return false;
        if (any_hit && selection_.empty()) return true;
        update_group_end();
        return false;
    }

    /// For closest hits of rays that make no beam, in a tree that is a single leaf: all its triangles, each against all
    /// blocks that can get there. Of the beam `dir_reach` and `slack` must be known, and no apex.
    HWY_INLINE void visit_root_leaf() {
        static_assert(!any_hit);
        const KdNode root = question_.geometry.nodes[0];
        const uint32_t count = root.reference_count();
        const uint32_t *words = question_.geometry.leaf_words + words_per_reference * size_t{root.first_reference()};
        const BlockReach reach(rays_, selection_, beam_.slack);
        for (uint32_t i = 0; i < count; ++i) {
            const TriangleSetup triangle(words, count, i);
            const uint32_t blocks = reach.of(triangle.corners);
            if (blocks != 0) test_blocks(triangle, ExactPlane(triangle), blocks);
        }
    }

protected:
    HWY_NOINLINE void make_block_beams() {
        make_block_sides<shares_origin>(rays_, selection_, beam_, blocks_);
        for (uint32_t block = 0; block < block_count; ++block) update_end(block);
        has_block_beams_ = true;
    }
    HWY_INLINE void update_end(uint32_t block) {
        blocks_.z_end[block] = block_end<shares_origin>(rays_, block, selection_.blocks[block], beam_);
    }
    HWY_INLINE uint32_t lanes_that_left(uint32_t id, uint32_t ray) const {
        return bits_of(hn::RebindMask(floats, hn::Eq(hn::Set(uints, id), hn::Load(uints, rays_.left + ray))));
    }

    HWY_INLINE void take_nearer(uint32_t triangle_id, uint32_t ray, uint32_t lanes, Floats t) {
        const Floats best = hn::Load(floats, rays_.t + ray);
        const Uints id = hn::Set(uints, triangle_id);
        FloatMask nearer = hn::Lt(t, best);
        if constexpr (!any_hit) {
            const Uints best_id = hn::Load(uints, rays_.triangle_id + ray);
            const FloatMask lower_id = hn::RebindMask(floats, hn::Lt(id, best_id));
            nearer = hn::Or(nearer, hn::And(hn::Eq(t, best), lower_id));
        }
        const FloatMask hit = hn::And(hn::And(nearer, hn::Gt(t, hn::Zero(floats))), mask_of(lanes));
        const uint32_t hit_bits = bits_of(hit);
        dirty_blocks_ |= (hit_bits != 0 ? 1u : 0u) << (ray / block_size);
        if constexpr (any_hit) {
            selection_.remove(ray, hit_bits);
        } else {
            hn::Store(hn::IfThenElse(hit, t, best), floats, rays_.t + ray);
            const Uints old = hn::Load(uints, rays_.triangle_id + ray);
            hn::Store(hn::IfThenElse(hn::RebindMask(uints, hit), id, old), uints, rays_.triangle_id + ray);
        }
    }

    const TraceQuestion &question_;
    Beam beam_; ///< its end comes nearer with what is hit
    RayGroup &rays_;
    RaySelection &selection_;
    uint32_t steps_ = 0;        ///< counts what is done
    uint32_t dirty_blocks_ = 0; ///< where something was hit since their ends were found
    BlockBeams blocks_;

private:
    HWY_INLINE void test(const uint32_t *words, uint32_t count, uint32_t i) {
        const uint32_t id = words[9 * count + i];
        uint32_t &seen = seen_[id % seen_slots];
        if (seen == id) return;
        seen = id;
        if (any_hit && id - question_.first_passed < question_.passed_count) return;
        const TriangleSetup triangle(words, count, i);
        const ExactPlane plane(triangle);
        if constexpr (shares_origin && any_hit) {
            if (all_end_before(triangle, plane)) return;
        }
        if (shares_origin || beam_.has_apex()) {
            test_from_apex(triangle, plane);
            return;
        }
        test_blocks(triangle, plane, blocks_entered_by(triangle));
    }

    /// The rays of some blocks, which start anywhere.
    HWY_INLINE void test_blocks(const TriangleSetup &triangle, const ExactPlane &plane, uint32_t blocks) {
        const TriangleFromAnywhere test(triangle, beam_.dir_reach, reach_);
        test_vectors(
            triangle, blocks, [&](uint32_t ray) { return test.filter(rays_.org(ray), rays_.dir(ray)); },
            [&](uint32_t ray, uint32_t lanes) { return distances(triangle, plane, ray, lanes); });
    }

    HWY_INLINE void test_from_apex(const TriangleSetup &triangle, const ExactPlane &plane) {
        if (tested_ == 0) {
            corners_ = corner_directions(beam_);
            corner_reach_ = corner_reach(beam_);
        }
        const float off = shares_origin ? 0.0f : 4.0f * (1.0f + beam_.steepest()) * beam_.apex_miss;
        TriangleFromPoint test(triangle, plane, beam_.apex, beam_.dir_reach, off);
        const BeamVerdict verdict = test.judge_beam(corners_, corner_reach_);
        if (verdict == BeamVerdict::missed) return;
        const auto distances_of = [&](uint32_t ray, uint32_t lanes) {
            if constexpr (shares_origin) return test.distances(rays_.dir(ray), lanes);
            return distances(triangle, plane, ray, lanes);
        };
        if (verdict == BeamVerdict::covered) {
            hit_vectors(triangle, distances_of);
            ++tested_;
            if (!any_hit) update_group_end();
            return;
        }
        test_vectors(
            triangle, blocks_entered_by(triangle), [&](uint32_t ray) { return test.filter(rays_.dir(ray)); },
            distances_of);
    }

    HWY_INLINE Floats distances(const TriangleSetup &triangle, const ExactPlane &plane, uint32_t ray,
                                uint32_t lanes) const {
        return distances_from_anywhere(triangle, plane, rays_.org(ray), rays_.dir(ray), lanes);
    }

    HWY_INLINE uint32_t blocks_entered_by(const TriangleSetup &triangle) {
        if (++tested_ <= block_beams_after) return all_blocks;
        if (!has_block_beams_) make_block_beams();
        return blocks_.entered_by(beam_.axes, triangle.corners);
    }

    /// Whether the triangle's plane has all rays, from origin to end, on one side for certain: then no ray can meet it
    /// before its end. True of the surfaces that shadow rays end on, and of all walls of a convex room.
    HWY_INLINE bool all_end_before(const TriangleSetup &triangle, const ExactPlane &plane) {
        if (!has_ends_) {
            ends_ = find_ends(rays_, selection_);
            has_ends_ = true;
        }
        const Point3 n = plane.n.rounded();
        const double at_origin = -plane.offset(triangle, rays_.shared_origin);
        const double side = at_origin < 0.0 ? -1.0 : 1.0;
        const auto least = [side](double m, double lo, double hi) {
            const double a = side * m * lo, b = side * m * hi;
            return a < b ? a : b;
        };
        const double a[3] = {triangle.corners[0], triangle.corners[1], triangle.corners[2]};
        const double at_ends = least(plane.n.x, ends_.lo.x - a[0], ends_.hi.x - a[0]) +
                               least(plane.n.y, ends_.lo.y - a[1], ends_.hi.y - a[1]) +
                               least(plane.n.z, ends_.lo.z - a[2], ends_.hi.z - a[2]);
        // With eps = 2^-24: t is off by 4 eps sum|n| |dir| / det + 2 eps, of which 4 eps are left between a ray's t_max
        // and the end taken here; an end is off by eps of itself and of the way. A triangle seen edge on (least_det)
        // may be hit as far as it reaches along the ray from where that meets its plane, 2^-26 |e|^3 off the plane at
        // most. The rest is for the differences above.
        const double e = triangle.edge_reach;
        const double margin = double(0x1p-24f * sum_abs(n)) * (5.0f * ends_.way + ends_.reach) +
                              (0x1p-46 * e) * (e * reach_) + (0x1p-25 * e) * (e * e);
        return at_origin * side > margin && at_ends > margin;
    }

    template <typename Filter, typename Distances> HWY_INLINE void
    test_vectors(const TriangleSetup &triangle, uint32_t blocks, Filter &&filter, Distances &&distances) {
        for_each_vector(selection_, blocks, [&](uint32_t ray, uint32_t lanes) {
            const FilterResult result = filter(ray);
            const uint32_t possible = bits_of(result.possible) & lanes & ~lanes_that_left(triangle.id, ray);
            if (possible == 0) return;
            const uint32_t certain = bits_of(result.certain) & possible;
            Floats t = distances(ray, certain);
            if (certain != possible) t = with_exact_distances(triangle, ray, possible & ~certain, t);
            take_nearer(triangle.id, ray, possible, t);
        });
    }

    /// As test_vectors() of all blocks where the filter is known to be certain.
    template <typename Distances> HWY_INLINE void hit_vectors(const TriangleSetup &triangle, Distances &&distances) {
        for_each_vector(selection_, [&](uint32_t ray, uint32_t selected) {
            const uint32_t lanes = selected & ~lanes_that_left(triangle.id, ray);
            if (lanes != 0) take_nearer(triangle.id, ray, lanes, distances(ray, lanes));
        });
    }

    /// Asks the definition for some of the lanes.
    HWY_NOINLINE Floats with_exact_distances(const TriangleSetup &triangle, uint32_t ray, uint32_t lanes,
                                             Floats t) const {
        alignas(64) float distances[lane_count];
        hn::Store(t, floats, distances);
        for (; lanes != 0; lanes &= lanes - 1) {
            const uint32_t lane = lowest_bit(lanes), i = ray + lane;
            const float dir[3] = {rays_.dir_x[i], rays_.dir_y[i], rays_.dir_z[i]};
            float org[3] = {rays_.shared_origin.x, rays_.shared_origin.y, rays_.shared_origin.z};
            if (!shares_origin) {
                org[0] = rays_.org_x[i];
                org[1] = rays_.org_y[i];
                org[2] = rays_.org_z[i];
            }
            distances[lane] = exact_distance(org, dir, triangle.corners);
        }
        return hn::Load(floats, distances);
    }

    HWY_INLINE void update_group_end() {
        if (has_block_beams_) {
            for (; dirty_blocks_ != 0; dirty_blocks_ &= dirty_blocks_ - 1) update_end(lowest_bit(dirty_blocks_));
            beam_.z_end = largest_end();
        } else {
            beam_.z_end = group_end<shares_origin>(rays_, selection_, beam_);
            dirty_blocks_ = 0;
        }
    }

    HWY_INLINE float largest_end() const {
        Floats end = hn::Load(floats, blocks_.z_end);
        for (uint32_t b = lane_count; b < block_count; b += lane_count) {
            end = hn::Max(end, hn::Load(floats, blocks_.z_end + b));
        }
        return greatest_lane(end);
    }

    /// A triangle in several leaves is tested once, if it is remembered.
    static constexpr uint32_t seen_slots = 64;

    float reach_;
    uint32_t tested_ = 0;
    uint32_t seen_[seen_slots];
    Points corners_;
    float corner_reach_ = 1.0f;
    bool has_block_beams_ = false;
    bool has_ends_ = false;
    RayEnds ends_{};
};

} // namespace glint::HWY_NAMESPACE
