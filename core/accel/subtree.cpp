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
    grow(subtree, cell, 0, references.size(), references.size());
    return subtree;
}

/// The cell's references are stack_[first, first + count); from `top` on the stack is free. The lower cell's references
/// take the place of the cell's own, the upper cell's wait on top of the stack.
void SubtreeBuilder::grow(Subtree &subtree, const Cell &cell, size_t first, size_t count, size_t top) {
    const Split split = choose_split({stack_.data() + first, count}, cell, cost_);
    if (!split.exists()) {
        subtree.nodes.push_back(
            KdNode::leaf(static_cast<uint32_t>(subtree.triangle_ids.size()), static_cast<uint32_t>(count)));
        for (size_t i = first; i < first + count; ++i) subtree.triangle_ids.push_back(stack_[i].triangle_id);
        return;
    }
    if (stack_.size() < top + count) stack_.resize(2 * (top + count));
    Reference *const references = stack_.data() + first;
    const auto [lower_count, upper_count] =
        partition_.divide({references, count}, split, references, stack_.data() + top);
    const auto [lower, upper] = split.cells(cell, lower_count, upper_count);
    const size_t node = subtree.nodes.size();
    subtree.nodes.push_back(KdNode::leaf(0, 0)); // holds the place until the upper child's index is known
    grow(subtree, lower, first, lower_count, top + upper_count);
    const auto upper_child = static_cast<uint32_t>(subtree.nodes.size());
    grow(subtree, upper, top, upper_count, top + upper_count);
    subtree.nodes[node] = KdNode::inner(static_cast<uint32_t>(split.axis), split.position, upper_child);
}

} // namespace glint
