// Where a ray meets a triangle: watertight, and exact about it.
#pragma once

#include <cmath>

#include "accel/triangle_data.hpp"
#include "kernel/prepared_ray.hpp"

namespace glint {

namespace detail {

/// Corners relative to the ray's origin, sheared so that the ray runs along z from (0, 0).
template <typename T> struct ShearedTriangle {
    T ax, ay, bx, by, cx, cy;
    T az, bz, cz; ///< not scaled: divided by dir[kz] these are distances along the ray

    ShearedTriangle(const TriangleCorners &triangle, const PreparedRay &ray, T shear_x, T shear_y) {
        const int kx = ray.kx, ky = ray.ky, kz = ray.kz;
        const T ox = ray.org[kx], oy = ray.org[ky], oz = ray.org[kz];
        az = T(triangle.a[kz]) - oz;
        bz = T(triangle.b[kz]) - oz;
        cz = T(triangle.c[kz]) - oz;
        ax = (T(triangle.a[kx]) - ox) - shear_x * az;
        ay = (T(triangle.a[ky]) - oy) - shear_y * az;
        bx = (T(triangle.b[kx]) - ox) - shear_x * bz;
        by = (T(triangle.b[ky]) - oy) - shear_y * bz;
        cx = (T(triangle.c[kx]) - ox) - shear_x * cz;
        cy = (T(triangle.c[ky]) - oy) - shear_y * cz;
    }

    /// Largest distance of a corner from the ray, by coordinate.
    [[nodiscard]] T reach() const {
        const T a = max(std::abs(ax), std::abs(ay)), b = max(std::abs(bx), std::abs(by));
        return max(max(a, b), max(std::abs(cx), std::abs(cy)));
    }

    static T max(T p, T q) { return p > q ? p : q; }
};

/// Depth (on the z axis) of the point of an edge p-q that lies closest to the ray.
inline double depth_on_edge(double px, double py, double pz, double qx, double qy, double qz) {
    const double dx = qx - px, dy = qy - py;
    const double along = -(px * dx + py * dy) / (dx * dx + dy * dy);
    return pz + (qz - pz) * (along > 0.0 ? (along < 1.0 ? along : 1.0) : 0.0);
}

/// Depth at which a ray meets a triangle that it sees exactly from the side: the area is too small to weigh the corners
/// by, but any point of the sliver near the ray will do; takes it from the longest edge.
inline double edge_on_depth(const ShearedTriangle<double> &s) {
    const auto square = [](double x, double y) { return x * x + y * y; };
    const double ab = square(s.bx - s.ax, s.by - s.ay), bc = square(s.cx - s.bx, s.cy - s.by),
                 ca = square(s.ax - s.cx, s.ay - s.cy);
    if (ab >= bc && ab >= ca) return depth_on_edge(s.ax, s.ay, s.az, s.bx, s.by, s.bz);
    if (bc >= ca) return depth_on_edge(s.bx, s.by, s.bz, s.cx, s.cy, s.cz);
    return depth_on_edge(s.cx, s.cy, s.cz, s.ax, s.ay, s.az);
}

} // namespace detail

/// Distance t at which the ray meets the closed triangle, in double; NaN where it does not. t may be negative.
///
/// The test of Woop, Benthin & Wald 2013 ("Watertight Ray/Triangle Intersection", JCGT 2-1) in two steps:
///  1. in float, the three edge functions with a margin for every rounding so far: rejects nearly all misses;
///  2. in double from the original corners, the edge functions again: decides, zero counts as inside.
/// The paper decides on the signs of step 1 and goes to double only for zeros; that is watertight too, but places the
/// hit by corners rounded to float, which shows on large triangles and far from the origin, and at grazing angles its
/// distance may be that of another point of the triangle. Here a neighbour sees the same double numbers for the shared
/// edge, so no ray slips between the two; and the distance is good to 2^-24 of itself at any angle.
inline double intersect(const PreparedRay &ray, const TriangleCorners &triangle) {
    using detail::ShearedTriangle;
    {
        const ShearedTriangle<float> s(triangle, ray, ray.shear_x, ray.shear_y);
        const float u = s.cx * s.by - s.cy * s.bx;
        const float v = s.ax * s.cy - s.ay * s.cx;
        const float w = s.bx * s.ay - s.by * s.ax;
        // Each coordinate is off by at most 6 eps M, hence an edge function by (24 + 16) eps M * reach + 72 (eps M)^2;
        // slack is 16 eps M.
        const float margin = 3.0f * ray.slack * (s.reach() + ray.slack);
        if ((u < -margin || v < -margin || w < -margin) && (u > margin || v > margin || w > margin)) return NAN;
    }
    const ShearedTriangle<double> s(triangle, ray, ray.exact_shear_x, ray.exact_shear_y);
    const double u = s.cx * s.by - s.cy * s.bx;
    const double v = s.ax * s.cy - s.ay * s.cx;
    const double w = s.bx * s.ay - s.by * s.ax;
    if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return NAN;
    const double det = (u + v) + w;
    if (det == 0.0) return NAN;
    const double reach = s.reach();
    // The weights' own rounding moves the point by 2^-51 reach^3 / det across the ray: keep that far below slack.
    if (std::abs(det) < 0x1p-26 * (reach * reach)) return detail::edge_on_depth(s) / ray.dir[ray.kz];
    return ((u * s.az + v * s.bz) + w * s.cz) / (det * ray.dir[ray.kz]);
}

} // namespace glint
