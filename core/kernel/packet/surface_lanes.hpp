// What shading needs to know of the triangles and surfaces that a vector of rays has hit.
#pragma once

#include "kernel/kernel.hpp"
#include "kernel/packet/lanes.hpp"

namespace glint::HWY_NAMESPACE {

/// Numbers of things, one a lane, as a list of the different ones: neighbouring rays mostly hit the same triangle, or
/// at least the same surface, and one look-up then does for all.
class DistinctLanes {
public:
    /// number[0 .. lane_count) where lane_bits (not 0) says; other lanes count as the first of those.
    HWY_INLINE DistinctLanes(const uint32_t *number, uint32_t lane_bits) {
        const Uints all = hn::Load(uints, number);
        uint32_t rest = lane_bits;
        do {
            const uint32_t next = number[lowest_bit(rest)];
            const FloatMask same = hn::RebindMask(floats, hn::Eq(all, hn::Set(uints, next)));
            append(next, same);
            rest &= ~bits_of(same);
        } while (rest != 0);
    }

    /// What numbers stand for has numbers itself.
    template <typename Other> HWY_INLINE DistinctLanes(const DistinctLanes &from, Other &&other) {
        append(other(from.number_[0]), from.lanes_[0]);
        for (uint32_t i = 1; i < from.count_; ++i) {
            const uint32_t number = other(from.number_[i]);
            uint32_t j = 0;
            while (j < count_ && number_[j] != number) ++j;
            if (j == count_) {
                append(number, from.lanes_[i]);
            } else {
                lanes_[j] = hn::Or(lanes_[j], from.lanes_[i]);
            }
        }
    }

    /// value(number) in every lane.
    template <typename Value> HWY_INLINE Floats floats_of(Value &&value) const {
        Floats result = splat(value(number_[0]));
        for (uint32_t i = 1; i < count_; ++i) result = hn::IfThenElse(lanes_[i], splat(value(number_[i])), result);
        return result;
    }
    /// Calls visit(number, lanes) for each different number.
    template <typename Visit> HWY_INLINE void for_each(Visit &&visit) const {
        for (uint32_t i = 0; i < count_; ++i) visit(number_[i], lanes_[i]);
    }
    [[nodiscard]] HWY_INLINE Uints numbers() const {
        return hn::BitCast(uints, floats_of([](uint32_t number) { return __builtin_bit_cast(float, number); }));
    }
    /// The lanes, as bits, for whose number the predicate holds.
    template <typename Predicate> HWY_INLINE uint32_t lanes_where(Predicate &&predicate) const {
        if (count_ == 1) return predicate(number_[0]) ? all_lanes : 0;
        uint32_t bits = 0;
        for (uint32_t i = 0; i < count_; ++i) bits |= predicate(number_[i]) ? bits_of(lanes_[i]) : 0;
        return bits;
    }

private:
    HWY_INLINE void append(uint32_t number, FloatMask lanes) {
        number_[count_] = number;
        lanes_[count_++] = lanes;
    }

    uint32_t count_ = 0;
    uint32_t number_[lane_count];
    FloatMask lanes_[lane_count];
};

/// The triangles' normals.
HWY_INLINE Points normals_of(const KernelScene &scene, const DistinctLanes &triangles) {
    const TriangleSurface *all = scene.geometry.surfaces;
    return {triangles.floats_of([=](uint32_t id) { return all[id].normal.x; }),
            triangles.floats_of([=](uint32_t id) { return all[id].normal.y; }),
            triangles.floats_of([=](uint32_t id) { return all[id].normal.z; })};
}

/// Surfaces as shading needs them.
class SurfaceLanes {
public:
    HWY_INLINE SurfaceLanes(const KernelScene &scene, const DistinctLanes &numbers)
        : all_(scene.surfaces), numbers_(numbers) {}

    HWY_INLINE Floats number(float SurfaceShading::*member) const {
        return numbers_.floats_of([=, this](uint32_t i) { return all_[i].*member; });
    }
    HWY_INLINE Points color(Color SurfaceShading::*member) const {
        return {numbers_.floats_of([=, this](uint32_t i) { return (all_[i].*member).x; }),
                numbers_.floats_of([=, this](uint32_t i) { return (all_[i].*member).y; }),
                numbers_.floats_of([=, this](uint32_t i) { return (all_[i].*member).z; })};
    }
    [[nodiscard]] HWY_INLINE uint32_t lights() const {
        return numbers_.lanes_where([this](uint32_t i) { return all_[i].is_light; });
    }

private:
    const SurfaceShading *all_;
    const DistinctLanes &numbers_;
};

} // namespace glint::HWY_NAMESPACE
