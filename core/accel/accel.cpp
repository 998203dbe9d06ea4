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

} // namespace

Accel::Accel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Accel::~Accel() = default;

std::shared_ptr<const Accel> Accel::build(std::shared_ptr<const Scene> scene, const AccelOptions &options) {
    assert(scene);
    const auto start = std::chrono::steady_clock::now();
    auto impl = std::make_unique<Impl>();
    impl->scene = std::move(scene);
    impl->kind = options.kind;
    const unsigned threads = threads_for(options, impl->scene->triangle_count());
    TriangleData triangles = TriangleData::from(*impl->scene, threads);
    if (options.kind == AccelKind::brute) {
        impl->tree = single_leaf_tree(triangles.corners);
    } else {
        impl->tree = build_kd_tree(triangles.corners, threads);
    }
    impl->surfaces = std::move(triangles.surfaces);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    impl->statistics = measure_tree(impl->tree, impl->scene->triangle_count());
    impl->statistics.build_seconds = elapsed.count();
    impl->statistics.bytes = impl->tree.nodes.size() * sizeof(KdNode) +
                             impl->tree.leaf_words.size() * sizeof(uint32_t) +
                             impl->surfaces.size() * sizeof(TriangleSurface);
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
