// Glint's kernels and a peer's on the same rays.
#include "bench/kernel_comparison.hpp"

#include <algorithm>
#include <atomic>
#include <limits>

#include "bench/interleaved.hpp"
#include "bench/own_processor.hpp"
#include "threads/worker_pool.hpp"

namespace glint::bench {
namespace {

/// Rays of one turn. Enough for both to get used to their own tree again, few enough for the rays, a few megabytes in
/// either layout, to stay in the caches: who traces rays has just made them.
constexpr size_t turn_rays = size_t{1} << 16;
/// Rays that a thread takes at a time.
constexpr size_t chunk_rays = size_t{1} << 12;

/// Calls work(first, count) for rays first <= i < first + count in chunks, on all of the pool's threads.
template <typename Work> void in_chunks(WorkerPool &pool, size_t first, size_t count, const Work &work) {
    std::atomic<size_t> next{first};
    const size_t end = first + count;
    pool.run([&](unsigned) {
        for (size_t begin; (begin = next.fetch_add(chunk_rays, std::memory_order_relaxed)) < end;) {
            work(begin, std::min(chunk_rays, end - begin));
        }
    });
}

/// Glint with a set of rays: the counterpart of a PeerQuery.
class GlintQuery {
public:
    GlintQuery(const RayQuery &query, const RaySet &rays) : query_(query), rays_(rays), answers_(rays) {}

    /// Brings the rays to the caches, where a peer's are after PeerQuery::reset.
    void reset(size_t first, size_t count) {
        const RayBatch batch = rays_.batch(first, count);
        for (const float *field :
             {batch.org_x, batch.org_y, batch.org_z, batch.dir_x, batch.dir_y, batch.dir_z, batch.t_max}) {
            for (size_t i = 0; i < count; ++i) static_cast<void>(*static_cast<const volatile float *>(field + i));
        }
        if (rays_.question == RayQuestion::any_hit) {
            std::fill_n(answers_.occluded.begin() + static_cast<ptrdiff_t>(first), count, uint8_t{0});
        } else {
            std::fill_n(answers_.t.begin() + static_cast<ptrdiff_t>(first), count, 0.0f);
            std::fill_n(answers_.triangle_id.begin() + static_cast<ptrdiff_t>(first), count, no_triangle);
        }
    }

    void trace(size_t first, size_t count) {
        const RayBatch batch = rays_.batch(first, count);
        if (rays_.question == RayQuestion::any_hit) {
            query_.any_hits(batch, &answers_.occluded[first]);
        } else {
            query_.closest_hits(batch, {&answers_.t[first], &answers_.triangle_id[first]});
        }
    }

