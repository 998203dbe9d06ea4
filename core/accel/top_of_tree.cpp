// Builds the top of the tree level by level: threads share the cells of a level, and pieces of its cells.
#include "accel/top_of_tree.hpp"

#include <algorithm>
#include <tuple>

#include "accel/parallel_for.hpp"

namespace glint {

namespace {

/// References that a thread divides at a time: they and their parts stay in its cache.
constexpr size_t piece_size = 8192;

/// Cells with more references than this are divided by all threads together. It must not depend on their number.
size_t one_thread_limit(size_t triangle_count) {
    return std::clamp<size_t>(triangle_count / 64, 4096, 65536);
}

/// Some of a cell's references and where they go.
struct Piece {
    FilledCell *from = nullptr, *lower = nullptr, *upper = nullptr;
    const Split *split = nullptr;
    size_t begin = 0, end = 0;
    SideCounts counts;       ///< how many go to either side
    SideCounts destinations; ///< where in the cells' lists

    [[nodiscard]] std::span<const Reference> references() const {
        return std::span<const Reference>(from->references).subspan(begin, end - begin);
    }
};

/// A thread's own place to divide a piece in, before the parts are copied to their places between other threads'.
struct Workbench {
    Partition partition;
    UninitializedVector<Reference> lower, upper;

    explicit Workbench(std::span<const TriangleCorners> triangles)
        : partition(triangles), lower(piece_size), upper(piece_size) {}

    void divide(const Piece &piece) {
        const SideCounts counts =
            partition.divide_as_counted(piece.references(), *piece.split, lower.data(), upper.data());
        std::copy_n(lower.data(), counts.lower, piece.lower->references.data() + piece.destinations.lower);
        std::copy_n(upper.data(), counts.upper, piece.upper->references.data() + piece.destinations.upper);
    }
};

/// The pieces of all cells that are split.
std::vector<Piece> cut_up(std::vector<FilledCell> &cells, const std::vector<Split> &splits) {
    std::vector<Piece> pieces;
    for (size_t i = 0; i < cells.size(); ++i) {
        if (!splits[i].exists()) continue;
        const size_t count = cells[i].references.size();
        for (size_t begin = 0; begin < count; begin += piece_size) {
            Piece &piece = pieces.emplace_back();
            piece.from = &cells[i];
            piece.split = &splits[i];
            piece.begin = begin;
            piece.end = std::min(count, begin + piece_size);
        }
    }
    return pieces;
}

} // namespace

TopOfTree build_top(FilledCell root, std::span<const TriangleCorners> triangles, const CostModel &cost,
                    unsigned threads) {
    const size_t limit = one_thread_limit(triangles.size());
    std::vector<Workbench> workbenches(threads, Workbench(triangles));
    TopOfTree top;
    top.branches.emplace_back();
    std::vector<FilledCell> level;
    level.push_back(std::move(root));
    const auto finish = [&](FilledCell &cell) {
        top.branches[cell.branch].cell = static_cast<uint32_t>(top.cells.size());
        top.cells.push_back(std::move(cell));
    };
    while (!level.empty()) {
        std::vector<Split> splits(level.size());
        parallel_for(level.size(), threads, [&](size_t i, unsigned) {
            if (level[i].references.size() > limit) splits[i] = choose_split(level[i].references, level[i].cell, cost);
        });
        std::vector<Piece> pieces = cut_up(level, splits);
        parallel_for(pieces.size(), threads, [&](size_t i, unsigned) {
            pieces[i].counts = count_sides(pieces[i].references(), *pieces[i].split);
        });

        std::vector<FilledCell> next;
        next.reserve(2 * level.size()); // pieces point into it
        size_t piece = 0;
        for (size_t i = 0; i < level.size(); ++i) {
            if (!splits[i].exists()) {
                finish(level[i]);
                continue;
            }
            SideCounts counts;
            FilledCell &lower = next.emplace_back(), &upper = next.emplace_back();
            for (; piece < pieces.size() && pieces[piece].from == &level[i]; ++piece) {
                pieces[piece].lower = &lower;
                pieces[piece].upper = &upper;
                pieces[piece].destinations = counts;
                counts.lower += pieces[piece].counts.lower;
                counts.upper += pieces[piece].counts.upper;
            }
            std::tie(lower.cell, upper.cell) = splits[i].cells(level[i].cell, counts.lower, counts.upper);
            lower.references.resize(counts.lower);
            upper.references.resize(counts.upper);
            lower.branch = static_cast<uint32_t>(top.branches.size());
            upper.branch = lower.branch + 1;
            top.branches[level[i].branch] = {splits[i], lower.branch, upper.branch, 0};
            top.branches.resize(top.branches.size() + 2);
        }
        parallel_for(pieces.size(), threads, [&](size_t i, unsigned thread) { workbenches[thread].divide(pieces[i]); });
        level = std::move(next);
    }
    return top;
}

} // namespace glint
