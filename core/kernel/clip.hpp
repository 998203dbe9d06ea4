// The part of a ray that lies in a box.
#pragma once

#include "kernel/intersect.hpp"

namespace glint {

/// The part of a ray, as [t_near, t_far], that lies in a box or within the ray's slack of it; empty where t_near >
/// t_far.
struct Interval {
    float t_near, t_far;
};

/// Where a hit at t counts, the search goes as far as this: the hit's own place may be a little farther.
inline float search_end(float t) {
    return t + distance_error * t;
}

inline Interval clip_to_box(const PreparedRay &ray, const Box &box, float t_max) {
    Interval part{0.0f, search_end(t_max)};
    for (int axis = 0; axis < 3; ++axis) {
        const float t_lo = (box.lo[axis] - ray.org[axis]) * ray.inverse_dir[axis];
        const float t_hi = (box.hi[axis] - ray.org[axis]) * ray.inverse_dir[axis];
        const float enter = (t_lo < t_hi ? t_lo : t_hi) - ray.parameter_slack[axis];
        const float leave = (t_lo < t_hi ? t_hi : t_lo) + ray.parameter_slack[axis];
        if (enter > part.t_near) part.t_near = enter;
        if (leave < part.t_far) part.t_far = leave;
    }
    return part;
}

} // namespace glint
