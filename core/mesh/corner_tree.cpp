// Finding the polygon corners near a triangle, in the plane.
#include "mesh/corner_tree.hpp"

#include <algorithm>

namespace glint {

void CornerTree::build(const std::vector<glm::dvec2> &places, const std::vector<uint8_t> &wanted) {
    corners_.clear();
    for (uint32_t i = 0; i < places.size(); ++i) {
        if (wanted[i]) corners_.push_back(i);
    }
    nodes_.clear();
    leaf_of_.resize(places.size());
    if (!corners_.empty()) build_node(places, 0, 0, static_cast<uint32_t>(corners_.size()));
}

void CornerTree::build_node(const std::vector<glm::dvec2> &places, size_t i, uint32_t begin, uint32_t end) {
    if (nodes_.size() <= i) nodes_.resize(i + 1);
    Node node;
    node.begin = begin;
    node.end = end;
    node.alive = end - begin;
    node.is_leaf = end - begin <= leaf_corners;
    node.low = node.high = places[corners_[begin]];
    for (uint32_t k = begin; k < end; ++k) {
        const glm::dvec2 &p = places[corners_[k]];
        node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
        node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
        if (node.is_leaf) leaf_of_[corners_[k]] = i;
    }
    nodes_[i] = node;
    if (node.is_leaf) return;

    const int axis = node.high.x - node.low.x > node.high.y - node.low.y ? 0 : 1;
    const uint32_t middle = begin + (end - begin) / 2;
    const auto at = [&](uint32_t k) { return corners_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end), [&](uint32_t p, uint32_t q) {
        // Equal coordinates are told apart by number, so that the tree is the same with every standard library.
        const double x = places[p][axis], y = places[q][axis];
        return x != y ? x < y : p < q;
    });
    build_node(places, 2 * i + 1, begin, middle);
    build_node(places, 2 * i + 2, middle, end);
}

void CornerTree::remove(uint32_t corner) {
    for (size_t i = leaf_of_[corner];; i = (i - 1) / 2) {
        --nodes_[i].alive;
        if (i == 0) return;
    }
}

} // namespace glint
