// Kernels against each other on the same rays.
#include "kernel/ray_comparison.hpp"

#include <cmath>
#include <sstream>

#include "kernel/ray_batches.hpp"
#include "math/bits.hpp"

namespace glint::test {

namespace {

/// What one kernel says of a batch.
struct Answers {
    std::vector<float> t;
    std::vector<uint32_t> triangle_id;
    std::vector<uint8_t> occluded;

    Answers(const RayQuery &query, const RayBatch &batch)
        : t(batch.count), triangle_id(batch.count), occluded(batch.count) {
        query.closest_hits(batch, {t.data(), triangle_id.data()});
        query.any_hits(batch, occluded.data());
    }
    [[nodiscard]] bool agrees(const Answers &other, size_t i) const {
        return bit_cast<uint32_t>(t[i]) == bit_cast<uint32_t>(other.t[i]) && triangle_id[i] == other.triangle_id[i] &&
               occluded[i] == other.occluded[i];
    }
};

std::ostream &operator<<(std::ostream &out, const std::pair<const Answers &, size_t> &answer) {
    const auto &[answers, i] = answer;
    return out << answers.triangle_id[i] << " at " << answers.t[i] << (answers.occluded[i] ? ", blocked" : ", free");
}

struct NamedQuery {
    std::string name;
    RayQuery query;
};
using NamedQueries = std::vector<std::unique_ptr<NamedQuery>>;

class Comparer {
public:
    Comparer(const std::shared_ptr<const Scene> &scene, uint32_t brute_force_every)
        : brute_force_every_(brute_force_every),
          batches_(*scene->objects()[0].mesh),
          tree_(Accel::build(scene, {AccelKind::kdtree, 1})),
          bvh_(Accel::build(scene, {AccelKind::bvh, 2})),
          brute_(Accel::build(scene, {AccelKind::brute, 1})),
          definition_(tree_, Isa::scalar) {
        for (const Isa isa : available_isas()) {
            const std::string name(isa_name(isa));
            if (isa != Isa::scalar) by_tree_.emplace_back(new NamedQuery{name, RayQuery(tree_, isa)});
            by_tree_.emplace_back(new NamedQuery{name + " by hierarchy", RayQuery(bvh_, isa)});
            by_force_.emplace_back(new NamedQuery{name + " by brute force", RayQuery(brute_, isa)});
        }
    }

    void compare(uint32_t number) {
        RayRows rows = batches_.batch(number);
        const Answers first = compare(number, rows);
        result_.rays += rows.count();
        for (size_t i = 0; i < rows.count(); ++i) {
            result_.hits += first.triangle_id[i] != no_triangle;
            const float t = first.t[i];
            rows.t_max[i] = i % 3 == 0 ? t : std::nextafter(t, i % 3 == 1 ? 0.0f : INFINITY);
        }
        compare(number, rows);
    }
    [[nodiscard]] const RayComparison &result() const { return result_; }

private:
    Answers compare(uint32_t number, const RayRows &rows) {
        const Answers expected(definition_, rows.batch());
        compare(number, rows, expected, by_tree_);
        if (number % brute_force_every_ == 0) compare(number, rows, expected, by_force_);
        return expected;
    }

    void compare(uint32_t number, const RayRows &rows, const Answers &expected, const NamedQueries &queries) {
        for (const auto &other : queries) {
            const Answers found(other->query, rows.batch());
            for (size_t i = 0; i < rows.count(); ++i) {
                if (!found.agrees(expected, i) && result_.differences++ == 0) {
                    note_difference(number, rows, i, other->name, found, expected);
                }
            }
        }
    }

    void note_difference(uint32_t number, const RayRows &rows, size_t i, const std::string &name, const Answers &found,
                         const Answers &expected) {
        std::ostringstream text;
        text << std::hexfloat << "batch " << number << ", ray " << i << " of " << rows.count() << ", org "
             << rows.org_x[i] << ' ' << rows.org_y[i] << ' ' << rows.org_z[i] << " dir " << rows.dir_x[i] << ' '
             << rows.dir_y[i] << ' ' << rows.dir_z[i] << " t_max " << rows.t_max[i] << ": " << name << ' '
             << std::pair<const Answers &, size_t>(found, i) << "; scalar "
             << std::pair<const Answers &, size_t>(expected, i);
        result_.first_difference = text.str();
    }

    uint32_t brute_force_every_;
    BatchSet batches_;
    std::shared_ptr<const Accel> tree_, bvh_, brute_;
    RayQuery definition_;
    NamedQueries by_tree_, by_force_;
    RayComparison result_;
};

} // namespace

RayComparison &RayComparison::operator+=(const RayComparison &other) {
    rays += other.rays;
    hits += other.hits;
    differences += other.differences;
    if (first_difference.empty()) first_difference = other.first_difference;
    return *this;
}

RayComparison compare_rays(const std::shared_ptr<const Scene> &scene, uint32_t first, uint32_t last,
                           uint32_t brute_force_every) {
    Comparer comparer(scene, brute_force_every);
    for (uint32_t number = first; number < last; ++number) comparer.compare(number);
    return comparer.result();
}

} // namespace glint::test
