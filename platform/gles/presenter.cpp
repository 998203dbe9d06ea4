// Uploading a picture to a texture, and drawing the texture on two triangles.
#include <glint/gles/presenter.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "gles/program.hpp"
#include "gles/saved_state.hpp"
#include "gles/size_text.hpp"
#include "gles/texel_format.hpp"

namespace glint::gles {

namespace {

// Sampler and coordinate ask for full precision where there is: mediump has too few bits to tell the texels of a wide
// picture apart, and Mesa's llvmpipe takes its fast path for highp samplers only.
constexpr const char *vertex_source = R"(#version 100
attribute vec4 corner; // x, y on the screen; s, t in the picture
varying vec2 place;
void main() {
    place = corner.zw;
    gl_Position = vec4(corner.xy, 0.0, 1.0);
}
)";
constexpr const char *fragment_source = R"(#version 100
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
precision highp sampler2D;
#else
precision mediump float;
#endif
uniform sampler2D picture; // stays 0, the first texture unit
varying vec2 place;
void main() {
    gl_FragColor = texture2D(picture, place);
}
)";

// Two triangles over the whole viewport, x y s t each. The picture's first row is at t = 0 and belongs at the top,
// y = 1. Six vertices rather than a strip of four: Mesa's llvmpipe recognises a rectangle in the former only.
constexpr std::array<float, 24> corners = {
    -1, -1, 0, 1, /**/ 1, -1, 1, 1, /**/ 1,  1, 1, 0, //
    -1, -1, 0, 1, /**/ 1, 1,  1, 0, /**/ -1, 1, 0, 0,
};

// Rows whose bytes must change order pass through a buffer: many rows, so that calls do not count, yet few enough to
// stay in a core's own cache.
constexpr size_t staging_bytes = size_t{256} << 10;

} // namespace

struct Presenter::Impl {
    explicit Impl(Gl gl_) : gl(std::move(gl_)), texel(fastest_texel_format(gl)) {}

    Status create_objects();
    void delete_objects();
    void set_vertex_array();
    Status allocate(uint32_t new_width_px, uint32_t new_height_px);
    void transfer(const Framebuffer &picture);
    void transfer_swapped(const Framebuffer &picture);
    void set_filter(GLint new_filter);
    [[nodiscard]] Status check_usable() const;
    [[nodiscard]] Status check_viewport(int width_px, int height_px) const;

    Gl gl;
    TexelFormat texel;
    GLint max_texture_px = 0;
    std::array<GLint, 2> max_viewport_px = {};
    GLuint program = 0;
    GLuint corner_buffer = 0;
    GLuint vertex_array = 0; // stays 0 where contexts have none
    GLuint texture = 0;
    GLint filter = GL_NEAREST;
    uint32_t texture_width_px = 0; // 0 until the texture has storage
    uint32_t texture_height_px = 0;
    std::vector<uint8_t> staging;
    bool has_picture = false;
    bool abandoned = false;
};

Status Presenter::Impl::create_objects() {
    gl.get_integerv(GL_MAX_TEXTURE_SIZE, &max_texture_px);
    gl.get_integerv(GL_MAX_VIEWPORT_DIMS, max_viewport_px.data());
    Result<GLuint> linked = link_program(gl, vertex_source, fragment_source, "corner");
    if (!linked) return std::move(linked).error();
    program = *linked;
    {
        const SavedVertices saved(gl);
        gl.gen_buffers(1, &corner_buffer);
        gl.bind_buffer(GL_ARRAY_BUFFER, corner_buffer);
        gl.buffer_data(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
        if (Status status = gl.check("glBufferData"); !status) return status;
        if (gl.has_gl3_objects) {
            gl.gen_vertex_arrays(1, &vertex_array);
            gl.bind_vertex_array(vertex_array);
            set_vertex_array();
            if (Status status = gl.check("glVertexAttribPointer"); !status) return status;
        }
    }
    const SavedTexture saved(gl);
    gl.gen_textures(1, &texture);
    gl.bind_texture(GL_TEXTURE_2D, texture);
    // OpenGL ES 2.0 samples sizes that are no powers of two with exactly this: no repeating, no smaller levels.
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    return gl.check("glTexParameteri");
}

void Presenter::Impl::delete_objects() {
    // Names that are 0 are ignored by OpenGL.
    gl.delete_textures(1, &texture);
    gl.delete_buffers(1, &corner_buffer);
    if (gl.has_gl3_objects) gl.delete_vertex_arrays(1, &vertex_array);
    gl.delete_program(program);
}

/// Attribute 0 reads the corners. The corner buffer must be bound.
void Presenter::Impl::set_vertex_array() {
    gl.vertex_attrib_pointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.enable_vertex_attrib_array(0);
}

Status Presenter::Impl::check_usable() const {
    if (abandoned) return Error(ErrorCode::unsupported, "the presenter's context is gone, expected a new presenter");
    return gl.check_nothing_pending();
}

/// OpenGL would cut the rectangle to the limit without a word, and show a scaled picture.
Status Presenter::Impl::check_viewport(int width_px, int height_px) const {
    if (width_px < 0 || height_px < 0) {
        return Error(ErrorCode::bad_input,
                     "a rectangle of " + size_text(width_px, height_px) + " pixels, expected no negative sizes");
    }
    if (width_px > max_viewport_px[0] || height_px > max_viewport_px[1]) {
        return Error(ErrorCode::limit_exceeded,
                     "a rectangle of " + size_text(width_px, height_px) + " pixels, expected at most " +
                         size_text(max_viewport_px[0], max_viewport_px[1]) + " on this context");
    }
    return Done{};
}

/// Makes storage for a picture of that size. The texture must be bound.
Status Presenter::Impl::allocate(uint32_t new_width_px, uint32_t new_height_px) {
    if (new_width_px == texture_width_px && new_height_px == texture_height_px) return Done{};
    const auto largest = static_cast<uint32_t>(max_texture_px);
    if (new_width_px > largest || new_height_px > largest) {
        return Error(ErrorCode::limit_exceeded, "a picture of " + size_text(new_width_px, new_height_px) +
                                                    " pixels, expected at most " + size_text(largest, largest) +
                                                    " in a texture of this context");
    }
    texture_width_px = 0;
    texture_height_px = 0;
    has_picture = false;
    gl.tex_image_2d(GL_TEXTURE_2D, 0, texel.internal_format, static_cast<GLsizei>(new_width_px),
                    static_cast<GLsizei>(new_height_px), 0, texel.format, GL_UNSIGNED_BYTE, nullptr);
    if (Status status = gl.check("glTexImage2D"); !status) return status;
    if (texel.red_blue_swapped) {
        const size_t row_bytes = size_t{new_width_px} * 4;
        staging.resize(std::max(row_bytes, staging_bytes / row_bytes * row_bytes));
    }
    texture_width_px = new_width_px;
    texture_height_px = new_height_px;
    return Done{};
}

/// Fills the bound texture, which has the picture's size.
void Presenter::Impl::transfer(const Framebuffer &picture) {
    if (texel.red_blue_swapped) return transfer_swapped(picture);
    gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(texture_width_px),
                        static_cast<GLsizei>(texture_height_px), texel.format, GL_UNSIGNED_BYTE, picture.rgba8());
}

