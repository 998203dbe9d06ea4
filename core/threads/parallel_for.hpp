// A loop whose turns are shared out among threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "threads/crew.hpp"

namespace glint {

/// Calls body(i, thread) once for each i < count, on the crew's threads or fewer: i in order, thread is the caller's
/// number among them. Rethrows the first exception that a call threw; calls that had not begun by then are
/// dropped.
void parallel_for(size_t count, const Crew &crew, const std::function<void(size_t, unsigned)> &body);

/// The same for ranges: calls body(begin, end) for pieces of at most piece_size that together are [0, count).
template <typename Body> void parallel_for_pieces(size_t count, size_t piece_size, const Crew &crew, Body &&body) {
    parallel_for((count + piece_size - 1) / piece_size, crew,
                 [&](size_t piece, unsigned) { body(piece * piece_size, std::min(count, (piece + 1) * piece_size)); });
}

} // namespace glint
