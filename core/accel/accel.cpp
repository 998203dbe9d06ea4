// From a scene to what rays are traced against.
#include "accel/accel_impl.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <thread>

#include "accel/tree_statistics.hpp"

namespace glint {

namespace {

/// Starting a thread takes about as long as building over this many triangles.
constexpr uint32_t triangles_worth_a_thread = 500;

unsigned threads_for(const AccelOptions &options, uint32_t triangle_count) {
    const unsigned allowed = options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
    return std::min(allowed, 1 + triangle_count / triangles_worth_a_thread);
}

AccelKind kind_for(AccelKind wish, uint32_t triangle_count) {
    if (wish == AccelKind::automatic)
        wish = triangle_count <= most_triangles_for_kdtree ? AccelKind::kdtree : AccelKind::bvh;
    // A hierarchy over nothing has no root, and over more triangles than its links count does not fit.
    const bool fits = triangle_count > 0 && triangle_count <= max_bvh_triangles;
    return wish == AccelKind::bvh && !fits ? AccelKind::kdtree : wish;
}

} // namespace

std::string_view accel_kind_name(AccelKind kind) {
    switch (kind) {
    case AccelKind::automatic:
        return "automatic";
    case AccelKind::kdtree:
        return "kdtree";
    case AccelKind::bvh:
        return "bvh";
    case AccelKind::brute:
        return "brute";
    }
    return "";
}

Accel::Accel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Accel::~Accel() = default;

std::shared_ptr<const Accel> Accel::build(std::shared_ptr<const Scene> scene, const AccelOptions &options) {
    assert(scene);
    const auto start = std::chrono::steady_clock::now();
    auto impl = std::make_unique<Impl>();
    impl->scene = std::move(scene);
    impl->kind = kind_for(options.kind, impl->scene->triangle_count());
    const unsigned threads = threads_for(options, impl->scene->triangle_count());
    TriangleData triangles = TriangleData::from(*impl->scene, threads);
    if (impl->kind == AccelKind::brute) {
        impl->tree = single_leaf_tree(triangles.corners);
    } else if (impl->kind == AccelKind::bvh) {
        impl->bvh = build_wide_bvh(triangles.corners, threads);
    } else {
        impl->tree = build_kd_tree(triangles.corners, threads);
    }
    impl->quadrics = QuadricTree::from(*impl->scene);
    impl->surfaces = std::move(triangles.surfaces);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    impl->statistics = impl->kind == AccelKind::bvh ? measure_bvh(impl->bvh, impl->scene->triangle_count())
                                                    : measure_tree(impl->tree, impl->scene->triangle_count());
    impl->statistics.build_seconds = elapsed.count();
    impl->statistics.bytes =
        impl->tree.nodes.size() * sizeof(KdNode) + impl->tree.leaf_words.size() * sizeof(uint32_t) +
        impl->bvh.nodes.size() * sizeof(WideNode) + impl->bvh.leaf_words.size() * sizeof(uint32_t) +
        impl->surfaces.size() * sizeof(TriangleSurface) + impl->quadrics.nodes.size() * sizeof(QuadricNode) +
        impl->quadrics.quadrics.size() * sizeof(PlacedQuadric);
    return std::shared_ptr<const Accel>(new Accel(std::move(impl)));
}

const Scene &Accel::scene() const {
    return *impl_->scene;
}
AccelKind Accel::kind() const {
    return impl_->kind;
}
const AccelStatistics &Accel::statistics() const {
    return impl_->statistics;
}

} // namespace glint
