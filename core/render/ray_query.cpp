// Rays of one's own against a scene's triangles.
#include <glint/ray_query.hpp>

#include "accel/accel_impl.hpp"
#include "kernel/kernel.hpp"
#include "render/geometry_view.hpp"

namespace glint {

struct RayQuery::Impl {
    std::shared_ptr<const Accel> accel;
    GeometryView geometry;
    const Kernel &kernel;
};

RayQuery::RayQuery(std::shared_ptr<const Accel> accel, Isa isa) {
    const GeometryView geometry = view_of(*accel);
    impl_.reset(new Impl{std::move(accel), geometry, kernel_for(isa)});
}
RayQuery::~RayQuery() = default;

void RayQuery::closest_hits(const RayBatch &rays, const HitBatch &hits) const {
    impl_->kernel.closest_hits(impl_->geometry, rays, hits);
}
void RayQuery::any_hits(const RayBatch &rays, uint8_t *occluded) const {
    impl_->kernel.any_hits(impl_->geometry, rays, occluded);
}
Isa RayQuery::isa() const {
    return impl_->kernel.isa;
}

} // namespace glint
