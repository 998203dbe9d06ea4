// What streams and the single rays that they end in need to know of each ray, worked out for a whole group at once: how
// it meets boxes, leaves, and the wide hierarchy's nodes.
#pragma once

#include "kernel/packet/leaf_test.hpp"
#include "kernel/packet/wide_single.hpp"

namespace glint::HWY_NAMESPACE {

template <bool shares_origin> class StreamRays {
    /// The shared origin moved by what is lost in rounding, so that rays of an octant meet planes in time: before what
    /// is near, behind what is far.
    struct OctantOrigin {
        float near[3], far[3];

        HWY_INLINE OctantOrigin(const StreamRays &of, uint32_t octant) {
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const float at = coordinate(of.rays_.shared_origin, static_cast<int>(axis));
                const float by = (octant >> axis & 1) != 0 ? -of.widening_[axis] : of.widening_[axis];
                near[axis] = at + by;
                far[axis] = at - by;
            }
        }
    };

public:
    HWY_INLINE StreamRays(const TraceQuestion &question, const RayGroup &rays) : question_(question), rays_(rays) {}

    /// For the selected rays. Returns in which axes' signs they differ.
    HWY_NOINLINE uint32_t prepare(const RaySelection &selection) {
        const Box &box = question_.geometry.bounds;
        Uints some = hn::Zero(uints), every = hn::Set(uints, 7);
        Floats most_dir = hn::Zero(floats);
        const auto reach_from = [&](const Points &org) {
            const Points to_lo = {splat(box.lo.x) - org.x, splat(box.lo.y) - org.y, splat(box.lo.z) - org.z};
            const Points to_hi = {splat(box.hi.x) - org.x, splat(box.hi.y) - org.y, splat(box.hi.z) - org.z};
            return hn::Max(max_abs(to_lo), max_abs(to_hi));
        };
        if constexpr (shares_origin) {
            const float slack = slack_of_extent * hn::GetLane(reach_from(splat(rays_.shared_origin)));
            for (int axis = 0; axis < 3; ++axis) {
                widening_[axis] = slack + 0x1p-21f * magnitude(coordinate(rays_.shared_origin, axis));
            }
        }
        for_each_vector(selection, [&](uint32_t ray, uint32_t lane_bits) {
            const FloatMask lanes = mask_of(lane_bits);
            const Points dir = rays_.dir(ray);
            const Floats largest = max_abs(dir);
            most_dir = hn::Max(most_dir, hn::IfThenElseZero(lanes, largest));
            // Distances through boxes are counted in units of the direction's power of two: without that a very short
            // direction's inverse, times the origin, might not be finite.
            const Uints exponent =
                hn::Max(hn::And(hn::BitCast(uints, largest), hn::Set(uints, 0x7f800000u)), hn::Set(uints, 0x00800000u));
            const Floats unit = hn::BitCast(floats, exponent), by_unit = splat(1.0f) / unit;
            const Floats tiny = splat(1e-15f) * (largest * by_unit);
            const Floats components[3] = {dir.x * by_unit, dir.y * by_unit, dir.z * by_unit};
            Uints octant = hn::Zero(uints);
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const Floats d = hn::IfThenElse(hn::Lt(hn::Abs(components[axis]), tiny),
                                                hn::CopySign(tiny, components[axis]), components[axis]);
                hn::Store(splat(1.0f) / d, floats, inverse_[axis] + ray);
                octant = octant + hn::ShiftLeftSame(hn::ShiftRight<31>(hn::BitCast(uints, d)), static_cast<int>(axis));
            }
            const Floats t = hn::Load(floats, rays_.t + ray);
            hn::Store((t + splat(distance_error) * t) * unit, floats, end_ + ray);
            hn::Store(unit, floats, unit_ + ray);
            hn::Store(octant, uints, octant_ + ray);
            hn::Store(largest, floats, ray_dir_reach_ + ray);
            if constexpr (!shares_origin) {
                const Points org = rays_.org(ray);
                const Floats origins[3] = {org.x, org.y, org.z}, slack = splat(slack_of_extent) * reach_from(org);
                for (uint32_t axis = 0; axis < 3; ++axis) {
                    const Floats inverse = hn::Load(floats, inverse_[axis] + ray), at_origin = origins[axis] * inverse;
                    const Floats widening = slack * hn::Abs(inverse) + splat(0x1p-21f) * hn::Abs(at_origin);
                    hn::Store(at_origin + widening, floats, near_offset_[axis] + ray);
                    hn::Store(at_origin - widening, floats, far_offset_[axis] + ray);
                }
                // As leaf_ray() has it. Not by the inverse, which is not exact where a direction is very long.
                const Floats along[3] = {hn::Abs(dir.x), hn::Abs(dir.y), hn::Abs(dir.z)};
                const FloatMask by_x = hn::And(hn::Ge(along[0], along[1]), hn::Ge(along[0], along[2]));
                const FloatMask by_y = hn::Ge(along[1], along[2]);
                const Floats most = hn::IfThenElse(by_x, dir.x, hn::IfThenElse(by_y, dir.y, dir.z));
                hn::Store(hn::IfThenElse(by_x, dir.y, dir.x) / most, floats, slope_x_ + ray);
                hn::Store(hn::IfThenElse(hn::Or(by_x, by_y), dir.z, dir.y) / most, floats, slope_y_ + ray);
                hn::Store(hn::IfThenZeroElse(
                              hn::RebindMask(uints, by_x),
                              hn::IfThenElse(hn::RebindMask(uints, by_y), hn::Set(uints, 1), hn::Set(uints, 2))),
                          uints, most_along_ + ray);
            }
            const auto selected = hn::RebindMask(uints, lanes);
            some = hn::Or(some, hn::IfThenElseZero(selected, octant));
            every = hn::And(every, hn::IfThenElse(selected, octant, every));
        });
        dir_reach_ = greatest_lane(most_dir);
        alignas(64) uint32_t lanes[2][lane_count];
        hn::Store(some, uints, lanes[0]);
        hn::Store(every, uints, lanes[1]);
        uint32_t in_some = 0, in_every = 7;
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            in_some |= lanes[0][lane];
            in_every &= lanes[1][lane];
        }
        return in_some & ~in_every;
    }

    /// Appends the selected rays of a block, from one point, that enter a node's child; returns how many. Up to a
    /// vector more is written.
    template <bool any_hit> HWY_INLINE uint32_t enter(const RaySelection &selection, uint32_t block,
                                                      const WideNode &node, uint32_t child, uint32_t *to) {
        const uint32_t first_ray = block * block_size,
                       octant = octant_[first_ray + lowest_bit(selection.blocks[block])];
        const OctantOrigin origin(*this, octant);
        const auto plane = [&](uint32_t axis, bool far) {
            const bool highest = ((octant >> axis & 1) != 0) != far;
            return splat(node.bounds[axis + (highest ? WideNode::highest : WideNode::lowest)][child] -
                         (far ? origin.far : origin.near)[axis]);
        };
        const Floats near[3] = {plane(0, false), plane(1, false), plane(2, false)};
        const Floats far[3] = {plane(0, true), plane(1, true), plane(2, true)};
        uint32_t count = 0;
        for (uint32_t part = 0; part < block_size; part += lane_count) {
            const uint32_t ray = first_ray + part;
            const Floats x = hn::Load(floats, inverse_[0] + ray), y = hn::Load(floats, inverse_[1] + ray),
                         z = hn::Load(floats, inverse_[2] + ray);
            Floats end = hn::Load(floats, end_ + ray);
            if constexpr (!any_hit) { // something nearer may have been found
                const Floats t = hn::Load(floats, rays_.t + ray);
                end = (t + splat(distance_error) * t) * hn::Load(floats, unit_ + ray);
                hn::Store(end, floats, end_ + ray);
            }
            const Floats begin = hn::Max(max3(near[0] * x, near[1] * y, near[2] * z), hn::Zero(floats));
            const Floats stop = hn::Min(min3(far[0] * x, far[1] * y, far[2] * z), end);
            const uint32_t lanes = bits_of(hn::Le(begin, stop)) & selection.lanes(ray);
            count += put_chosen(hn::Iota(uints, ray), lanes, to + count);
        }
        return count;
    }

    [[nodiscard]] HWY_INLINE uint32_t octant(uint32_t ray) const { return octant_[ray]; }
    /// The largest coordinate of its direction; of all selected rays' directions.
    [[nodiscard]] HWY_INLINE float dir_reach(uint32_t ray) const { return ray_dir_reach_[ray]; }
    [[nodiscard]] HWY_INLINE float dir_reach() const { return dir_reach_; }
    /// Of distances through boxes.
    [[nodiscard]] HWY_INLINE float unit(uint32_t ray) const { return unit_[ray]; }
    /// How far it looks, in its unit; negative when it is done.
    [[nodiscard]] HWY_INLINE float end(uint32_t ray) const { return end_[ray]; }
    HWY_INLINE void set_end(uint32_t ray, float t) { end_[ray] = (t + distance_error * t) * unit_[ray]; }
    HWY_INLINE void set_done(uint32_t ray) { end_[ray] = -1.0f; }

    [[nodiscard]] HWY_INLINE Point3 dir(uint32_t ray) const {
        return {rays_.dir_x[ray], rays_.dir_y[ray], rays_.dir_z[ray]};
    }
    /// Not where rays share an origin.
    [[nodiscard]] HWY_INLINE Point3 org(uint32_t ray) const {
        return {rays_.org_x[ray], rays_.org_y[ray], rays_.org_z[ray]};
    }

    [[nodiscard]] HWY_INLINE WideSlabs slabs(uint32_t ray) const {
        const Point3 inverse = {inverse_[0][ray], inverse_[1][ray], inverse_[2][ray]};
        if constexpr (shares_origin) {
            const OctantOrigin origin(*this, octant_[ray]);
            const auto offset = [&](const float(&at)[3]) {
                return Point3{at[0] * inverse.x, at[1] * inverse.y, at[2] * inverse.z};
            };
            return {inverse, offset(origin.near), offset(origin.far)};
        } else {
            return {inverse,
                    {near_offset_[0][ray], near_offset_[1][ray], near_offset_[2][ray]},
                    {far_offset_[0][ray], far_offset_[1][ray], far_offset_[2][ray]}};
        }
    }

    [[nodiscard]] HWY_INLINE LeafRay leaf_ray(uint32_t ray) const {
        // Few rays from one point come so far alone.
        if constexpr (shares_origin) return HWY_NAMESPACE::leaf_ray(rays_.shared_origin, dir(ray), rays_.left[ray]);
        const uint32_t z = most_along_[ray];
        const float *const along[3] = {rays_.dir_x, rays_.dir_y, rays_.dir_z};
        return {org(ray), dir(ray), rays_.left[ray], z, slope_x_[ray], slope_y_[ray], along[z][ray]};
    }

    /// A node as rays of an octant meet it.
    class Node {
    public:
        HWY_INLINE Node(const StreamRays &rays, const WideNode &node, const WideRows &rows, uint32_t octant)
            : rays_(rays) {
            const float *const bounds = node.bounds[0];
            const size_t near_rows[3] = {rows.near_x, rows.near_y, rows.near_z};
            const size_t far_rows[3] = {rows.far_x(), rows.far_y(), rows.far_z()};
            for (uint32_t axis = 0; axis < 3; ++axis) {
                near_[axis] = bounds + near_rows[axis];
                far_[axis] = bounds + far_rows[axis];
            }
            if constexpr (shares_origin) {
                const OctantOrigin origin(rays, octant);
                for (uint32_t axis = 0; axis < 3; ++axis) {
                    for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
                        near_plane_[axis][c / narrow_lanes] =
                            hn::Load(narrow_floats, near_[axis] + c) - narrow_splat(origin.near[axis]);
                        far_plane_[axis][c / narrow_lanes] =
                            hn::Load(narrow_floats, far_[axis] + c) - narrow_splat(origin.far[axis]);
                    }
                }
            }
        }

        /// Where a ray's way through each of narrow_lanes children begins, from child c on, and whether there is any.
        struct Ways {
            NarrowFloats begin;
            hn::Mask<NarrowTag> exist;
        };
        [[nodiscard]] HWY_INLINE Ways ways_of(uint32_t ray, uint32_t c) const {
            NarrowFloats near[3], far[3];
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const auto inverse = narrow_splat(rays_.inverse_[axis][ray]);
                if constexpr (shares_origin) {
                    near[axis] = near_plane_[axis][c / narrow_lanes] * inverse;
                    far[axis] = far_plane_[axis][c / narrow_lanes] * inverse;
                } else {
                    near[axis] = hn::MulSub(hn::Load(narrow_floats, near_[axis] + c), inverse,
                                            narrow_splat(rays_.near_offset_[axis][ray]));
                    far[axis] = hn::MulSub(hn::Load(narrow_floats, far_[axis] + c), inverse,
                                           narrow_splat(rays_.far_offset_[axis][ray]));
                }
            }
            const auto begin = hn::Max(hn::Max(near[0], near[1]), hn::Max(near[2], hn::Zero(narrow_floats)));
            const auto stop = hn::Min(hn::Min(far[0], far[1]), hn::Min(far[2], narrow_splat(rays_.end_[ray])));
            return {begin, hn::Le(begin, stop)};
        }

    private:
        const StreamRays &rays_;
        const float *near_[3], *far_[3]; ///< rows of bounds
        /// From where rays from one point start to these bounds.
        NarrowFloats near_plane_[3][WideNode::width / narrow_lanes], far_plane_[3][WideNode::width / narrow_lanes];
    };

private:
    const TraceQuestion &question_;
    const RayGroup &rays_;
    float dir_reach_ = 0.0f;
    alignas(64) float inverse_[3][group_size];
    alignas(64) float end_[group_size];  ///< how far a ray looks, in its unit; -1 where it is done
    alignas(64) float unit_[group_size]; ///< of distances through boxes
    alignas(64) uint32_t octant_[group_size];
    alignas(64) float ray_dir_reach_[group_size];
    float widening_[3]; ///< of boxes, where rays share an origin: what rounding may lose
    // Where they do not.
    alignas(64) float near_offset_[3][group_size]; ///< as WideSlabs has them
    alignas(64) float far_offset_[3][group_size];
    alignas(64) uint32_t most_along_[group_size]; ///< LeafRay::z
    alignas(64) float slope_x_[group_size], slope_y_[group_size];
};

} // namespace glint::HWY_NAMESPACE
