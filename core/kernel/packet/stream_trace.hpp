// Rays that go different ways through the wide hierarchy, but in the same octant of directions: a node is fetched once
// for all rays that enter it, and each child gets the list of the rays that enter that child (Barringer &
// Akenine-Moller 2014, "Dynamic ray stream traversal"). Lists that got short are finished ray by ray.
#pragma once

#include "kernel/packet/leaf_lists.hpp"
#include "kernel/packet/wide_single.hpp"

namespace glint::HWY_NAMESPACE {

/// Fewer rays than this are not worth a list. Measured: see docs/performance.md.
inline constexpr uint32_t fewest_in_stream = 5;
/// Fewer rays than this ask a node's children at once, not the beam around all rays first.
inline constexpr uint32_t fewest_to_ask_beam = 16;
/// Fewer rays than this are not worth working out what a leaf's triangles have for all rays.
inline constexpr uint32_t fewest_to_prepare_leaf = 2;
/// Lists that wait: those of a node's children at every level.
inline constexpr uint32_t most_lists = (WideNode::width - 1) * max_bvh_depth + WideNode::width;

template <bool shares_origin, bool any_hit> class StreamTrace {
public:
    /// `beam` is around all selected rays, or nullptr.
    HWY_INLINE StreamTrace(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, const Beam *beam)
        : question_(question), rays_(rays), selection_(selection), beam_(beam) {}

    /// Traces the selected rays. Those that are hit are deselected where any hit will do.
    HWY_NOINLINE void run() {
        const bool one_octant = prepare() == 0;
        uint32_t sorted[group_size];
        uint32_t starts[9] = {};
        if (one_octant) {
            for_each_ray(selection_, [&](uint32_t ray) { sorted[starts[0]++] = ray; });
        } else {
            for_each_ray(selection_, [&](uint32_t ray) { ++starts[octant_[ray] + 1]; });
            for (uint32_t octant = 0; octant < 8; ++octant) starts[octant + 1] += starts[octant];
            for_each_ray(selection_, [&](uint32_t ray) { sorted[starts[octant_[ray]]++] = ray; });
        }
        for (uint32_t i = 0, begin = 0; i < 8; begin = starts[i++]) {
            if (starts[i] > begin) walk(ChildLink::node(0), sorted + begin, starts[i] - begin);
            if (one_octant) break;
        }
    }

    /// For rays of one octant that are picked elsewhere: prepare(), then for parts of the tree enter() and walk().
    /// What SingleRay and WideSlabs have, for all rays. Returns in which axes' signs they differ.
    HWY_NOINLINE uint32_t prepare() {
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
        for_each_vector(selection_, [&](uint32_t ray, uint32_t lane_bits) {
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
    HWY_INLINE uint32_t enter(uint32_t block, const WideNode &node, uint32_t child, uint32_t *to) {
        const uint32_t first_ray = block * block_size,
                       octant = octant_[first_ray + lowest_bit(selection_.blocks[block])];
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
            const uint32_t lanes = bits_of(hn::Le(begin, stop)) & selection_.lanes(ray);
            count += put_chosen(hn::Iota(uints, ray), lanes, to + count);
        }
        return count;
    }
    /// Rays of one octant through all that a link leads to.
    HWY_NOINLINE void walk(ChildLink root, const uint32_t *sorted, uint32_t count) {
        const WideRows rows(octant_[sorted[0]]);
        Pending stack[most_lists];
        uint32_t pending = 0;
        for (uint32_t i = 0; i < count; ++i) ids_[i] = sorted[i];
        stack[pending++] = {root.word(), 0, static_cast<uint16_t>(count), 0.0f, hits_};
        while (pending > 0) {
            Pending now = stack[--pending];
            if (pending > 0) prefetch(question_.geometry, ChildLink(stack[pending - 1].link));
            if (now.hits != hits_) now.count = static_cast<uint16_t>(still_looking(now));
            if (now.count == 0) continue;
            const ChildLink link(now.link);
            uint32_t *const ids = ids_ + now.first;
            if (link.is_leaf()) {
                visit_leaf(link, ids, now.count);
            } else if (now.count < fewest_in_stream || now.first + (1 + WideNode::width) * now.count > arena_size) {
                for (uint32_t i = 0; i < now.count; ++i) finish(rows, ids[i], link);
            } else {
                pending = visit_node(rows, link, now, stack, pending);
            }
        }
    }

    /// That have been found.
    [[nodiscard]] HWY_INLINE uint32_t hits() const { return hits_; }

private:
    /// The shared origin moved by what is lost in rounding, so that rays of an octant meet planes in time: before what
    /// is near, behind what is far.
    struct OctantOrigin {
        float near[3], far[3];

        HWY_INLINE OctantOrigin(const StreamTrace &trace, uint32_t octant) {
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const float at = coordinate(trace.rays_.shared_origin, static_cast<int>(axis));
                const float by = (octant >> axis & 1) != 0 ? -trace.widening_[axis] : trace.widening_[axis];
                near[axis] = at + by;
                far[axis] = at - by;
            }
        }
    };

    struct Pending {
        uint32_t link;
        uint16_t first, count; ///< its rays in ids_
        float begin;           ///< none of them enters before
        uint32_t hits;         ///< that had been found by then
    };
    static constexpr uint32_t arena_size = 8192; ///< links that do not fit are followed ray by ray

    /// Drops the rays that have found something nearer by now; returns how many are left.
    HWY_INLINE uint32_t still_looking(const Pending &now) {
        uint32_t *const ids = ids_ + now.first;
        uint32_t count = 0;
        for (uint32_t i = 0; i < now.count; ++i) {
            const uint32_t ray = ids[i];
            ids[count] = ray;
            count += end_[ray] >= now.begin ? 1u : 0u;
        }
        return count;
    }

    /// Copies those rays whose flags have the bit; returns how many. Up to a vector behind them is written.
    static HWY_INLINE uint32_t pick(const uint32_t *flags, uint32_t bit, const uint32_t *rays, uint32_t count,
                                    uint32_t *to) {
        uint32_t picked = 0;
        for (uint32_t i = 0; i < count; i += lane_count) {
            const uint32_t valid = count - i >= lane_count ? all_lanes : ~(~0u << (count - i));
            const uint32_t chosen =
                bits_of(uints, hn::TestBit(hn::Load(uints, flags + i), hn::Set(uints, bit))) & valid;
            picked += put_chosen(hn::LoadU(uints, rays + i), chosen, to + picked);
        }
        return picked;
    }

    HWY_INLINE uint32_t visit_node(const WideRows &rows, ChildLink link, const Pending &now, Pending *stack,
                                   uint32_t pending) {
        const WideNode &node = question_.geometry.wide_nodes[link.number()];
        if (beam_ && now.count >= fewest_to_ask_beam) {
            alignas(32) float begins[WideNode::width];
            const uint32_t reached = children_in_beam(*beam_, node, begins);
            if (reached == 0) return pending;
            if ((reached & (reached - 1)) == 0) {
                stack[pending] = now;
                stack[pending].link = node.child[lowest_bit(reached)];
                return pending + 1;
            }
        }
        const float *const bounds = node.bounds[0];
        const float *const near_bound[3] = {bounds + rows.near_x, bounds + rows.near_y, bounds + rows.near_z};
        const float *const far_bound[3] = {bounds + rows.far_x(), bounds + rows.far_y(), bounds + rows.far_z()};
        uint32_t *const ids = ids_ + now.first;
        // Of rays from one point: from where they start to the planes.
        NarrowFloats near_plane[3][WideNode::width / narrow_lanes], far_plane[3][WideNode::width / narrow_lanes];
        if constexpr (shares_origin) {
            const OctantOrigin origin(*this, octant_[ids[0]]);
            for (uint32_t axis = 0; axis < 3; ++axis) {
                for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
                    near_plane[axis][c / narrow_lanes] =
                        hn::Load(narrow_floats, near_bound[axis] + c) - narrow_splat(origin.near[axis]);
                    far_plane[axis][c / narrow_lanes] =
                        hn::Load(narrow_floats, far_bound[axis] + c) - narrow_splat(origin.far[axis]);
                }
            }
        }
        alignas(64) uint32_t entered[group_size + lane_count];
        uint32_t any = 0, all = ~0u;
        alignas(32) float begins[WideNode::width]; // the least of all rays
        NarrowFloats first_begin[WideNode::width / narrow_lanes];
        for (NarrowFloats &b : first_begin) b = narrow_splat(any_hit ? 0.0f : __builtin_inff());
        for (uint32_t i = 0; i < now.count; ++i) {
            const uint32_t ray = ids[i];
            uint32_t bits = 0;
            for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
                NarrowFloats near[3], far[3];
                for (uint32_t axis = 0; axis < 3; ++axis) {
                    const auto inverse = narrow_splat(inverse_[axis][ray]);
                    if constexpr (shares_origin) {
                        near[axis] = near_plane[axis][c / narrow_lanes] * inverse;
                        far[axis] = far_plane[axis][c / narrow_lanes] * inverse;
                    } else {
                        near[axis] = hn::MulSub(hn::Load(narrow_floats, near_bound[axis] + c), inverse,
                                                narrow_splat(near_offset_[axis][ray]));
                        far[axis] = hn::MulSub(hn::Load(narrow_floats, far_bound[axis] + c), inverse,
                                               narrow_splat(far_offset_[axis][ray]));
                    }
                }
                const auto begin = hn::Max(hn::Max(near[0], near[1]), hn::Max(near[2], hn::Zero(narrow_floats)));
                const auto stop = hn::Min(hn::Min(far[0], far[1]), hn::Min(far[2], narrow_splat(end_[ray])));
                const auto enters = hn::Le(begin, stop);
                if constexpr (!any_hit) { // which else are as good in any order
                    NarrowFloats &least = first_begin[c / narrow_lanes];
                    least = hn::Min(least, hn::IfThenElse(enters, begin, least));
                }
                bits |= bits_of(narrow_floats, enters) << c;
            }
            entered[i] = bits;
            any |= bits;
            all &= bits;
        }
        if (any == 0) return pending;
        for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
            hn::Store(first_begin[c / narrow_lanes], narrow_floats, begins + c);
        }

