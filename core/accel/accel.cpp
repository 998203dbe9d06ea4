// From a scene to what rays are traced against.
#include <algorithm>
#include <cassert>
#include <chrono>
#include <map>

#include "accel/accel_impl.hpp"

namespace glint {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

bool is_moving(const Scene &scene, uint32_t surface) {
    const SurfaceRef ref = scene.surface(surface);
    return !ref.is_light && scene.objects()[ref.index].pose;
}

/// The kind of all trees of a scene: whether triangles are small in the picture is for the whole scene to say, not for
/// one mesh of many.
AccelKind kind_for(const Scene &scene, AccelKind wish) {
    if (wish != AccelKind::automatic) return wish;
    return scene.triangle_count() <= most_triangles_for_kdtree ? AccelKind::kdtree : AccelKind::bvh;
}

/// Trees over what stands still and, of each mesh that moves, over that mesh.
class PartsBuilder {
public:
    PartsBuilder(const Scene &scene, const AccelOptions &options)
        : scene_(scene),
          kind_(kind_for(scene, options.kind)),
          parts_(std::make_shared<SharedParts>(options)),
          crew_(options.threads, parts_->options.submit) {}

    std::shared_ptr<const SharedParts> build() {
        TriangleData triangles = TriangleData::from(scene_, crew_);
        parts_->surfaces = std::move(triangles.surfaces);
        take_movers(triangles.corners);
        if (parts_->movers.empty()) {
            parts_->still = TriangleTree::build(triangles.corners, kind_, crew_);
        } else {
            build_still(triangles.corners);
        }
        measure();
        return std::move(parts_);
    }

private:
    /// Finds the meshes that move, and builds their trees.
    void take_movers(std::span<const TriangleCorners> corners) {
        std::map<const Mesh *, uint32_t> tree_of;
        uint32_t first = 0;
        for (uint32_t s = 0; s < scene_.surface_count(); ++s) {
            const Mesh *const mesh = scene_.surface_mesh(s);
            const auto count = mesh ? static_cast<uint32_t>(mesh->triangles.size()) : 0;
            if (mesh && is_moving(scene_, s)) {
                const auto [known, is_new] = tree_of.try_emplace(mesh, static_cast<uint32_t>(parts_->meshes.size()));
                if (is_new) {
                    parts_->meshes.push_back(TriangleTree::build(corners.subspan(first, count), kind_, crew_));
                }
                parts_->instance_of_surface.resize(scene_.surface_count(), no_instance);
                parts_->instance_of_surface[s] = static_cast<uint32_t>(parts_->movers.size());
                parts_->movers.push_back({scene_.surface(s).index, first, known->second});
            }
            first += count;
        }
    }

    /// Over the triangles between the movers'.
    void build_still(std::span<const TriangleCorners> all) {
        UninitializedVector<TriangleCorners> corners;
        std::vector<uint32_t> ids;
        for (uint32_t id = 0; id < all.size(); ++id) {
            if (parts_->instance_of_surface[parts_->surfaces[id].surface] != no_instance) continue;
            corners.push_back(all[id]);
            ids.push_back(id);
        }
        parts_->still = TriangleTree::build(corners, kind_, crew_);
        parts_->still.renumber(ids);
    }

    void measure() {
        AccelStatistics &sum = parts_->statistics = parts_->still.measure();
        for (const TriangleTree &tree : parts_->meshes) {
            const AccelStatistics one = tree.measure();
            sum.nodes += one.nodes;
            sum.leaves += one.leaves;
            sum.empty_leaves += one.empty_leaves;
            sum.references += one.references;
            sum.depth = std::max(sum.depth, one.depth);
            sum.bytes += one.bytes;
        }
        sum.triangles = scene_.triangle_count();
        sum.bytes += parts_->surfaces.size() * sizeof(TriangleSurface);
    }

    const Scene &scene_;
    AccelKind kind_;
    std::shared_ptr<SharedParts> parts_;
    Crew crew_;
};

bool moves_quadrics(const Scene &scene) {
    const std::vector<uint32_t> &all = scene.quadric_surfaces();
    return std::any_of(all.begin(), all.end(), [&](uint32_t s) { return is_moving(scene, s); });
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
    const Clock::time_point start = Clock::now();
    auto impl = std::make_unique<Impl>();
    impl->shared = PartsBuilder(*scene, options).build();
    impl->quadrics = std::make_shared<const QuadricTree>(QuadricTree::from(*scene));
    impl->instances = InstanceTree::from(*scene, impl->shared->movers, impl->shared->meshes);
    impl->scene = std::move(scene);
    impl->statistics = impl->shared->statistics;
    impl->statistics.bytes += impl->quadrics->nodes.size() * sizeof(BoxNode) +
                              impl->quadrics->quadrics.size() * sizeof(PlacedQuadric) +
                              impl->instances.instances.size() * sizeof(Instance);
    impl->statistics.build_seconds = seconds_since(start);
    return std::shared_ptr<const Accel>(new Accel(std::move(impl)));
}

std::shared_ptr<const Accel> Accel::update(const std::shared_ptr<const Accel> &previous,
                                           std::shared_ptr<const Scene> scene) {
    assert(previous && scene);
    const Impl &old = previous->impl();
    if (!scene->is_edit_of(*old.scene)) return build(std::move(scene), old.shared->options);
    const Clock::time_point start = Clock::now();
    auto impl = std::make_unique<Impl>();
    impl->shared = old.shared;
    impl->quadrics =
        moves_quadrics(*scene) ? std::make_shared<const QuadricTree>(QuadricTree::from(*scene)) : old.quadrics;
    impl->instances = InstanceTree::from(*scene, impl->shared->movers, impl->shared->meshes);
    impl->scene = std::move(scene);
    impl->statistics = old.statistics;
    impl->statistics.build_seconds = seconds_since(start);
    return std::shared_ptr<const Accel>(new Accel(std::move(impl)));
}

const Scene &Accel::scene() const {
    return *impl_->scene;
}
AccelKind Accel::kind() const {
    return impl_->shared->still.kind;
}
const AccelStatistics &Accel::statistics() const {
    return impl_->statistics;
}

} // namespace glint
