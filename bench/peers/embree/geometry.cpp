// A glint::Scene as an Embree scene.
#include "bench/peers/embree/geometry.hpp"

#include <algorithm>

namespace glint::bench::embree {

SharedMeshes::SharedMeshes(const Scene &scene) {
    uint32_t first_triangle = 0;
    for (uint32_t s = 0; s < scene.surface_count(); ++s) {
        const Mesh &mesh = *scene.surface_mesh(s);
        const SurfaceRef ref = scene.surface(s);
        Surface surface{mesh.positions, &mesh.triangles, first_triangle,
                        ref.is_light ? 2u << std::min(ref.index, 30u) : 1u};
        surface.positions.emplace_back(0.0f);
        surfaces_.push_back(std::move(surface));
        first_triangle += static_cast<uint32_t>(mesh.triangles.size());
    }
}

SceneHandle SharedMeshes::build(RTCDevice device, const TreeKind &kind) const {
    SceneHandle scene(rtcNewScene(device));
    rtcSetSceneBuildQuality(scene.get(), kind.quality);
    rtcSetSceneFlags(scene.get(), kind.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    for (uint32_t s = 0; s < surfaces_.size(); ++s) {
        const Surface &surface = surfaces_[s];
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH); // is used in a tree of trees only
        rtcSetGeometryMask(geometry, surface.mask);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, surface.positions.data(), 0,
                                   sizeof(Point), surface.positions.size() - 1);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, surface.triangles->data(), 0,
                                   sizeof(Triangle), surface.triangles->size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene.get(), geometry, s);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene.get());
    return scene;
}

} // namespace glint::bench::embree
