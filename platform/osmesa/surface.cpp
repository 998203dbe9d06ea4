// A surface made by OSMesa: a software context that draws into its own texture.
#include <glint/osmesa/surface.hpp>

#include <array>
#include <utility>

#include "gles/offscreen_surface.hpp"
#include "osmesa/library.hpp"

namespace glint::osmesa {

namespace {

/// Owns an OSMesa context. OSMesa insists on memory to draw into, which it would fill at every flush; one pixel
/// keeps it content, and pictures go to a framebuffer object, which is also several times as fast.
class Context {
public:
    static Result<Context> create(const OsMesa &mesa) {
        const std::array<int, 13> attributes = {OsMesa::format,
                                                GL_RGBA,
                                                OsMesa::depth_bits,
                                                0,
                                                OsMesa::stencil_bits,
                                                0,
                                                OsMesa::profile,
                                                OsMesa::core_profile,
                                                OsMesa::context_major_version,
                                                3,
                                                OsMesa::context_minor_version,
                                                3,
                                                0};
        const OsMesa::Context context = mesa.create_context_attribs(attributes.data(), nullptr);
        if (context == nullptr) {
            return Error(ErrorCode::unsupported,
                         "OSMesaCreateContextAttribs failed: no context for the OpenGL 3.3 core profile");
        }
        return Context(mesa, context);
    }

    ~Context() {
        if (context_ == nullptr) return;
        // Only where it is this one: a context that another library has made current here must stay so.
        if (mesa_.get_current_context() == context_) mesa_.make_current(nullptr, nullptr, 0, 0, 0);
        mesa_.destroy_context(context_);
    }

    Context(Context &&other) noexcept
        : mesa_(other.mesa_), context_(std::exchange(other.context_, nullptr)), pixel_(std::move(other.pixel_)) {}
    Context &operator=(Context &&) = delete;

    Status make_current() {
        if (mesa_.make_current(context_, pixel_->data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE) return Done{};
        return Error(ErrorCode::unsupported, "OSMesaMakeCurrent failed");
    }

    [[nodiscard]] gles::ProcLoader proc_loader() const {
        return [get_proc_address = mesa_.get_proc_address](const char *name) {
            return reinterpret_cast<void *>(get_proc_address(name));
        };
    }

private:
    using Pixel = std::array<uint8_t, 4>;
    Context(const OsMesa &mesa, OsMesa::Context context) : mesa_(mesa), context_(context) {}

    OsMesa mesa_;
    OsMesa::Context context_;
    std::unique_ptr<Pixel> pixel_ = std::make_unique<Pixel>(); // OSMesa keeps its address
};

} // namespace

Result<std::unique_ptr<gles::Surface>> create(uint32_t width_px, uint32_t height_px) {
    Result<OsMesa> mesa = OsMesa::load();
    if (!mesa) return std::move(mesa).error();
    Result<Context> context = Context::create(*mesa);
    if (!context) return std::move(context).error();
    return gles::OffscreenSurface<Context>::create("osmesa", std::move(context).value(), width_px, height_px);
}

} // namespace glint::osmesa
