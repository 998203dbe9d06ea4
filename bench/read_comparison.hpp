// Reading a mesh: Glint beside tinyobjloader, which reads inside Glint, too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <glint/result.hpp>

#include "bench/machine.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

struct ReadReport {
    Machine machine;
    std::string mesh; ///< the file
    uint64_t bytes = 0;
    uint64_t glint_triangles = 0, peer_triangles = 0; ///< what Glint leaves out has no area
    Summary glint_ms, peer_ms;
    size_t rounds = 0;
    [[nodiscard]] double ratio() const { return glint_ms.median / peer_ms.median; } ///< below 1: Glint is faster
};

/// Reads the OBJ file with both in turns, at least three times each, for at least so many seconds. Fails with what
/// either says of the file.
[[nodiscard]] Result<ReadReport> compare_reading(const std::filesystem::path &file, double min_seconds);

[[nodiscard]] std::string to_text(const ReadReport &report);
/// `{"machine", "mesh", "bytes", "glint_triangles", "peer_triangles", "rounds", "glint_ms": {"median", "min", "p95"},
/// "peer_ms": {...}, "ratio"}`.
[[nodiscard]] std::string to_json(const ReadReport &report);

} // namespace glint::bench
