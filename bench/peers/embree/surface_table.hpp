// A scene's surfaces and lights as the Whitted renderer wants them.
#pragma once

#include <memory>
#include <new>
#include <vector>

#include <glint/scene.hpp>

#include "bench/peers/embree/whitted_scene.hpp"

namespace glint::bench::embree {

/// Floats on a boundary of 64 bytes, not initialised.
class AlignedFloats {
public:
    explicit AlignedFloats(uint64_t count) : floats_(new(std::align_val_t{64}) float[count]) {}
    [[nodiscard]] float *get() const { return floats_.get(); }

private:
    struct Delete {
        void operator()(float *floats) const { ::operator delete[](floats, std::align_val_t{64}); }
    };
    std::unique_ptr<float[], Delete> floats_;
};

class SurfaceTable {
public:
    explicit SurfaceTable(const Scene &scene);

    /// Valid as long as the table.
    [[nodiscard]] SurfaceColumns columns() const;
    [[nodiscard]] const std::vector<WhittedLight> &lights() const { return lights_; }

private:
    static constexpr uint32_t column_count = 10;
    [[nodiscard]] float *column(uint32_t i) const { return floats_.get() + i * rows_; }
    void set_row(uint32_t row, const Color &glow, const Material &material);

    uint64_t rows_;
    AlignedFloats floats_;
    std::vector<WhittedLight> lights_;
};

} // namespace glint::bench::embree
