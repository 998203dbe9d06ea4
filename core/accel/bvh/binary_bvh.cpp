// Builds the binary hierarchy: large ranges of triangles are split by all threads together, the rest each by one.
#include "accel/bvh/binary_bvh.hpp"

#include <algorithm>
#include <vector>

#include "accel/bvh/range_splitter.hpp"
#include "math/bits.hpp"
#include "threads/parallel_for.hpp"

namespace glint {
namespace {

/// The whole building site.
class Builder {
public:
    Builder(std::span<const TriangleCorners> triangles, const Crew &crew)
        : crew_(crew), count_(static_cast<uint32_t>(triangles.size())), items_(count_), other_(count_) {
        parallel_for_pieces(count_, piece, crew_, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const Box box = triangles[i].bounds();
                const float id = bit_cast<float>(static_cast<uint32_t>(i));
                items_[i] = {{{box.lo.x, box.lo.y, box.lo.z, 0.0f}}, {{box.hi.x, box.hi.y, box.hi.z, id}}};
            }
        });
    }

    BinaryBvh build() {
        // A subtree over n triangles from number b on keeps its nodes, at most 2 n - 1, from place 2 b on; the nodes
        // above the subtrees come first.
        bvh_.nodes.resize(max_top_nodes + 2 * size_t{count_});
        bvh_.triangle_ids.resize(count_);
        const TriangleRange all = measure({0, count_, {}, {}}, items_);
        const uint32_t large = std::max(count_ / max_subtrees, 4096u);
        std::vector<Site> open{{0, 0, all, false}};
        std::vector<Site> subtrees;
        uint32_t top_nodes = 1;
        while (!open.empty()) {
            const Site site = open.back();
            open.pop_back();
            TriangleRange left, right;
            if (site.range.count() <= large || top_nodes + 2 > max_top_nodes || site.depth > 20 ||
                !split_together(site, left, right)) {
                subtrees.push_back(site);
                continue;
            }
            write(site.node, site.range.box, top_nodes, 0);
            open.push_back({top_nodes + 1, site.depth + 1, right, !site.in_other});
            open.push_back({top_nodes, site.depth + 1, left, !site.in_other});
            top_nodes += 2;
        }
        std::stable_sort(subtrees.begin(), subtrees.end(),
                         [](const Site &a, const Site &b) { return a.range.count() > b.range.count(); });
        parallel_for(subtrees.size(), crew_, [&](size_t i, unsigned) { grow(subtrees[i]); });
        return std::move(bvh_);
    }

private:
    static constexpr size_t piece = 1 << 14;
    static constexpr uint32_t max_subtrees = 64;
    static constexpr uint32_t max_top_nodes = 4 * max_subtrees;

    /// A node to be built.
    struct Site {
        uint32_t node, depth;
        TriangleRange range;
        bool in_other; ///< its items are in other_
    };

    [[nodiscard]] std::span<BoundedTriangle> array(bool other) { return other ? std::span(other_) : std::span(items_); }

    TriangleRange measure(TriangleRange range, std::span<const BoundedTriangle> items) {
        const size_t pieces = (range.count() + piece - 1) / piece;
        std::vector<TriangleRange> parts(pieces, TriangleRange{0, 0, {}, {}});
        parallel_for_pieces(range.count(), piece, crew_, [&](size_t begin, size_t end) {
            TriangleRange &part = parts[begin / piece];
            for (const BoundedTriangle &item : items.subspan(range.begin + begin, end - begin)) {
                part.box.extend({item.lo, item.hi});
                part.centres.extend(item.centre());
            }
        });
        for (const TriangleRange &part : parts) {
            range.box.extend(part.box);
            range.centres.extend(part.centres);
        }
        return range;
    }

    /// By all threads, from one array to the other. False where bins do not divide the range.
    bool split_together(const Site &site, TriangleRange &left, TriangleRange &right) {
        const TriangleRange &range = site.range;
        const std::span<const BoundedTriangle> from = array(site.in_other).subspan(range.begin, range.count());
        const std::span<BoundedTriangle> to = array(!site.in_other).subspan(range.begin, range.count());
        const Binning binning(range.centres);
        const size_t pieces = (from.size() + piece - 1) / piece;
        std::vector<CentreBins> bins(pieces);
        parallel_for_pieces(from.size(), piece, crew_, [&](size_t begin, size_t end) {
            binning.put(from.subspan(begin, end - begin), bins[begin / piece]);
        });
        CentreBins all;
        for (const CentreBins &part : bins) all.add(part);
        const BinSplit split = best_split(all, binning);
        if (split.axis < 0) return false;
        left = {range.begin, range.begin + split.left_count, split.left, {}};
        right = {left.end, range.end, split.right, {}};

        std::vector<uint32_t> lefts(pieces), rights(pieces);
        uint32_t next_left = 0, next_right = split.left_count;
        for (size_t i = 0; i < pieces; ++i) {
            lefts[i] = next_left;
            rights[i] = next_right;
            for (int bin = 0; bin < bin_count; ++bin) {
                (bin < split.bin ? next_left : next_right) += bins[i].count[split.axis][bin];
            }
        }
        std::vector<Bounds> left_centres(pieces), right_centres(pieces);
        parallel_for_pieces(from.size(), piece, crew_, [&](size_t begin, size_t end) {
            const size_t number = begin / piece;
            uint32_t l = lefts[number], r = rights[number];
            for (const BoundedTriangle &item : from.subspan(begin, end - begin)) {
                const Four centre = item.centre();
                const bool is_left = binning.bin(centre, split.axis) < split.bin;
                (is_left ? left_centres : right_centres)[number].extend(centre);
                to[is_left ? l++ : r++] = item;
            }
        });
        for (size_t i = 0; i < pieces; ++i) {
            left.centres.extend(left_centres[i]);
            right.centres.extend(right_centres[i]);
        }
        return true;
    }

    void write(uint32_t node, const Bounds &box, uint32_t first, uint32_t count) {
        BinaryNode &n = bvh_.nodes[node];
        for (int axis = 0; axis < 3; ++axis) {
            n.lo[axis] = box.lo.v[axis];
            n.hi[axis] = box.hi.v[axis];
        }
        n.first = first;
        n.count = count;
    }

    /// A subtree, by one thread.
    void grow(const Site &root) {
        const std::span<BoundedTriangle> items = array(root.in_other);
        RangeSplitter splitter(items);
        uint32_t next = max_top_nodes + 2 * root.range.begin;
        std::vector<Site> open{root};
        while (!open.empty()) {
            const Site site = open.back();
            open.pop_back();
            TriangleRange left, right;
            if (splitter.split(site.range, site.depth, left, right)) {
                write(site.node, site.range.box, next, 0);
                open.push_back({next + 1, site.depth + 1, right, false});
                open.push_back({next, site.depth + 1, left, false});
                next += 2;
            } else {
                write(site.node, site.range.box, site.range.begin, site.range.count());
            }
        }
        for (uint32_t i = root.range.begin; i < root.range.end; ++i) bvh_.triangle_ids[i] = items[i].triangle_id();
    }

    Crew crew_;
    uint32_t count_;
    UninitializedVector<BoundedTriangle> items_, other_;
    BinaryBvh bvh_;
};

} // namespace

BinaryBvh build_binary_bvh(std::span<const TriangleCorners> triangles, const Crew &crew) {
    return Builder(triangles, crew).build();
}

} // namespace glint
