// A surface for systems that offer a context but nothing to draw on.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <glint/gles/surface.hpp>

#include "gles/offscreen_target.hpp"

namespace glint::gles {

/// Draws into a texture of its own. A Context owns what the system gave, and has `Status make_current()` and
/// `ProcLoader proc_loader()`.
template <typename Context> class OffscreenSurface final : public Surface {
public:
    /// Leaves the context current. Fails with what making it current, loading OpenGL or the texture failed with.
    [[nodiscard]] static Result<std::unique_ptr<Surface>> create(std::string kind, Context context, uint32_t width_px,
                                                                 uint32_t height_px) {
        if (Status status = context.make_current(); !status) return std::move(status).error();
        Result<Gl> gl = Gl::load(context.proc_loader());
        if (!gl) return std::move(gl).error();
        OffscreenTarget target;
        if (Status status = target.resize(*gl, width_px, height_px); !status) return std::move(status).error();
        return std::unique_ptr<Surface>(
            new OffscreenSurface(std::move(kind), std::move(context), std::move(gl).value(), target));
    }

    [[nodiscard]] std::string kind() const override { return kind_; }
    [[nodiscard]] std::string gl_description() const override { return gl_.description(); }
    [[nodiscard]] uint32_t width_px() const override { return target_.width_px(); }
    [[nodiscard]] uint32_t height_px() const override { return target_.height_px(); }
    [[nodiscard]] ProcLoader proc_loader() const override { return context_.proc_loader(); }
    void finish() override { gl_.finish(); }

    Status make_current() override {
        if (Status status = context_.make_current(); !status) return status;
        target_.bind(gl_);
        return Done{};
    }

    Status resize(uint32_t width_px, uint32_t height_px) override {
        if (Status status = make_current(); !status) return status;
        return target_.resize(gl_, width_px, height_px);
    }

    Result<std::vector<uint8_t>> read_back() override {
        if (Status status = make_current(); !status) return std::move(status).error();
        return read_rgba8(gl_, width_px(), height_px());
    }

private:
    OffscreenSurface(std::string kind, Context context, Gl gl, const OffscreenTarget &target)
        : kind_(std::move(kind)), context_(std::move(context)), gl_(std::move(gl)), target_(target) {}

    std::string kind_;
    Context context_;
    Gl gl_;
    OffscreenTarget target_;
};

} // namespace glint::gles
