// The ways that OpenGL ES has to put a picture on a surface, each timed.
#include "bench/presenting/ways.hpp"

#include <array>
#include <chrono>
#include <cstring>
#include <utility>

#include "gles/gl.hpp"
#include "gles/program.hpp"
#include "gles/shaders.hpp"
#include "gles/texel_format.hpp"

namespace glint::bench {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Functions of OpenGL ES 3 that only these ways call.
struct Gl3 {
    explicit Gl3(const gles::ProcLoader &load)
        : map_buffer_range(reinterpret_cast<PFNGLMAPBUFFERRANGEPROC>(load("glMapBufferRange"))),
          unmap_buffer(reinterpret_cast<PFNGLUNMAPBUFFERPROC>(load("glUnmapBuffer"))),
          blit_framebuffer(reinterpret_cast<PFNGLBLITFRAMEBUFFERPROC>(load("glBlitFramebuffer"))) {}

    PFNGLMAPBUFFERRANGEPROC map_buffer_range;
    PFNGLUNMAPBUFFERPROC unmap_buffer;
    PFNGLBLITFRAMEBUFFERPROC blit_framebuffer;
};

/// x y on the screen, s t in the picture, as the presenter has them.
constexpr std::array<float, 24> six_corners = {-1, -1, 0, 1, 1, -1, 1, 1, 1,  1, 1, 0,
                                               -1, -1, 0, 1, 1, 1,  1, 0, -1, 1, 0, 0};
constexpr std::array<float, 16> strip_corners = {-1, -1, 0, 1, 1, -1, 1, 1, -1, 1, 0, 0, 1, 1, 1, 0};
constexpr std::array<float, 12> large_corners = {-1, -1, 0, 1, 3, -1, 2, 1, -1, 3, 0, -1};

/// One way, with the OpenGL objects it needs. Leaves the context's state as it likes: nobody else draws meanwhile.
class Way {
public:
    Way(const gles::Gl &gl, const Gl3 &gl3, UploadWay upload, DrawWay draw, const Framebuffer &picture)
        : gl_(gl), gl3_(gl3), upload_(upload), draw_(draw), picture_(picture) {}
    ~Way() {
        gl_.bind_framebuffer(GL_FRAMEBUFFER, surface_framebuffer_);
        if (buffered()) gl_.bind_buffer(GL_PIXEL_UNPACK_BUFFER, 0);
        gl_.delete_textures(1, &texture_);
        gl_.delete_buffers(1, &vertices_);
        gl_.delete_buffers(1, &pixels_);
        gl_.delete_framebuffers(1, &read_framebuffer_);
        if (gl_.has_gl3_objects) gl_.delete_vertex_arrays(1, &vertex_array_);
        if (program_ != 0) gl_.delete_program(program_);
    }
    Way(const Way &) = delete;
    Way &operator=(const Way &) = delete;

    /// Why it cannot be done in this context; empty where it can.
    [[nodiscard]] std::string missing() const {
        const bool has_bgra = !gl_.is_es || gl_.has_es_extension("GL_EXT_texture_format_BGRA8888");
        if (swapped() && !has_bgra) return "no BGRA textures";
        const bool needs_gl3 = buffered() || draw_ == DrawWay::blit;
        return needs_gl3 && !gl_.has_gl3_objects ? "needs OpenGL ES 3" : "";
    }

