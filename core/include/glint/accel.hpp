// The acceleration structure over a scene's triangles: a kd-tree, a bounding volume hierarchy, or none.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include <glint/export.hpp>
#include <glint/host_threads.hpp>
#include <glint/scene.hpp>

namespace glint {

/// How a ray finds the triangles it may meet.
enum class AccelKind {
    automatic, ///< kdtree or bvh, whichever was measured to be faster for so many triangles
    kdtree,    ///< surface-area-heuristic kd-tree: for few triangles, many pixels large
    bvh,       ///< bounding volume hierarchy, eight children a node: for many small triangles
    brute,     ///< every ray tests every triangle: slow, and the oracle that the trees are tested against
};

/// "automatic", "kdtree", "bvh" or "brute".
[[nodiscard]] GLINT_API std::string_view accel_kind_name(AccelKind kind);

/// AccelKind::automatic is a kd-tree for scenes of up to so many triangles.
inline constexpr uint32_t most_triangles_for_kdtree = 4000;

/// How to build.
struct AccelOptions {
    AccelKind kind = AccelKind::automatic; ///< decides about speed only: pictures and hits are the same to the bit
    unsigned threads = 0;                  ///< threads that build; 0 = one a processor. The tree does not depend on it
    /// Lends the host's threads, `threads` - 1 of them for each step. Empty = threads of the library's own. Kept by the
    /// Accel, for update().
    SubmitTask submit = {};
};

/// What the tree is like, and those of moving meshes with it. AccelKind::brute is a tree of one leaf.
struct AccelStatistics {
    uint32_t triangles = 0;
    uint64_t nodes = 0;  ///< inner nodes and leaves
    uint64_t leaves = 0; ///< empty ones included
    uint64_t empty_leaves = 0;
    uint64_t references = 0; ///< triangles in all leaves; references / triangles says how often triangles were cut
    uint32_t depth = 0;      ///< of the deepest leaf; a lone leaf has depth 0
    double sah_cost = 0.0;   ///< expected cost of a random ray, in nodes visited (MacDonald & Booth 1990);
                             ///< of what does not move
    uint64_t bytes = 0;      ///< nodes, leaves with their triangles, and what a hit needs to know of its triangle
    double build_seconds = 0.0;
};

/// Immutable; any number of renderers and threads may share one. Keeps its scene alive.
class GLINT_API Accel {
public:
    /// Cannot fail on a valid scene except for lack of memory (std::bad_alloc).
    [[nodiscard]] static std::shared_ptr<const Accel> build(std::shared_ptr<const Scene> scene,
                                                            const AccelOptions &options = {});
    /// The structure of a scene that came about by moving objects of the previous one's (with_poses()): all trees are
    /// shared with it, and only what knows where the objects stand is made anew, which costs little more than a
    /// microsecond an object. Any other scene is built from scratch, with the previous one's options.
    [[nodiscard]] static std::shared_ptr<const Accel> update(const std::shared_ptr<const Accel> &previous,
                                                             std::shared_ptr<const Scene> scene);
    ~Accel();
    Accel(const Accel &) = delete;
    Accel &operator=(const Accel &) = delete;

    [[nodiscard]] const Scene &scene() const;
    /// What was built; never AccelKind::automatic.
    [[nodiscard]] AccelKind kind() const;
    [[nodiscard]] const AccelStatistics &statistics() const;

    /// What the renderer sees; not part of the public interface.
    struct Impl;
    [[nodiscard]] const Impl &impl() const { return *impl_; }

private:
    explicit Accel(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace glint
