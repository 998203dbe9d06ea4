// Where a ray meets a triangle: watertight, and exact about it.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "accel/triangle_data.hpp"
#include "kernel/prepared_ray.hpp"

namespace glint {

/// A triangle is seen edge on where det, the cosine between ray and normal times |n| |dir|, is below this times
/// reach^2 |dir|.
inline constexpr double least_det = 0x1p-26;

/// A ray grazes where the normal's float dot product with it loses more than four bits: where it is below this times
/// the largest that its terms can be.
inline constexpr float least_slope = 0x1p-4f;
/// How far t may be off, relative to itself: 4 eps / least_slope for the dot product, 2 eps for the rest; a little
/// more.
inline constexpr float distance_error = 0x1p-17f;

namespace detail {

/// Corners relative to the ray's origin, sheared so that the ray runs along z from (0, 0).
template <typename T> struct ShearedTriangle {
    T ax, ay, bx, by, cx, cy;
    T az, bz, cz; ///< as they are: divided by dir[kz] these are distances along the ray

    /// In float, by the ray's shear.
    ShearedTriangle(const TriangleCorners &triangle, const PreparedRay &ray)
        requires std::is_same_v<T, float>
    {
        relate(triangle, ray);
        ax -= ray.shear_x * az;
        ay -= ray.shear_y * az;
        bx -= ray.shear_x * bz;
        by -= ray.shear_y * bz;
        cx -= ray.shear_x * cz;
        cy -= ray.shear_y * cz;
    }

    /// In double, and everything dir[kz] times as large: multiplying is exact enough and cheaper than dividing.
    ShearedTriangle(const TriangleCorners &triangle, const PermutedRay &ray)
        requires std::is_same_v<T, double>
    {
        relate(triangle, ray);
        const double dx = ray.permuted_dir.x, dy = ray.permuted_dir.y, dz = ray.permuted_dir.z;
        ax = ax * dz - dx * az;
        ay = ay * dz - dy * az;
        bx = bx * dz - dx * bz;
        by = by * dz - dy * bz;
        cx = cx * dz - dx * cz;
        cy = cy * dz - dy * cz;
    }

    /// Largest distance of a corner from the ray, by coordinate.
    [[nodiscard]] T reach() const {
        const T a = std::max(std::abs(ax), std::abs(ay)), b = std::max(std::abs(bx), std::abs(by));
        return std::max(std::max(a, b), std::max(std::abs(cx), std::abs(cy)));
    }

private:
    void relate(const TriangleCorners &triangle, const PermutedRay &ray) {
        const float *a = &triangle.a.x, *b = &triangle.b.x, *c = &triangle.c.x;
        const T ox = ray.permuted_org.x, oy = ray.permuted_org.y, oz = ray.permuted_org.z;
        ax = T(a[ray.kx]) - ox;
        ay = T(a[ray.ky]) - oy;
        az = T(a[ray.kz]) - oz;
        bx = T(b[ray.kx]) - ox;
        by = T(b[ray.ky]) - oy;
        bz = T(b[ray.kz]) - oz;
        cx = T(c[ray.kx]) - ox;
        cy = T(c[ray.ky]) - oy;
        cz = T(c[ray.kz]) - oz;
    }
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

/// What a hit is, decided in double: distance t at which the ray meets the closed triangle, NaN where it does not.
/// `inside` says that it is known to be no miss.
inline float exact_distance(const PermutedRay &ray, const TriangleCorners &triangle, bool inside = false) {
    const glm::dvec3 to_a = glm::dvec3(triangle.a) - glm::dvec3(ray.org);
    const glm::dvec3 e1 = glm::dvec3(triangle.b) - glm::dvec3(triangle.a);
    const glm::dvec3 e2 = glm::dvec3(triangle.c) - glm::dvec3(triangle.a);
    const glm::dvec3 exact_n = {e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z, e1.x * e2.y - e1.y * e2.x};
    const double exact_offset = (exact_n.x * to_a.x + exact_n.y * to_a.y) + exact_n.z * to_a.z;

    const glm::vec3 n(exact_n);
    const float det = (n.x * ray.dir.x + n.y * ray.dir.y) + n.z * ray.dir.z;
    const float largest_dir = std::abs(ray.permuted_dir.z);
    const bool grazing = std::abs(det) < least_slope * ((std::abs(n.x) + std::abs(n.y)) + std::abs(n.z)) * largest_dir;
    if (inside && !grazing) return static_cast<float>(exact_offset) / det;

    const double exact_det =
        (exact_n.x * double(ray.dir.x) + exact_n.y * double(ray.dir.y)) + exact_n.z * double(ray.dir.z);
    const double reach = std::max(max_abs(e1), max_abs(e2));
    // The normal is good to 2^-52 reach^2 in each component, which moves the point by 2^-50 reach^2 M |dir| / det along
    // the ray: keep that far below slack, which is 2^-20 M.
    const bool edge_on = std::abs(exact_det) < least_det * (reach * reach) * largest_dir;
    if (!inside || edge_on) {
        const detail::ShearedTriangle<double> s(triangle, ray);
        const double u = s.cx * s.by - s.cy * s.bx;
        const double v = s.ax * s.cy - s.ay * s.cx;
        const double w = s.bx * s.ay - s.by * s.ax;
        if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return NAN;
        if (u == 0.0 && v == 0.0 && w == 0.0) return NAN;
        if (edge_on) return static_cast<float>(detail::edge_on_depth(s) / ray.permuted_dir.z);
    }
    return grazing ? static_cast<float>(exact_offset / exact_det) : static_cast<float>(exact_offset) / det;
}

/// Distance t at which the ray meets the closed triangle, NaN where it does not. t may be negative.
///
/// The test of Woop, Benthin & Wald 2013 ("Watertight Ray/Triangle Intersection", JCGT 2-1) in three steps:
///  1. in float, the three edge functions with a margin for every rounding so far: settles nearly all rays;
///  2. where they are too close to zero, the edge functions again, in double from the original corners: zero counts as
///     inside;
///  3. the distance to the triangle's plane, its normal and offset rounded to float from double; at grazing angles in
///     double throughout.
/// The paper decides on the signs of step 1 and goes to double only for zeros; that is watertight too, but places the
/// hit by corners rounded to float, which shows on large triangles and far from the origin, and at grazing angles its
/// distance may be that of another point of the triangle. Here a neighbour sees the same double numbers for the shared
/// edge, so no ray slips between the two; and the distance is good to distance_error of itself at any angle, or 2^-24
/// of the way to the farthest corner if that is more.
///
/// What counts is the outcome of steps 2 and 3, exact_distance(). Step 1 never changes it, so a packet kernel may use
/// any filter of its own in its place.
inline float intersect(const PreparedRay &ray, const TriangleCorners &triangle) {
    const detail::ShearedTriangle<float> s(triangle, ray);
    const float u = s.cx * s.by - s.cy * s.bx;
    const float v = s.ax * s.cy - s.ay * s.cx;
    const float w = s.bx * s.ay - s.by * s.ax;
    const float least = std::min(u, std::min(v, w)), most = std::max(u, std::max(v, w));
    // Each coordinate is off by at most 6 eps M, hence an edge function by (24 + 16) eps M * reach + 72 (eps M)^2;
    // slack is 16 eps M.
    const float margin = 3.0f * ray.slack * (s.reach() + ray.slack);
    if (least < -margin && most > margin) return NAN;
    return exact_distance(ray, triangle, least > margin || most < -margin);
}

} // namespace glint
