// Builds the binary hierarchy: large ranges of triangles are split by all threads together, the rest each by one.
#include "accel/bvh/binary_bvh.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "accel/parallel_for.hpp"

namespace glint {
namespace {

/// Four floats that the compiler may take as one register.
struct alignas(16) Four {
    float v[4];
};
inline Four lesser(const Four &a, const Four &b) {
    Four r;
    for (int i = 0; i < 4; ++i) r.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
    return r;
}
inline Four greater(const Four &a, const Four &b) {
    Four r;
    for (int i = 0; i < 4; ++i) r.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
    return r;
}
inline Four sum(const Four &a, const Four &b) {
    Four r;
    for (int i = 0; i < 4; ++i) r.v[i] = a.v[i] + b.v[i];
    return r;
}

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Bounds {
    Four lo{{infinity, infinity, infinity, infinity}}, hi{{-infinity, -infinity, -infinity, -infinity}};

    void extend(const Four &point) {
        lo = lesser(lo, point);
        hi = greater(hi, point);
    }
    void extend(const Bounds &other) {
        lo = lesser(lo, other.lo);
        hi = greater(hi, other.hi);
    }
    [[nodiscard]] float half_area() const {
        const float x = hi.v[0] - lo.v[0], y = hi.v[1] - lo.v[1], z = hi.v[2] - lo.v[2];
        return x * y + (y * z + z * x);
    }
};

/// A triangle's box. The fourth lane of `hi` is its number, as the bits of a small float.
struct Item {
    Four lo, hi;

    [[nodiscard]] Four centre() const { return sum(lo, hi); } ///< twice
    [[nodiscard]] uint32_t triangle_id() const { return std::bit_cast<uint32_t>(hi.v[3]); }
};

/// Some triangles that stand in a row, and where.
struct Range {
    uint32_t begin, end;
    Bounds box, centres;

    [[nodiscard]] uint32_t count() const { return end - begin; }
};

constexpr int bin_count = 16;

/// Triangles by where their centres lie.
struct Bins {
    Bounds box[3][bin_count];
    uint32_t count[3][bin_count] = {};

    void add(const Bins &other) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int bin = 0; bin < bin_count; ++bin) {
                box[axis][bin].extend(other.box[axis][bin]);
                count[axis][bin] += other.count[axis][bin];
            }
        }
    }
};

/// From a centre to its bin, along each axis.
struct Binning {
    Four origin, scale;

    explicit Binning(const Bounds &centres) : origin(centres.lo), scale{} {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centres.hi.v[axis] - centres.lo.v[axis];
            const float s = bin_count * (1.0f - 0x1p-20f) / extent;
            scale.v[axis] = extent > 0.0f && s < infinity ? s : 0.0f;
        }
    }
    [[nodiscard]] bool divides(int axis) const { return scale.v[axis] > 0.0f; }
    [[nodiscard]] int bin(const Four &centre, int axis) const {
        return static_cast<int>((centre.v[axis] - origin.v[axis]) * scale.v[axis]);
    }
    void put(std::span<const Item> items, Bins &bins) const {
        for (const Item &item : items) {
            const Four centre = item.centre();
            const Bounds box{item.lo, item.hi};
            for (int axis = 0; axis < 3; ++axis) {
                const int b = bin(centre, axis);
                bins.box[axis][b].extend(box);
                ++bins.count[axis][b];
            }
        }
    }
};

/// Bins below `bin` along `axis` go left.
struct Split {
    int axis = -1, bin = 0;
    float cost = infinity; ///< times the box's half area
    Bounds left, right;
    uint32_t left_count = 0;
};

/// What so many triangles in one leaf cost, in steps through a node.
float leaf_cost(uint32_t count) {
    return static_cast<float>((count + 7) / 8);
}

Split best_split(const Bins &bins, const Binning &binning) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!binning.divides(axis)) continue;
        Bounds left[bin_count];
        uint32_t left_count[bin_count];
        Bounds box;
        uint32_t count = 0;
        for (int bin = 1; bin < bin_count; ++bin) {
            box.extend(bins.box[axis][bin - 1]);
            count += bins.count[axis][bin - 1];
            left[bin] = box;
            left_count[bin] = count;
        }
        box = {};
        count = 0;
        for (int bin = bin_count - 1; bin > 0; --bin) {
            box.extend(bins.box[axis][bin]);
            count += bins.count[axis][bin];
            if (count == 0 || left_count[bin] == 0) continue;
            const float cost = left[bin].half_area() * leaf_cost(left_count[bin]) + box.half_area() * leaf_cost(count);
            if (cost < best.cost) best = {axis, bin, cost, left[bin], box, left_count[bin]};
        }
    }
    return best;
}

/// Splits ranges that lie in an array of items in place.
class RangeSplitter {
public:
    explicit RangeSplitter(std::span<Item> items) : items_(items) {}

