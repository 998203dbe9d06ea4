// From the leaves up: what each subtree costs as one, two or more children. Then from the root down: what is cheapest.
#include "accel/bvh/collapse.hpp"

#include <limits>

namespace glint {

Collapse::Collapse(const BinaryBvh &binary) : binary_(binary), areas_(binary.nodes.size()) {
    measure(0);
}

void Collapse::measure(uint32_t node) {
    const BinaryNode &n = binary_.nodes[node];
    Areas &areas = areas_[node];
    if (n.is_leaf()) {
        areas.fill(0.0f);
        return;
    }
    measure(n.first);
    measure(n.first + 1);
    areas[0] = n.half_area() + share(node, WideNode::width).area;
    for (uint32_t i = 1; i < areas.size(); ++i) {
        const float apart = share(node, i + 1).area;
        areas[i] = apart < areas[i - 1] ? apart : areas[i - 1];
    }
}

Collapse::Shares Collapse::share(uint32_t node, uint32_t count) const {
    const uint32_t first = binary_.nodes[node].first;
    const Areas &left = areas_[first], &right = areas_[first + 1];
    Shares best{std::numeric_limits<float>::infinity(), 1};
    for (uint32_t l = 1; l < count; ++l) {
        const float area = left[l - 1] + right[count - l - 1];
        if (area < best.area) best = {area, l};
    }
    return best;
}

uint32_t Collapse::children_of(uint32_t node, std::array<uint32_t, WideNode::width> &children) const {
    const BinaryNode &n = binary_.nodes[node];
    uint32_t count = 0;
    if (n.is_leaf()) {
        children[count++] = node;
        return count;
    }
    const uint32_t left = share(node, WideNode::width).left;
    choose(n.first, left, children, count);
    choose(n.first + 1, WideNode::width - left, children, count);
    return count;
}

/// Appends a subtree as up to `most` children.
void Collapse::choose(uint32_t node, uint32_t most, std::array<uint32_t, WideNode::width> &children,
                      uint32_t &count) const {
    const BinaryNode &n = binary_.nodes[node];
    const Areas &areas = areas_[node];
    while (most > 1 && !(areas[most - 1] < areas[most - 2])) --most;
    if (n.is_leaf() || most == 1) {
        children[count++] = node;
        return;
    }
    const uint32_t left = share(node, most).left;
    choose(n.first, left, children, count);
    choose(n.first + 1, most - left, children, count);
}

} // namespace glint