        // Far children first, so that near ones are on top of the stack.
        uint32_t order[WideNode::width], used = 0;
        for (; any != 0; any &= any - 1) {
            const uint32_t c = lowest_bit(any);
            uint32_t place = used++;
            for (; place > 0 && begins[order[place - 1]] < begins[c]; --place) order[place] = order[place - 1];
            order[place] = c;
        }
        prefetch(question_.geometry, ChildLink(node.child[order[used - 1]])); // is next
        // The last list takes the place of the one that was read.
        uint32_t first = now.first + uint32_t{now.count};
        for (uint32_t u = 0; u < used; ++u) {
            const uint32_t c = order[u];
            uint32_t count = now.count;
            if ((all >> c & 1) != 0) {
                for (uint32_t i = 0; i < count; i += lane_count) {
                    hn::StoreU(hn::LoadU(uints, ids + i), uints, ids_ + first + i);
                }
            } else {
                count = pick(entered, 1u << c, ids, now.count, ids_ + first);
            }
            stack[pending++] = {node.child[c], static_cast<uint16_t>(first), static_cast<uint16_t>(count), begins[c],
                                hits_};
            first += count;
        }
        return pending;
    }

    HWY_NOINLINE void visit_leaf(ChildLink link, const uint32_t *ids, uint32_t count) {
        if (count < fewest_to_prepare_leaf) {
            for (uint32_t i = 0; i < count; ++i) {
                const uint32_t ray = ids[i];
                if (any_hit && end_[ray] < 0.0f) continue;
                float t = rays_.t[ray];
                uint32_t id = rays_.triangle_id[ray];
                if (hit_leaf<any_hit>(question_, link.number(), link.reference_count(), leaf_ray(ray), t, id)) {
                    take(ray, t, id);
                }
            }
            return;
        }
        const uint32_t references = link.reference_count();
        const uint32_t *words = question_.geometry.leaf_words + words_per_reference * size_t{link.number()};
        for (uint32_t first = 0; first < references; first += narrow_lanes) {
            if constexpr (shares_origin && any_hit) {
                const LeafOccluders leaf(question_, words, references, first, rays_.shared_origin, dir_reach_);
                for_each_looking(ids, count, [&](uint32_t ray, const Point3 &dir, float &t, uint32_t &) {
                    return leaf.block(dir, rays_.left[ray], t);
                });
            } else if constexpr (shares_origin) {
                const LeafFromPoint leaf(words, references, first, rays_.shared_origin, dir_reach_);
                for_each_looking(ids, count, [&](uint32_t ray, const Point3 &dir, float &t, uint32_t &id) {
                    return leaf.hit(dir, ray_dir_reach_[ray], rays_.left[ray], t, id);
                });
            } else {
                LeafFromAnywhere leaf(words, references, first, dir_reach_);
                if constexpr (any_hit) leaf.passes = leaf.passed_by(question_);
                for_each_looking(ids, count, [&](uint32_t ray, const Point3 &dir, float &t, uint32_t &id) {
                    const Point3 org = {rays_.org_x[ray], rays_.org_y[ray], rays_.org_z[ray]};
                    return leaf.template hit<any_hit>(org, dir, ray_dir_reach_[ray], rays_.left[ray], t, id);
                });
            }
        }
    }

    /// Takes what hit(ray, dir, t, id) finds, which says whether it did and lowers t.
    template <typename Hit> HWY_INLINE void for_each_looking(const uint32_t *ids, uint32_t count, Hit &&hit) {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t ray = ids[i];
            if (any_hit && end_[ray] < 0.0f) continue;
            float t = rays_.t[ray];
            uint32_t id = rays_.triangle_id[ray];
            if (hit(ray, Point3{rays_.dir_x[ray], rays_.dir_y[ray], rays_.dir_z[ray]}, t, id)) take(ray, t, id);
        }
    }

    HWY_INLINE LeafRay leaf_ray(uint32_t ray) const {
        const Point3 dir = {rays_.dir_x[ray], rays_.dir_y[ray], rays_.dir_z[ray]};
        // Few rays from one point come so far alone.
        if constexpr (shares_origin) return HWY_NAMESPACE::leaf_ray(rays_.shared_origin, dir, rays_.left[ray]);
        return {{rays_.org_x[ray], rays_.org_y[ray], rays_.org_z[ray]},
                dir,
                rays_.left[ray],
                most_along_[ray],
                slope_x_[ray],
                slope_y_[ray]};
    }

    HWY_INLINE void take(uint32_t ray, float t, uint32_t id) {
        ++hits_;
        if constexpr (any_hit) {
            selection_.remove(ray / block_size * block_size, 1u << (ray % block_size));
            end_[ray] = -1.0f;
        } else {
            rays_.t[ray] = t;
            rays_.triangle_id[ray] = id;
            end_[ray] = (t + distance_error * t) * unit_[ray];
        }
    }

    HWY_INLINE WideSlabs slabs_of(uint32_t ray) const {
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

    /// One ray through all that a link leads to.
    HWY_NOINLINE void finish(const WideRows &rows, uint32_t ray, ChildLink link) {
        if (any_hit && end_[ray] < 0.0f) return;
        const WideSlabs slabs = slabs_of(ray);
        float t = rays_.t[ray];
        uint32_t id = rays_.triangle_id[ray];
        if (walk_wide<any_hit>(question_, slabs, rows, link, unit_[ray], leaf_ray(ray), t, id)) take(ray, t, id);
    }

    const TraceQuestion &question_;
    RayGroup &rays_;
    RaySelection &selection_;
    const Beam *beam_;
    float dir_reach_ = 0.0f;
    uint32_t hits_ = 0;
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
    alignas(64) uint32_t ids_[arena_size + 32];
};

} // namespace glint::HWY_NAMESPACE