    [[nodiscard]] const RayAnswers &answers() const { return answers_; }

private:
    const RayQuery &query_;
    const RaySet &rays_;
    RayAnswers answers_;
};

/// A query, Glint's or a peer's, as something to take turns with: some of its rays, on all of the pool's threads.
template <typename Query> class Turn {
public:
    Turn(Query &query, WorkerPool &pool, size_t first, size_t count)
        : query_(query), pool_(pool), first_(first), count_(count) {}

    void prepare() const { query_.reset(first_, count_); }
    void run() const {
        in_chunks(pool_, first_, count_, [&](size_t first, size_t count) { query_.trace(first, count); });
    }

private:
    Query &query_;
    WorkerPool &pool_;
    size_t first_, count_;
};

/// Every eighth turn's rays.
RaySet sample_of(const RaySet &rays) {
    constexpr size_t stride = 8 * turn_rays;
    RaySet sample(rays.name, rays.question);
    for (size_t first = 0; first < rays.size(); first += stride) {
        for (size_t i = first; i < std::min(first + turn_rays, rays.size()); ++i) {
            sample.add({rays.org_x[i], rays.org_y[i], rays.org_z[i]}, {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]},
                       rays.t_max[i]);
        }
    }
    return sample;
}

/// A peer's way with a set of rays.
struct ChosenWay {
    std::string name;
    std::unique_ptr<PeerQuery> query;
};

/// The way that is fastest on a sample of the rays. All ways take turns, so that a slow moment of the machine does not
/// decide.
ChosenWay choose_way(const PeerKernels &kernels, const RaySet &rays, WorkerPool &pool) {
    constexpr int rounds = 5;
    const RaySet sample = sample_of(rays);
    const std::vector<std::string> names = kernels.ways(rays.question);
    size_t best = 0;
    double best_ms = std::numeric_limits<double>::max();
    for (int round = 0; round < rounds; ++round) {
        for (size_t way = 0; way < names.size(); ++way) {
            const std::unique_ptr<PeerQuery> query = kernels.query(sample, way);
            const Turn turn(*query, pool, 0, sample.size());
            turn.prepare();
            const double ms = time_ms([&] { turn.run(); });
            if (ms < best_ms) best_ms = ms, best = way;
        }
    }
    return {names[best], kernels.query(rays, best)};
}

/// The time of all rays from the times of their parts.
Summary sum(const std::vector<Turns> &parts, std::vector<double> Turns::*side) {
    Summary total;
    for (const Turns &part : parts) {
        const Summary summary = summarize(part.*side);
        total.median += summary.median;
        total.min += summary.min;
        total.p95 += summary.p95;
    }
    return total;
}

double mrays_per_s(size_t rays, double milliseconds) {
    return static_cast<double>(rays) / (1000.0 * milliseconds);
}

ClassRow measure_class(const RayQuery &query, const PeerKernels &kernels, const RaySet &rays, WorkerPool &pool,
                       double min_seconds) {
    constexpr uint64_t min_passes = 3;
    GlintQuery glint(query, rays);
    ChosenWay peer = choose_way(kernels, rays, pool);

    ClassRow row;
    row.ray_class = rays.name;
    row.threads = pool.threads();
    row.peer_kernel = std::move(peer.name);
    std::vector<Turns> parts((rays.size() + turn_rays - 1) / turn_rays);
    double spent_ms = 0.0;
    for (; row.passes < min_passes || spent_ms < 1000.0 * min_seconds; ++row.passes) {
        spent_ms += time_ms([&] {
            for (size_t part = 0; part < parts.size(); ++part) {
                const size_t first = part * turn_rays, count = std::min(turn_rays, rays.size() - first);
                parts[part].take(Turn(glint, pool, first, count), Turn(*peer.query, pool, first, count));
            }
        });
    }
    row.glint_ms = sum(parts, &Turns::glint_ms);
    row.peer_ms = sum(parts, &Turns::peer_ms);
    row.glint_mrays = mrays_per_s(rays.size(), row.glint_ms.median);
    row.peer_mrays = mrays_per_s(rays.size(), row.peer_ms.median);

    RayAnswers peer_answers(rays);
    peer.query->read(peer_answers);
    row.agreement = compare_answers(rays.question, glint.answers(), peer_answers);
    return row;
}

} // namespace

Agreement compare_answers(RayQuestion question, const RayAnswers &glint, const RayAnswers &peer) {
    Agreement agreement;
    const auto count = [&](bool glint_hits, bool peer_hits, bool same) {
        ++agreement.rays;
        agreement.glint_hits += glint_hits;
        agreement.peer_hits += peer_hits;
        agreement.same += same;
    };
    if (question == RayQuestion::any_hit) {
        for (size_t i = 0; i < glint.occluded.size(); ++i) {
            count(glint.occluded[i] != 0, peer.occluded[i] != 0, glint.occluded[i] == peer.occluded[i]);
        }
    } else {
        for (size_t i = 0; i < glint.triangle_id.size(); ++i) {
            const uint32_t ours = glint.triangle_id[i], theirs = peer.triangle_id[i];
            count(ours != no_triangle, theirs != no_triangle, ours == theirs);
        }
    }
    return agreement;
}

Result<std::vector<ClassRow>> compare_kernels(const std::shared_ptr<const Accel> &accel, const Viewpoint &viewpoint,
                                              const Peer &peer, const KernelComparisonOptions &options) {
    const auto say = [&](const std::string &text) {
        if (options.on_progress) options.on_progress(text);
    };
    say("making the rays");
    const RayQuery query(accel, options.isa);
    const std::vector<RaySet> classes = make_ray_classes(accel->scene(), query, viewpoint, options.size_px);
    say("building " + peer.name());
    const auto kernels = peer.kernels(std::shared_ptr<const Scene>(accel, &accel->scene()), options.isa);
    if (!kernels) return kernels.error();

    std::vector<ClassRow> rows;
    for (const unsigned threads : options.threads) {
        const OwnProcessor processor;
        const auto pool = processor.start_others([&] { return std::make_unique<WorkerPool>(threads); });
        for (const RaySet &rays : classes) {
            if (rays.size() == 0) continue;
            say("measuring " + rays.name + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads"));
            rows.push_back(measure_class(query, **kernels, rays, *pool, options.min_seconds));
        }
    }
    return rows;
}

} // namespace glint::bench
