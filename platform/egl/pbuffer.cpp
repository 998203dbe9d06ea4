// A surface that is an EGL pbuffer.
#include <glint/egl/surface.hpp>

#include <array>
#include <utility>

#include "egl/context.hpp"
#include "gles/offscreen_target.hpp"
#include "gles/size_text.hpp"

namespace glint::egl {

namespace {

/// An EGL pbuffer and its size.
struct Pbuffer {
    EGLSurface surface = EGL_NO_SURFACE;
    uint32_t width_px = 0;
    uint32_t height_px = 0;
};

Result<Pbuffer> create_pbuffer_of(const Context &context, uint32_t width_px, uint32_t height_px) {
    constexpr uint32_t largest_px = INT32_MAX;
    if (width_px == 0 || height_px == 0) {
        return Error(ErrorCode::bad_input,
                     "a surface of " + gles::size_text(width_px, height_px) + " pixels, expected at least 1 x 1");
    }
    if (width_px > largest_px || height_px > largest_px) {
        return Error(ErrorCode::limit_exceeded, "a surface of " + gles::size_text(width_px, height_px) + " pixels");
    }
    const std::array<EGLint, 5> attributes = {EGL_WIDTH, static_cast<EGLint>(width_px), EGL_HEIGHT,
                                              static_cast<EGLint>(height_px), EGL_NONE};
    const Egl &egl = context.egl();
    const EGLSurface surface = egl.create_pbuffer_surface(context.display(), context.config(), attributes.data());
    if (surface == EGL_NO_SURFACE) return egl.error("eglCreatePbufferSurface");
    return Pbuffer{surface, width_px, height_px};
}

class PbufferSurface final : public gles::Surface {
public:
    PbufferSurface(Context context, gles::Gl gl, Pbuffer pbuffer)
        : context_(std::move(context)), gl_(std::move(gl)), pbuffer_(pbuffer) {}

    ~PbufferSurface() override { destroy(pbuffer_); }

    [[nodiscard]] std::string kind() const override { return "egl-pbuffer"; }
    [[nodiscard]] std::string gl_description() const override { return gl_.description(); }
    [[nodiscard]] uint32_t width_px() const override { return pbuffer_.width_px; }
    [[nodiscard]] uint32_t height_px() const override { return pbuffer_.height_px; }
    [[nodiscard]] gles::ProcLoader proc_loader() const override { return context_.proc_loader(); }
    void finish() override { gl_.finish(); }

    Status make_current() override { return make_current_with(pbuffer_); }

    Status resize(uint32_t width_px, uint32_t height_px) override {
        if (Status status = make_current(); !status) return status;
        if (Status status = gles::check_surface_size(gl_, width_px, height_px); !status) return status;
        Result<Pbuffer> resized = create_pbuffer_of(context_, width_px, height_px);
        if (!resized) return std::move(resized).error();
        if (Status status = make_current_with(*resized); !status) {
            destroy(*resized);
            return status;
        }
        destroy(std::exchange(pbuffer_, *resized));
        return Done{};
    }

    Result<std::vector<uint8_t>> read_back() override {
        if (Status status = make_current(); !status) return std::move(status).error();
        return gles::read_rgba8(gl_, width_px(), height_px());
    }

private:
    Status make_current_with(const Pbuffer &pbuffer) {
        if (Status status = context_.make_current(pbuffer.surface); !status) return status;
        gl_.bind_framebuffer(GL_FRAMEBUFFER, 0);
        return Done{};
    }

    // EGL keeps a surface that is still current until it no longer is.
    void destroy(const Pbuffer &pbuffer) { context_.egl().destroy_surface(context_.display(), pbuffer.surface); }

    Context context_;
    gles::Gl gl_;
    Pbuffer pbuffer_;
};

} // namespace

Result<std::unique_ptr<gles::Surface>> create_pbuffer(uint32_t width_px, uint32_t height_px) {
    Result<Egl> egl = Egl::load();
    if (!egl) return std::move(egl).error();
    Result<Context> context = Context::create(*egl);
    if (!context) return std::move(context).error();
    // Which sizes the context takes is known once it is current, so it starts with the smallest pbuffer.
    Result<Pbuffer> smallest = create_pbuffer_of(*context, 1, 1);
    if (!smallest) return std::move(smallest).error();
    Status current = context->make_current(smallest->surface);
    Result<gles::Gl> gl = current ? gles::Gl::load(context->proc_loader()) : std::move(current).error();
    if (!gl) {
        egl->destroy_surface(context->display(), smallest->surface);
        return std::move(gl).error();
    }
    auto surface = std::make_unique<PbufferSurface>(std::move(context).value(), std::move(gl).value(), *smallest);
    if (Status status = surface->resize(width_px, height_px); !status) return std::move(status).error();
    return std::unique_ptr<gles::Surface>(std::move(surface));
}

} // namespace glint::egl
