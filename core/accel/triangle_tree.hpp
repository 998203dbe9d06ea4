// What rays find triangles by, of either kind: over all that stand still, or over one mesh that moves.
#pragma once

#include <cstdint>
#include <span>

#include <glint/accel.hpp>

#include "accel/bvh/wide_bvh.hpp"
#include "accel/kd_tree.hpp"
#include "threads/crew.hpp"

namespace glint {

struct TriangleTree {
    AccelKind kind = AccelKind::kdtree; ///< not automatic
    uint32_t triangle_count = 0;
    KdTree kd;   ///< a single leaf for AccelKind::brute; empty for AccelKind::bvh
    WideBvh bvh; ///< empty for the other kinds

    [[nodiscard]] bool is_bvh() const { return kind == AccelKind::bvh; }
    [[nodiscard]] const Box &bounds() const { return is_bvh() ? bvh.bounds : kd.bounds; }
    [[nodiscard]] const KdNode *nodes() const { return is_bvh() || triangle_count == 0 ? nullptr : kd.nodes.data(); }
    [[nodiscard]] const WideNode *wide_nodes() const { return is_bvh() ? bvh.nodes.data() : nullptr; }
    [[nodiscard]] const uint32_t *leaf_words() const { return is_bvh() ? bvh.leaf_words.data() : kd.leaf_words.data(); }
    [[nodiscard]] AccelStatistics measure() const;

    /// The triangles' ids become ids[id].
    void renumber(std::span<const uint32_t> ids);

    /// Of the wished kind, which is not AccelKind::automatic, or a kd-tree where that does not fit. The triangles' ids
    /// count from 0. So many threads are allowed; no more than pay are used.
    [[nodiscard]] static TriangleTree build(std::span<const TriangleCorners> triangles, AccelKind wish,
                                            const Crew &crew);
};

} // namespace glint