    /// False where a leaf is cheaper.
    bool split(const Range &range, uint32_t depth, Range &left, Range &right) {
        if (range.count() <= 2) return false;
        const Binning binning(range.centres);
        const std::span<Item> items = items_.subspan(range.begin, range.count());
        Split split;
        if (depth < max_binary_depth / 2) {
            bins_ = {};
            binning.put(items, bins_);
            split = best_split(bins_, binning);
        }
        const float area = range.box.half_area();
        if (range.count() <= max_bvh_leaf && !(split.cost + area < leaf_cost(range.count()) * area)) return false;
        if (split.axis < 0) {
            halve(range, left, right);
            return true;
        }
        left = {range.begin, range.begin + split.left_count, split.left, {}};
        right = {left.end, range.end, split.right, {}};
        uint32_t i = 0, j = range.count();
        while (true) {
            for (; i < j; ++i) {
                const Four centre = items[i].centre();
                if (binning.bin(centre, split.axis) >= split.bin) break;
                left.centres.extend(centre);
            }
            for (; i < j; --j) {
                const Four centre = items[j - 1].centre();
                if (binning.bin(centre, split.axis) < split.bin) break;
                right.centres.extend(centre);
            }
            if (i == j) break;
            std::swap(items[i], items[j - 1]);
        }
        return true;
    }

private:
    /// For triangles that all have the same centre, and where the hierarchy gets too deep.
    void halve(const Range &range, Range &left, Range &right) {
        const uint32_t middle = range.begin + range.count() / 2;
        left = {range.begin, middle, {}, {}};
        right = {middle, range.end, {}, {}};
        for (Range *half : {&left, &right}) {
            for (uint32_t i = half->begin; i < half->end; ++i) {
                half->box.extend({items_[i].lo, items_[i].hi});
                half->centres.extend(items_[i].centre());
            }
        }
    }

    std::span<Item> items_;
    Bins bins_;
};

/// The whole building site.
class Builder {
public:
    Builder(std::span<const TriangleCorners> triangles, unsigned threads)
        : threads_(threads), count_(static_cast<uint32_t>(triangles.size())), items_(count_), other_(count_) {
        parallel_for_pieces(count_, piece, threads_, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const Box box = triangles[i].bounds();
                const float id = std::bit_cast<float>(static_cast<uint32_t>(i));
                items_[i] = {{{box.lo.x, box.lo.y, box.lo.z, 0.0f}}, {{box.hi.x, box.hi.y, box.hi.z, id}}};
            }
        });
    }

    BinaryBvh build() {
        // A subtree over n triangles from number b on keeps its nodes, at most 2 n - 1, from place 2 b on; the nodes
        // above the subtrees come first.
        bvh_.nodes.resize(max_top_nodes + 2 * size_t{count_});
        bvh_.triangle_ids.resize(count_);
        const Range all = measure({0, count_, {}, {}}, items_);
        const uint32_t large = std::max(count_ / max_subtrees, 4096u);
        std::vector<Site> open{{0, 0, all, false}};
        std::vector<Site> subtrees;
        uint32_t top_nodes = 1;
        while (!open.empty()) {
            const Site site = open.back();
            open.pop_back();
            Range left, right;
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
        parallel_for(subtrees.size(), threads_, [&](size_t i, unsigned) { grow(subtrees[i]); });
        return std::move(bvh_);
    }

private:
    static constexpr size_t piece = 1 << 14;
    static constexpr uint32_t max_subtrees = 64;
    static constexpr uint32_t max_top_nodes = 4 * max_subtrees;

    /// A node to be built.
    struct Site {
        uint32_t node, depth;
        Range range;
        bool in_other; ///< its items are in other_
    };

    [[nodiscard]] std::span<Item> array(bool other) { return other ? std::span(other_) : std::span(items_); }

    Range measure(Range range, std::span<const Item> items) {
        const size_t pieces = (range.count() + piece - 1) / piece;
        std::vector<Range> parts(pieces, Range{0, 0, {}, {}});
        parallel_for_pieces(range.count(), piece, threads_, [&](size_t begin, size_t end) {
            Range &part = parts[begin / piece];
            for (const Item &item : items.subspan(range.begin + begin, end - begin)) {
                part.box.extend({item.lo, item.hi});
                part.centres.extend(item.centre());
            }
        });
        for (const Range &part : parts) {
            range.box.extend(part.box);
            range.centres.extend(part.centres);
        }
        return range;
    }

    /// By all threads, from one array to the other. False where bins do not divide the range.
    bool split_together(const Site &site, Range &left, Range &right) {
        const Range &range = site.range;
        const std::span<const Item> from = array(site.in_other).subspan(range.begin, range.count());
        const std::span<Item> to = array(!site.in_other).subspan(range.begin, range.count());
        const Binning binning(range.centres);
        const size_t pieces = (from.size() + piece - 1) / piece;
        std::vector<Bins> bins(pieces);
        parallel_for_pieces(from.size(), piece, threads_, [&](size_t begin, size_t end) {
            binning.put(from.subspan(begin, end - begin), bins[begin / piece]);
        });
        Bins all;
        for (const Bins &part : bins) all.add(part);
        const Split split = best_split(all, binning);
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
        parallel_for_pieces(from.size(), piece, threads_, [&](size_t begin, size_t end) {
            const size_t number = begin / piece;
            uint32_t l = lefts[number], r = rights[number];
            for (const Item &item : from.subspan(begin, end - begin)) {
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
        const std::span<Item> items = array(root.in_other);
        RangeSplitter splitter(items);
        uint32_t next = max_top_nodes + 2 * root.range.begin;
        std::vector<Site> open{root};
        while (!open.empty()) {
            const Site site = open.back();
            open.pop_back();
            Range left, right;
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

    unsigned threads_;
    uint32_t count_;
    UninitializedVector<Item> items_, other_;
    BinaryBvh bvh_;
};

} // namespace

BinaryBvh build_binary_bvh(std::span<const TriangleCorners> triangles, unsigned threads) {
    return Builder(triangles, threads).build();
}

} // namespace glint
