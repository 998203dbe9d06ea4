// Cutting a polygon into triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <glint/scene.hpp>

#include "mesh/corner_tree.hpp"

namespace glint {

/// Cuts planar or nearly planar polygons, convex or not, into triangles of the same winding that cover the same area.
/// Every edge of the polygon is an edge of one triangle, so that neighbouring faces stay without cracks. A polygon that
/// crosses itself gets as many triangles, over some cover of its outline.
///
/// Why not tinyobjloader's own: it cuts a quadrilateral along the shorter diagonal even where that lies outside, and
/// its ear clipping takes quadratic time, which is minutes for 10^5 corners. Here convex polygons become a fan in one
/// pass. Others are ear-clipped (Meisters, "Polygons have ears", 1975; O'Rourke, "Computational Geometry in C", 1998,
/// section 1.6: a cut changes only the two neighbours), where only the reflex corners near an ear are looked at.
///
/// Keeps its scratch memory from one polygon to the next: use one object a thread.
class PolygonCutter {
public:
    /// Writes corners.size() - 2 triangles to `out`. At least three corners; every one is an index into `positions`.
    void cut(std::span<const uint32_t> corners, const std::vector<Point> &positions, Triangle *out);

private:
    /// Cutting off the corner `tip` while a and c are its neighbours.
    struct Cut {
        double squared_length;
        uint32_t a, tip, c;
        /// Puts the shortest cut first in a heap: long slivers are slow to test and make poor triangles.
        friend bool operator<(const Cut &one, const Cut &other) {
            if (one.squared_length != other.squared_length) return one.squared_length > other.squared_length;
            return one.tip > other.tip;
        }
    };

    /// Steps of cut(), in order; the first one that fits the polygon does the work.
    void flatten(std::span<const uint32_t> corners, const std::vector<Point> &positions);
    [[nodiscard]] bool turns_left_only() const;
    void cut_quad(std::span<const uint32_t> corners, const std::vector<Point> &positions, Triangle *out) const;
    void clip_ears(std::span<const uint32_t> corners, Triangle *out);

    [[nodiscard]] bool is_reflex_or_flat(uint32_t corner) const;
    /// Of a convex tip.
    [[nodiscard]] bool is_ear(uint32_t tip) const;
    [[nodiscard]] bool blocks(uint32_t corner, uint32_t a, uint32_t b, uint32_t c) const;
    void clip(uint32_t tip);
    void consider(uint32_t tip);

    std::vector<glm::dvec2> flat_; ///< the corners in the plane, counter-clockwise

    // Ear clipping: the corners that are left form a ring.
    std::vector<uint32_t> previous_, next_;
    std::vector<uint8_t> clipped_;
    std::vector<uint8_t> reflex_; ///< or flat; only such corners can stop an ear from being cut
    CornerTree reflex_corners_;   ///< those left in the ring
    std::vector<Cut> cuts_;       ///< whose ear test is due, a heap
};

} // namespace glint