    Status prepare() {
        surface_framebuffer_ = static_cast<GLuint>(gl_.integer(GL_FRAMEBUFFER_BINDING));
        gl_.viewport(0, 0, width(), height());
        make_texture();
        staging_.resize(byte_count());
        if (buffered()) gl_.gen_buffers(1, &pixels_);
        if (draw_ == DrawWay::blit) {
            gl_.gen_framebuffers(1, &read_framebuffer_);
            gl_.bind_framebuffer(GL_READ_FRAMEBUFFER, read_framebuffer_);
            gl_.framebuffer_texture_2d(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
            return gl_.check("glFramebufferTexture2D");
        }
        const std::string fragment = std::string(gles::fragment_head) + gles::plain_fragment_source;
        Result<GLuint> program = gles::link_program(gl_, gles::vertex_source, fragment.c_str(), "corner");
        if (!program) return program.error();
        program_ = *program;
        gl_.use_program(program_);
        make_vertices();
        return gl_.check("glVertexAttribPointer");
    }

    void upload() {
        if (buffered()) return upload_buffered();
        const uint8_t *from = picture_.rgba8();
        if (swapped()) {
            gles::copy_red_blue_swapped(from, staging_.data(), byte_count() / 4);
            from = staging_.data();
        }
        gl_.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, width(), height(), format(), GL_UNSIGNED_BYTE, from);
    }

    void draw() {
        switch (draw_) {
        case DrawWay::six_vertices:
            return gl_.draw_arrays(GL_TRIANGLES, 0, 6);
        case DrawWay::strip:
            return gl_.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        case DrawWay::one_triangle:
            return gl_.draw_arrays(GL_TRIANGLES, 0, 3);
        case DrawWay::blit:
            return gl3_.blit_framebuffer(0, 0, width(), height(), 0, height(), width(), 0, GL_COLOR_BUFFER_BIT,
                                         GL_NEAREST);
        }
    }

private:
    [[nodiscard]] bool swapped() const { return upload_ == UploadWay::bgra || upload_ == UploadWay::bgra_buffer; }
    [[nodiscard]] bool buffered() const {
        return upload_ == UploadWay::rgba_buffer || upload_ == UploadWay::bgra_buffer;
    }
    [[nodiscard]] GLsizei width() const { return static_cast<GLsizei>(picture_.width_px()); }
    [[nodiscard]] GLsizei height() const { return static_cast<GLsizei>(picture_.height_px()); }
    [[nodiscard]] size_t byte_count() const { return picture_.rgba8_stride_bytes() * picture_.height_px(); }
    [[nodiscard]] GLenum format() const { return swapped() ? GL_BGRA_EXT : GL_RGBA; }

    void make_texture() {
        gl_.gen_textures(1, &texture_);
        gl_.bind_texture(GL_TEXTURE_2D, texture_);
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        // A desktop context has no BGRA internal format.
        const GLint internal_format = swapped() && gl_.is_es ? GL_BGRA_EXT : GL_RGBA;
        gl_.tex_image_2d(GL_TEXTURE_2D, 0, internal_format, width(), height(), 0, format(), GL_UNSIGNED_BYTE, nullptr);
    }

