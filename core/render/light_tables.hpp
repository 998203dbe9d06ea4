// A scene's lights, arranged for the kernels: one entry for each place that light comes from.
#pragma once

#include <memory>
#include <vector>

#include <glint/scene.hpp>

#include "kernel/kernel.hpp"

namespace glint {

class LightTables {
public:
    /// Adds a light whose own shape has so many triangles or quadrics, from this one on.
    void add(const Light &light, const Point &position, uint32_t first, uint32_t count);

    /// Entries that a light gets.
    [[nodiscard]] static uint32_t entries_of(const Light &light);

    /// Valid while this object lives and nothing is added.
    [[nodiscard]] const std::vector<LightShading> &entries() const { return entries_; }
    /// Whether all of them shine the same in all directions, from one place.
    [[nodiscard]] bool are_plain() const;

private:
    struct Area {
        std::shared_ptr<const Mesh> mesh;
        std::vector<float> cumulative;
        LightArea view;
    };

    std::vector<LightShading> entries_;
    std::vector<std::unique_ptr<const Area>> areas_;
};

} // namespace glint
