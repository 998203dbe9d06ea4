// Builds the top of the tree level by level: threads share the pieces that the cells of a level are cut into.
#include "accel/top_of_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "accel/split_search.hpp"
#include "threads/parallel_for.hpp"

namespace glint {

namespace {

/// References that a thread looks at at a time: they and their parts stay in its cache.
constexpr size_t piece_size = 8192;

/// Cells with more references than this are divided by all threads together. It must not depend on their number.
size_t one_thread_limit(size_t triangle_count) {
    return std::clamp<size_t>(triangle_count / 64, 4096, 65536);
}

/// What a piece sends to one side.
struct Shipment {
    FilledCell *to = nullptr;
    size_t place = 0; ///< in the cell's list
    size_t count = 0;
    Box occupied;
};

/// Some of a cell's references, what is counted of them, and where they go.
struct Piece {
    std::span<const Reference> references;
    SplitSearch search;
    Shipment lower, upper;
};

/// A cell of the level, its pieces, where it is split and into what.
struct Task {
    FilledCell from;
    std::vector<Piece> pieces;
    Split split;
    FilledCell lower, upper;
};

/// A thread's own place to divide a piece in, before the parts are copied to their places between other threads'.
class Workbench {
public:
    explicit Workbench(std::span<const TriangleCorners> triangles) : partition_(triangles) {}

    void divide(Piece &piece, const Split &split) {
        lower_.resize(piece_size);
        upper_.resize(piece_size);
        partition_.divide_as_counted(piece.references, split, lower_.data(), upper_.data());
        ship({lower_.data(), piece.lower.count}, piece.lower);
        ship({upper_.data(), piece.upper.count}, piece.upper);
    }

private:
    static void ship(std::span<const Reference> references, Shipment &shipment) {
        shipment.occupied = hull(references);
        std::copy(references.begin(), references.end(),
                  shipment.to->references.begin() + static_cast<std::ptrdiff_t>(shipment.place));
    }

    Partition partition_;
    UninitializedVector<Reference> lower_, upper_;
};

class TopBuilder {
public:
    TopBuilder(std::span<const TriangleCorners> triangles, const Crew &crew)
        : crew_(crew), limit_(one_thread_limit(triangles.size())), workbenches_(crew.threads, Workbench(triangles)) {}

    TopOfTree build(FilledCell root) {
        top_.branches.emplace_back();
        add(std::move(root));
        while (!level_.empty()) split_level();
        return std::move(top_);
    }

private:
    /// Keeps a cell for the next level, or for good if it is small.
    void add(FilledCell cell) {
        if (cell.references.size() <= limit_) return finish(std::move(cell));
        level_.emplace_back().from = std::move(cell);
    }
    void finish(FilledCell cell) {
        top_.branches[cell.branch].cell = static_cast<uint32_t>(top_.cells.size());
        top_.cells.push_back(std::move(cell));
    }

    /// Calls work(task, piece, thread) for every piece of the level.
    template <typename Work> void for_each_piece(std::vector<Task> &tasks, Work &&work) const {
        std::vector<std::pair<Task *, Piece *>> all;
        for (Task &task : tasks) {
            for (Piece &piece : task.pieces) all.emplace_back(&task, &piece);
        }
        parallel_for(all.size(), crew_,
                     [&](size_t i, unsigned thread) { work(*all[i].first, *all[i].second, thread); });
    }

    void split_level() {
        std::vector<Task> tasks = std::exchange(level_, {});
        for (Task &task : tasks) cut_up(task);
        for_each_piece(tasks, [](const Task &task, Piece &piece, unsigned) {
            piece.search.begin(task.from.occupied, task.from.references.size());
            piece.search.add(piece.references);
        });
        for (Task &task : tasks) choose_split(task);
        std::erase_if(tasks, [](const Task &task) { return !task.split.exists(); });
        for_each_piece(tasks, [](const Task &task, Piece &piece, unsigned) {
            const auto [lower, upper] = count_sides(piece.references, task.split);
            piece.lower.count = lower;
            piece.upper.count = upper;
        });
        for (Task &task : tasks) make_room(task);
        for_each_piece(tasks, [this](const Task &task, Piece &piece, unsigned thread) {
            workbenches_[thread].divide(piece, task.split);
        });
        for (Task &task : tasks) {
            for (const Piece &piece : task.pieces) {
                task.lower.occupied.extend(piece.lower.occupied);
                task.upper.occupied.extend(piece.upper.occupied);
            }
            add(std::move(task.lower));
            add(std::move(task.upper));
        }
    }

    void cut_up(Task &task) const {
        const std::span<const Reference> references = task.from.references;
        for (size_t begin = 0; begin < references.size(); begin += piece_size) {
            const size_t count = std::min(piece_size, references.size() - begin);
            task.pieces.push_back({references.subspan(begin, count), SplitSearch(), {}, {}});
        }
    }

    /// Puts the pieces' counts together. Finishes the cell if it stays whole.
    void choose_split(Task &task) {
        SplitSearch &search = task.pieces.front().search;
        for (size_t i = 1; i < task.pieces.size(); ++i) search.add(task.pieces[i].search);
        task.split = search.best(task.from.cell);
        while (task.split.cuts_off_empty_space()) {
            cut_off_empty_space(task.from, task.split);
            task.split = search.best(task.from.cell);
        }
        if (!task.split.exists()) finish(std::move(task.from));
    }

    /// Leaves the part of the cell that all references are in.
    void cut_off_empty_space(FilledCell &cell, const Split &split) {
        const auto [lower, upper] = split.cells(cell.cell, split.lower, split.upper);
        const auto [lower_branch, upper_branch] = add_branches(cell.branch, split);
        FilledCell empty;
        empty.cell = split.lower == 0 ? lower : upper;
        empty.branch = split.lower == 0 ? lower_branch : upper_branch;
        cell.cell = split.lower == 0 ? upper : lower;
        cell.branch = split.lower == 0 ? upper_branch : lower_branch;
        finish(std::move(empty));
    }

    std::pair<uint32_t, uint32_t> add_branches(uint32_t parent, const Split &split) {
        const auto lower = static_cast<uint32_t>(top_.branches.size());
        top_.branches.resize(top_.branches.size() + 2);
        top_.branches[parent] = {split, lower, lower + 1, 0};
        return {lower, lower + 1};
    }

    /// Prepares the two cells that a split makes, and a place in them for each piece.
    void make_room(Task &task) {
        size_t lower_count = 0, upper_count = 0;
        for (Piece &piece : task.pieces) {
            piece.lower.to = &task.lower;
            piece.lower.place = lower_count;
            lower_count += piece.lower.count;
            piece.upper.to = &task.upper;
            piece.upper.place = upper_count;
            upper_count += piece.upper.count;
        }
        task.lower.references.resize(lower_count);
        task.upper.references.resize(upper_count);
        std::tie(task.lower.cell, task.upper.cell) = task.split.cells(task.from.cell, lower_count, upper_count);
        std::tie(task.lower.branch, task.upper.branch) = add_branches(task.from.branch, task.split);
    }

    Crew crew_;
    size_t limit_;
    std::vector<Workbench> workbenches_; // one a thread
    TopOfTree top_;
    std::vector<Task> level_; // cells that are still to be split
};

} // namespace

TopOfTree build_top(FilledCell root, std::span<const TriangleCorners> triangles, const Crew &crew) {
    return TopBuilder(triangles, crew).build(std::move(root));
}

} // namespace glint
