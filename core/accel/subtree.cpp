// Builds the part of the tree below one cell, on one thread.
#include "accel/subtree.hpp"

#include <algorithm>

namespace glint {

Subtree SubtreeBuilder::build(const Cell &cell, std::span<const Reference> references) {
    if (stack_.size() < references.size()) stack_.resize(3 * references.size());
    std::copy(references.begin(), references.end(), stack_.begin());
    Subtree subtree;
    subtree.triangle_ids.reserve(references.size() * 3 / 2);
    subtree.nodes.reserve(references.size() / 2 + 1);
    grow(subtree, cell, {0, references.size(), references.size()});
    return subtree;
}

void SubtreeBuilder::grow(Subtree &subtree, const Cell &cell, Range range) {
    const std::span<const Reference> references(stack_.data() + range.first, range.count);
    search_.begin(hull(references), range.count);
    search_.add(references);
    grow_counted(subtree, cell, range);
}

/// The search has counted the references already.
void SubtreeBuilder::grow_counted(Subtree &subtree, const Cell &cell, Range range) {
    const Split split = search_.best(cell);
    if (!split.exists()) return add_leaf(subtree, range);
    const size_t node = subtree.nodes.size();
    subtree.nodes.emplace_back(); // holds the place until the upper child's index is known
    uint32_t upper_child;
    if (split.cuts_off_empty_space()) {
        // No reference moves, and what was counted still holds.
        const auto [lower, upper] = split.cells(cell, split.lower, split.upper);
        constexpr Range nothing{};
        split.lower == 0 ? add_leaf(subtree, nothing) : grow_counted(subtree, lower, range);
        upper_child = static_cast<uint32_t>(subtree.nodes.size());
        split.lower == 0 ? grow_counted(subtree, upper, range) : add_leaf(subtree, nothing);
    } else {
        const auto [lower_range, upper_range] = divide(range, split);
        const auto [lower, upper] = split.cells(cell, lower_range.count, upper_range.count);
        grow(subtree, lower, lower_range);
        upper_child = static_cast<uint32_t>(subtree.nodes.size());
        grow(subtree, upper, upper_range);
    }
    subtree.nodes[node] = KdNode::inner(static_cast<uint32_t>(split.axis), split.position, upper_child);
}

/// The lower cell's references take the place of the cell's own, the upper cell's are put on top of the stack.
std::pair<SubtreeBuilder::Range, SubtreeBuilder::Range> SubtreeBuilder::divide(Range range, const Split &split) {
    if (stack_.size() < range.top + range.count) stack_.resize(2 * (range.top + range.count));
    Reference *const references = stack_.data() + range.first;
    const auto [lower_count, upper_count] =
        partition_.divide({references, range.count}, split, references, stack_.data() + range.top);
    const size_t top = range.top + upper_count;
    return {{range.first, lower_count, top}, {range.top, upper_count, top}};
}

void SubtreeBuilder::add_leaf(Subtree &subtree, Range range) const {
    subtree.nodes.push_back(
        KdNode::leaf(static_cast<uint32_t>(subtree.triangle_ids.size()), static_cast<uint32_t>(range.count)));
    for (size_t i = range.first; i < range.first + range.count; ++i) {
        subtree.triangle_ids.push_back(stack_[i].triangle_id);
    }
}

} // namespace glint
