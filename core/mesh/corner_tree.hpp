// Finding the polygon corners near a triangle, in the plane.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace glint {

/// Twice the signed area of a triangle: positive when a, b, c turn left. Monotone in every coordinate of c even with
/// rounding, because each of its operations is.
[[nodiscard]] inline double turn(const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A balanced tree of bounding boxes over some of a polygon's corners, from which corners can be taken out.
///
/// Why not a grid: corners crowd. The teeth of a comb leave tens of thousands of them on one line, all in a grid's one
/// row, and every long triangle beside that line meets them all; here their box is the line itself.
class CornerTree {
public:
    /// Over the corners that `wanted` marks.
    void build(const std::vector<glm::dvec2> &places, const std::vector<uint8_t> &wanted);

    /// Takes out a corner that is in the tree.
    void remove(uint32_t corner);

    /// Whether `blocks(corner)` holds for any corner in the tree that may lie in the left-turning triangle a, b, c, its
    /// outline included. Others are asked about too, but few.
    template <typename Blocks>
    [[nodiscard]] bool any_near(const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c, Blocks &&blocks) const {
        return !nodes_.empty() && any_below(0, a, b, c, blocks);
    }

private:
    static constexpr uint32_t leaf_corners = 8;

    /// Node i's children are 2 i + 1 and 2 i + 2.
    struct Node {
        glm::dvec2 low, high;
        uint32_t begin = 0, end = 0; ///< its part of corners_
        uint32_t alive = 0;          ///< corners of that part that were not taken out
        bool is_leaf = true;
    };

    void build_node(const std::vector<glm::dvec2> &places, size_t node, uint32_t begin, uint32_t end);

    /// Whether the whole box lies to the right of the line from a to b.
    [[nodiscard]] static bool is_right_of(const Node &box, const glm::dvec2 &a, const glm::dvec2 &b) {
        // The corner of the box that is furthest to the left of the line.
        const glm::dvec2 furthest(b.y > a.y ? box.low.x : box.high.x, b.x > a.x ? box.high.y : box.low.y);
        return turn(a, b, furthest) < 0.0;
    }

    template <typename Blocks>
    bool any_below(size_t i, const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c, Blocks &blocks) const {
        const Node &node = nodes_[i];
        if (node.alive == 0 || is_right_of(node, a, b) || is_right_of(node, b, c) || is_right_of(node, c, a)) {
            return false;
        }
        if (!node.is_leaf) return any_below(2 * i + 1, a, b, c, blocks) || any_below(2 * i + 2, a, b, c, blocks);
        for (uint32_t k = node.begin; k < node.end; ++k) {
            if (blocks(corners_[k])) return true;
        }
        return false;
    }

    std::vector<Node> nodes_;
    std::vector<uint32_t> corners_; ///< sorted into the nodes' parts
    std::vector<size_t> leaf_of_;   ///< by corner
};

} // namespace glint