    void make_vertices() {
        if (gl_.has_gl3_objects) {
            gl_.gen_vertex_arrays(1, &vertex_array_);
            gl_.bind_vertex_array(vertex_array_);
        }
        gl_.gen_buffers(1, &vertices_);
        gl_.bind_buffer(GL_ARRAY_BUFFER, vertices_);
        const auto fill = [this](const auto &corners) {
            gl_.buffer_data(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
        };
        if (draw_ == DrawWay::six_vertices) fill(six_corners);
        if (draw_ == DrawWay::strip) fill(strip_corners);
        if (draw_ == DrawWay::one_triangle) fill(large_corners);
        gl_.vertex_attrib_pointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl_.enable_vertex_attrib_array(0);
    }

    void upload_buffered() {
        gl_.bind_buffer(GL_PIXEL_UNPACK_BUFFER, pixels_);
        const auto size = static_cast<GLsizeiptr>(byte_count());
        gl_.buffer_data(GL_PIXEL_UNPACK_BUFFER, size, nullptr, GL_STREAM_DRAW);
        void *memory =
            gl3_.map_buffer_range(GL_PIXEL_UNPACK_BUFFER, 0, size, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
        if (memory == nullptr) return; // an error is pending then
        if (swapped()) {
            gles::copy_red_blue_swapped(picture_.rgba8(), static_cast<uint8_t *>(memory), byte_count() / 4);
        } else {
            std::memcpy(memory, picture_.rgba8(), byte_count());
        }
        gl3_.unmap_buffer(GL_PIXEL_UNPACK_BUFFER);
        gl_.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, width(), height(), format(), GL_UNSIGNED_BYTE, nullptr);
        gl_.bind_buffer(GL_PIXEL_UNPACK_BUFFER, 0);
    }

    const gles::Gl &gl_;
    const Gl3 &gl3_;
    UploadWay upload_;
    DrawWay draw_;
    const Framebuffer &picture_;
    GLuint surface_framebuffer_ = 0, texture_ = 0, vertices_ = 0, vertex_array_ = 0, pixels_ = 0, program_ = 0;
    GLuint read_framebuffer_ = 0;
    std::vector<uint8_t> staging_;
};

Status check_shown(gles::Surface &surface, const Framebuffer &picture, const WayTimes &way) {
    const Result<std::vector<uint8_t>> shown = surface.read_back();
    if (!shown) return shown.error();
    if (std::memcmp(shown->data(), picture.rgba8(), shown->size()) == 0) return Done{};
    return Error(ErrorCode::io, "the surface does not show the picture that went to it as " + way_name(way.upload) +
                                    ", " + way_name(way.draw));
}

Status time_way(gles::Surface &surface, const gles::Gl &gl, const Gl3 &gl3, const Framebuffer &picture,
                double min_seconds, WayTimes &times) {
    constexpr size_t min_frames = 10, warm_up = 3;
    {
        Way way(gl, gl3, times.upload, times.draw, picture);
        times.missing = way.missing();
        if (!times.missing.empty()) return Done{};
        if (Status prepared = way.prepare(); !prepared) return prepared;
        Clock::time_point begin = Clock::now();
        for (size_t frame = 0; frame < warm_up + min_frames || ms_since(begin) < 1000.0 * min_seconds; ++frame) {
            const Clock::time_point start = Clock::now();
            way.upload();
            surface.finish();
            const double upload_ms = ms_since(start);
            const Clock::time_point uploaded = Clock::now();
            way.draw();
            surface.finish();
            const double draw_ms = ms_since(uploaded);
            if (frame < warm_up) {
                begin = Clock::now();
                continue;
            }
            times.upload_ms.push_back(upload_ms);
            times.draw_ms.push_back(draw_ms);
        }
        if (Status status = gl.check("a way to show pictures"); !status) return status;
    }
    return check_shown(surface, picture, times);
}

} // namespace

std::string way_name(UploadWay way) {
    constexpr std::array names = {"RGBA", "BGRA", "RGBA buffer", "BGRA buffer"};
    return names[static_cast<size_t>(way)];
}

std::string way_name(DrawWay way) {
    constexpr std::array names = {"six vertices", "strip", "one triangle", "blit"};
    return names[static_cast<size_t>(way)];
}

Result<std::vector<WayTimes>> time_ways(gles::Surface &surface, const Framebuffer &picture, double min_seconds) {
    const Result<gles::Gl> gl = gles::Gl::load(surface.proc_loader());
    if (!gl) return gl.error();
    const Gl3 gl3(surface.proc_loader());
    std::vector<WayTimes> all;
    for (const UploadWay upload : {UploadWay::rgba, UploadWay::bgra, UploadWay::rgba_buffer, UploadWay::bgra_buffer}) {
        for (const DrawWay draw : {DrawWay::six_vertices, DrawWay::strip, DrawWay::one_triangle, DrawWay::blit}) {
            WayTimes &times = all.emplace_back(WayTimes{upload, draw, {}, {}, {}});
            if (Status timed = time_way(surface, *gl, gl3, picture, min_seconds, times); !timed) return timed.error();
        }
    }
    return all;
}

} // namespace glint::bench
