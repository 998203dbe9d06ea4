// A glint::Scene as an Embree scene.
#pragma once

#include <vector>

#include <glint/scene.hpp>

#include "bench/peers/embree/device.hpp"

namespace glint::bench::embree {

/// How the tree is built and walked.
struct TreeKind {
    const char *name; ///< "high", ...
    RTCBuildQuality quality;
    bool robust; ///< no rays lost at edges
};

// "low" is Embree's tree of trees: one a mesh, each of the best quality. In a room of few walls it is the fastest to
// trace by far (a third less time than "high" for the Cornell room's frames); for large meshes one of the others is. So
// all are tried. Robust trees win now and then for single classes of rays, by little, and never for frames.
inline constexpr TreeKind low_tree{"low", RTC_BUILD_QUALITY_LOW, false};
inline constexpr TreeKind medium_tree{"medium", RTC_BUILD_QUALITY_MEDIUM, false}; ///< Embree's own choice
inline constexpr TreeKind high_tree{"high", RTC_BUILD_QUALITY_HIGH, false};
inline constexpr TreeKind robust_tree{"high robust", RTC_BUILD_QUALITY_HIGH, true};

/// The meshes in a form that Embree can read without copying. Must outlive the scenes made from it.
class SharedMeshes {
public:
    explicit SharedMeshes(const Scene &scene);

    /// A scene with a geometry for every surface, in the order and with the number of Scene::surface(), ready to be
    /// traced. Objects have mask bit 0, light i bit 1 + i (lights from the 31st on share the last).
    [[nodiscard]] SceneHandle build(RTCDevice device, const TreeKind &kind) const;

    /// The number in glint's scene of a triangle of Embree's.
    [[nodiscard]] uint32_t triangle_id(uint32_t surface, uint32_t primitive) const {
        return surfaces_[surface].first_triangle + primitive;
    }

private:
    struct Surface {
        std::vector<Point> positions; ///< one more than the mesh has: Embree reads 16 bytes at each
        const std::vector<Triangle> *triangles;
        uint32_t first_triangle;
        uint32_t mask;
    };
    std::vector<Surface> surfaces_;
};

} // namespace glint::bench::embree
