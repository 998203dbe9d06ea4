// Reading a mesh: Glint beside tinyobjloader.
#include "bench/read_comparison.hpp"

#include <fmt/format.h>

#include <glint/read.hpp>

#include "bench/interleaved.hpp"
#include "bench/json_parts.hpp"
#include "bench/peers/tinyobj/read.hpp"

namespace glint::bench {

namespace {

/// One way to read, its outcome, and what it says the file holds.
template <typename Outcome, typename Read> struct Reader {
    Read read;
    mutable Result<Outcome> outcome = Error(ErrorCode::cancelled, "not read");

    void prepare() const { outcome = Error(ErrorCode::cancelled, "not read"); } // nor freed while the clock runs
    void run() const { outcome = read(); }
};
template <typename Outcome, typename Read> Reader<Outcome, Read> reader(Read read) {
    return {std::move(read)};
}

} // namespace

Result<ReadReport> compare_reading(const std::filesystem::path &file, double min_seconds) {
    ReadReport report;
    report.machine = describe_machine();
    report.mesh = file.string();
    const auto glint = reader<MeshFile>([&] { return read_obj(file); });
    const auto peer = reader<TinyobjMesh>([&] { return read_with_tinyobj(file); });
    constexpr size_t min_rounds = 3;
    Turns turns;
    double spent_ms = 0.0;
    while (turns.glint_ms.size() < min_rounds || spent_ms < 1000.0 * min_seconds) {
        turns.take(glint, peer);
        if (!glint.outcome) return glint.outcome.error();
        if (!peer.outcome) return peer.outcome.error();
        spent_ms += turns.glint_ms.back() + turns.peer_ms.back();
    }
    std::error_code error;
    report.bytes = std::filesystem::file_size(file, error);
    report.glint_triangles = glint.outcome->mesh->triangles.size();
    report.peer_triangles = peer.outcome->triangles;
    report.rounds = turns.glint_ms.size();
    report.glint_ms = summarize(std::move(turns.glint_ms));
    report.peer_ms = summarize(std::move(turns.peer_ms));
    if (report.glint_triangles > report.peer_triangles) {
        return Error(ErrorCode::bad_input, report.mesh + ": Glint reads more triangles than tinyobjloader");
    }
    return report;
}

std::string to_text(const ReadReport &report) {
    const auto line = [](const char *name, uint64_t triangles, const Summary &ms) {
        return fmt::format("{:<14}{:>10}{:>10.1f}{:>10.1f}{:>10.1f}\n", name, triangles, ms.median, ms.min, ms.p95);
    };
    return fmt::format("{}, {:.1f} MB, {} rounds in turns\n{:<14}{:>10}{:>10}{:>10}{:>10}\n", report.mesh,
                       static_cast<double>(report.bytes) / 1e6, report.rounds, "", "triangles", "median ms", "min",
                       "p95") +
           line("Glint", report.glint_triangles, report.glint_ms) +
           line("tinyobjloader", report.peer_triangles, report.peer_ms) +
           fmt::format("Glint takes {:.2f} times as long\n", report.ratio());
}

std::string to_json(const ReadReport &report) {
    return json_text({{"machine", to_json(report.machine)},
                      {"mesh", report.mesh},
                      {"bytes", report.bytes},
                      {"glint_triangles", report.glint_triangles},
                      {"peer_triangles", report.peer_triangles},
                      {"rounds", report.rounds},
                      {"glint_ms", to_json(report.glint_ms)},
                      {"peer_ms", to_json(report.peer_ms)},
                      {"ratio", report.ratio()}});
}

} // namespace glint::bench
