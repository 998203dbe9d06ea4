// Large boxes are few, and rays meet them most.
#include "accel/bvh/reinsertion.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace glint {
namespace {

/// Of all nodes, this part is reinserted, so many times. Measured: see docs/performance.md.
constexpr size_t one_of = 20;
constexpr int rounds = 2;
/// Where boxes all overlap, looking for the best place would visit the whole tree. Some 50 places are usual.
constexpr int most_places = 500;

/// Only the box.
BinaryNode joined(const BinaryNode &a, const BinaryNode &b) {
    BinaryNode both{};
    for (int axis = 0; axis < 3; ++axis) {
        both.lo[axis] = std::min(a.lo[axis], b.lo[axis]);
        both.hi[axis] = std::max(a.hi[axis], b.hi[axis]);
    }
    return both;
}

class Reinsertion {
public:
    explicit Reinsertion(BinaryBvh &bvh) : nodes_(bvh.nodes), parents_(nodes_.size()), heights_(nodes_.size()) {
        visit(0);
    }

    void run() {
        for (int round = 0; round < rounds; ++round) {
            for (const uint32_t node : large_nodes()) {
                // The root's children have no place to go to: without one, the other is the whole tree.
                if (parents_[node] == 0) continue;
                const uint32_t place = best_place(node);
                if (place != 0) move(node, place);
            }
        }
    }

private:
    /// Fills in parents and heights, and remembers the node; recursion is as deep as the tree.
    void visit(uint32_t node) {
        const BinaryNode &n = nodes_[node];
        heights_[node] = 0;
        if (node != 0) movable_.push_back(node);
        if (n.is_leaf()) return;
        for (const uint32_t child : {n.first, n.first + 1}) {
            parents_[child] = node;
            visit(child);
        }
        set_height(node);
    }

    void set_height(uint32_t node) {
        const uint32_t first = nodes_[node].first;
        heights_[node] = static_cast<uint8_t>(1 + std::max(heights_[first], heights_[first + 1]));
    }

    [[nodiscard]] uint32_t sibling(uint32_t node) const {
        const uint32_t first = nodes_[parents_[node]].first;
        return node == first ? first + 1 : first;
    }

    [[nodiscard]] std::vector<uint32_t> large_nodes() const {
        struct Large {
            float area;
            uint32_t node;
        };
        std::vector<Large> all;
        all.reserve(movable_.size());
        for (const uint32_t node : movable_) all.push_back({nodes_[node].half_area(), node});
        const auto larger = [](const Large &a, const Large &b) {
            return a.area > b.area || (a.area == b.area && a.node < b.node);
        };
        const auto end = all.begin() + static_cast<std::ptrdiff_t>((all.size() + one_of - 1) / one_of);
        std::partial_sort(all.begin(), end, all.end(), larger);
        std::vector<uint32_t> nodes;
        std::transform(all.begin(), end, std::back_inserter(nodes), [](const Large &large) { return large.node; });
        return nodes;
    }

    /// Beside which node the subtree should hang so that inner nodes lose most area; 0 where nowhere is better than
    /// where it is. The search is Meister & Bittner's (2018, "Parallel reinsertion for bounding volume hierarchy
    /// optimization"): up from the node, and at each ancestor down its other side, as long as the most that may be
    /// gained there is more than what is known.
    uint32_t best_place(uint32_t node) {
        const BinaryNode &moved = nodes_[node];
        const float area = moved.half_area();
        const uint32_t parent = parents_[node], own_sibling = sibling(node);
        float best_gain = 0.0f;
        uint32_t best = 0;
        int places = 0;

        float gain = nodes_[parent].half_area(); // the parent goes, and what is above it shrinks to what remains
        BinaryNode remaining = nodes_[own_sibling];
        for (uint32_t above = parent, side = own_sibling;;) {
            open_.push_back({gain, side});
            while (!open_.empty()) {
                const Place place = open_.back();
                open_.pop_back();
                if (!(place.gain - area > best_gain) || ++places > most_places) continue;
                const BinaryNode &there = nodes_[place.node];
                const float gain_there = place.gain - joined(there, moved).half_area();
                if (gain_there > best_gain && place.node != own_sibling && fits(node, place.node)) {
                    best_gain = gain_there;
                    best = place.node;
                }
                if (there.is_leaf()) continue;
                const float gain_below = gain_there + there.half_area();
                open_.push_back({gain_below, there.first});
                open_.push_back({gain_below, there.first + 1});
            }
            if (above == 0) return best;
            if (above != parent) {
                remaining = joined(remaining, nodes_[side]);
                gain += nodes_[above].half_area() - remaining.half_area();
            }
            side = sibling(above);
            above = parents_[above];
        }
    }

    /// Whether the tree stays flat enough where a subtree gets a place beside a node.
    [[nodiscard]] bool fits(uint32_t node, uint32_t beside) const {
        uint32_t depth = 1;
        for (uint32_t n = beside; n != 0; n = parents_[n]) ++depth;
        return depth + std::max(heights_[node], heights_[beside]) <= max_binary_depth;
    }

    /// The sibling takes the parent's place in the array; the pair of places that the two had is for the subtree and
    /// what it is put beside.
    void move(uint32_t node, uint32_t beside) {
        const uint32_t parent = parents_[node], free = sibling(node);
        copy(free, parent);
        copy(beside, free);
        nodes_[beside].first = std::min(node, free);
        nodes_[beside].count = 0;
        parents_[node] = parents_[free] = beside;
        fit_from(beside);
        fit_from(parent);
    }

    void copy(uint32_t from, uint32_t to) {
        const BinaryNode &node = nodes_[to] = nodes_[from];
        heights_[to] = heights_[from];
        if (!node.is_leaf()) parents_[node.first] = parents_[node.first + 1] = to;
    }

    /// Boxes and heights from a node up to the root.
    void fit_from(uint32_t node) {
        for (;; node = parents_[node]) {
            BinaryNode &n = nodes_[node];
            if (!n.is_leaf()) {
                const BinaryNode both = joined(nodes_[n.first], nodes_[n.first + 1]);
                std::copy(both.lo, both.lo + 3, n.lo);
                std::copy(both.hi, both.hi + 3, n.hi);
                set_height(node);
            }
            if (node == 0) return;
        }
    }

    /// A node to look at, and the area that is gained by hanging the subtree beside it or below, but for what the new
    /// parent has.
    struct Place {
        float gain;
        uint32_t node;
    };

    UninitializedVector<BinaryNode> &nodes_;
    UninitializedVector<uint32_t> parents_;
    UninitializedVector<uint8_t> heights_;
    std::vector<uint32_t> movable_; ///< all but the root
    std::vector<Place> open_;
};

} // namespace

void reinsert_large_nodes(BinaryBvh &bvh) {
    Reinsertion(bvh).run();
}

} // namespace glint
