// glint_compare_rays RAYS [THREADS]: every kernel of this machine on some RAYS rays, spread over all meshes, against
// the scalar kernel, bit by bit, a sixteenth of them by brute force too. Prints a line a mesh; exit code 1 where
// anything differs.
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "kernel/ray_comparison.hpp"
#include "support/meshes.hpp"
#include "threads/thread_group.hpp"

using namespace glint;
using namespace glint::test;

int main(int count, char **arguments) {
    if (count < 2) return std::fputs("usage: glint_compare_rays RAYS [THREADS]\n", stderr), 2;
    const double rays = std::atof(arguments[1]);
    const unsigned threads = count > 2 ? static_cast<unsigned>(std::atoi(arguments[2])) : 1;
    constexpr double rays_a_batch = 215.0;
    constexpr uint32_t brute_force_every = 16; // otherwise most of the time would go there
    const std::vector<NamedMesh> meshes = all_meshes();
    const auto batches = static_cast<uint32_t>(1.0 + rays / rays_a_batch / static_cast<double>(meshes.size()));

    RayComparison all;
    for (const NamedMesh &mesh : meshes) {
        const auto scene = scene_of(mesh.mesh);
        std::vector<RayComparison> parts(threads);
        {
            ThreadGroup workers;
            for (unsigned i = 0; i < threads; ++i) {
                workers.start([&, i] {
                    const auto part_end = [&](uint64_t part) {
                        return static_cast<uint32_t>(batches * part / threads);
                    };
                    parts[i] = compare_rays(scene, part_end(i), part_end(i + 1), brute_force_every);
                });
            }
        }
        RayComparison result;
        for (const RayComparison &part : parts) result += part;
        std::printf("%-17s %10llu rays %10llu hits %6llu differences %s\n", mesh.name.c_str(),
                    static_cast<unsigned long long>(result.rays), static_cast<unsigned long long>(result.hits),
                    static_cast<unsigned long long>(result.differences), result.first_difference.c_str());
        std::fflush(stdout);
        all += result;
    }
    std::printf("%-17s %10llu rays %10llu hits %6llu differences\n", "all", static_cast<unsigned long long>(all.rays),
                static_cast<unsigned long long>(all.hits), static_cast<unsigned long long>(all.differences));
    return all.differences == 0 && all.hits > 0 ? 0 : 1;
}