void Presenter::Impl::transfer_swapped(const Framebuffer &picture) {
    const size_t row_bytes = picture.rgba8_stride_bytes();
    const auto rows_at_once = static_cast<uint32_t>(staging.size() / row_bytes);
    for (uint32_t y = 0; y < texture_height_px; y += rows_at_once) {
        const uint32_t rows = std::min(rows_at_once, texture_height_px - y);
        copy_red_blue_swapped(picture.rgba8() + y * row_bytes, staging.data(), size_t{rows} * texture_width_px);
        gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(y), static_cast<GLsizei>(texture_width_px),
                            static_cast<GLsizei>(rows), texel.format, GL_UNSIGNED_BYTE, staging.data());
    }
}

/// The texture must be bound.
void Presenter::Impl::set_filter(GLint new_filter) {
    if (new_filter == filter) return;
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, new_filter);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, new_filter);
    filter = new_filter;
}

Result<std::unique_ptr<Presenter>> Presenter::create(const ProcLoader &load) {
    Result<Gl> gl = Gl::load(load);
    if (!gl) return std::move(gl).error();
    // From here on the destructor deletes what there is.
    std::unique_ptr<Presenter> presenter(new Presenter(std::make_unique<Impl>(std::move(gl).value())));
    if (Status status = presenter->impl_->gl.check_nothing_pending(); !status) return std::move(status).error();
    if (Status status = presenter->impl_->create_objects(); !status) return std::move(status).error();
    return presenter;
}

Presenter::Presenter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Presenter::~Presenter() {
    if (!impl_->abandoned) impl_->delete_objects();
}

void Presenter::abandon() {
    impl_->abandoned = true;
}

Status Presenter::upload(const Framebuffer &picture) {
    Impl &impl = *impl_;
    if (Status status = impl.check_usable(); !status) return status;
    const SavedTexture saved_texture(impl.gl);
    const TightRows tight_rows(impl.gl, TightRows::Direction::unpack);
    impl.gl.bind_texture(GL_TEXTURE_2D, impl.texture);
    if (Status status = impl.allocate(picture.width_px(), picture.height_px()); !status) return status;
    impl.transfer(picture);
    if (Status status = impl.gl.check("glTexSubImage2D"); !status) return status;
    impl.has_picture = true;
    return Done{};
}

Status Presenter::draw(int x, int y, int width_px, int height_px) {
    Impl &impl = *impl_;
    if (Status status = impl.check_usable(); !status) return status;
    if (!impl.has_picture) {
        return Error(ErrorCode::bad_input, "there is nothing to draw yet, expected an upload() before draw()");
    }
    if (Status status = impl.check_viewport(width_px, height_px); !status) return status;
    if (width_px == 0 || height_px == 0) return Done{};

    const SavedDrawState saved_state(impl.gl);
    const SavedVertices saved_vertices(impl.gl);
    impl.gl.viewport(x, y, width_px, height_px);
    impl.gl.use_program(impl.program);
    impl.gl.bind_texture(GL_TEXTURE_2D, impl.texture);
    const bool same_size = static_cast<uint32_t>(width_px) == impl.texture_width_px &&
                           static_cast<uint32_t>(height_px) == impl.texture_height_px;
    impl.set_filter(same_size ? GL_NEAREST : GL_LINEAR);
    if (impl.gl.has_gl3_objects) {
        impl.gl.bind_vertex_array(impl.vertex_array);
    } else {
        impl.gl.bind_buffer(GL_ARRAY_BUFFER, impl.corner_buffer);
        impl.set_vertex_array();
    }
    impl.gl.draw_arrays(GL_TRIANGLES, 0, 6);
    return impl.gl.check("glDrawArrays");
}

} // namespace glint::gles
