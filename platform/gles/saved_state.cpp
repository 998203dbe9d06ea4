// Noting a context's state and putting it back.
#include "gles/saved_state.hpp"

namespace glint::gles {

namespace {

// Of the desktop profile and of OpenGL ES 3.1, hence not in the headers in use.
constexpr GLenum color_logic_op = 0x0BF2;
constexpr GLenum sample_mask = 0x8E51;

GLuint name_of(const Gl &gl, GLenum binding) {
    return static_cast<GLuint>(gl.integer(binding));
}

} // namespace

SavedTexture::SavedTexture(const Gl &gl) : gl_(gl), texture_(name_of(gl, GL_TEXTURE_BINDING_2D)) {}

SavedTexture::~SavedTexture() {
    gl_.bind_texture(GL_TEXTURE_2D, texture_);
}

TightRows::TightRows(const Gl &gl, Direction direction) : gl_(gl) {
    if (direction == Direction::unpack) {
        buffer_target_ = GL_PIXEL_UNPACK_BUFFER;
        parameters_ = {{{GL_UNPACK_ALIGNMENT, 1, 0},
                        {GL_UNPACK_ROW_LENGTH, 0, 0},
                        {GL_UNPACK_SKIP_ROWS, 0, 0},
                        {GL_UNPACK_SKIP_PIXELS, 0, 0}}};
    } else {
        buffer_target_ = GL_PIXEL_PACK_BUFFER;
        parameters_ = {{{GL_PACK_ALIGNMENT, 1, 0},
                        {GL_PACK_ROW_LENGTH, 0, 0},
                        {GL_PACK_SKIP_ROWS, 0, 0},
                        {GL_PACK_SKIP_PIXELS, 0, 0}}};
    }
    for (size_t i = 0; i < parameter_count(); ++i) {
        parameters_[i].before = gl_.integer(parameters_[i].name);
        gl_.pixel_storei(parameters_[i].name, parameters_[i].tight);
    }
    if (gl_.has_gl3_objects) {
        const bool unpack = direction == Direction::unpack;
        buffer_ = name_of(gl_, unpack ? GL_PIXEL_UNPACK_BUFFER_BINDING : GL_PIXEL_PACK_BUFFER_BINDING);
        gl_.bind_buffer(buffer_target_, 0);
    }
}

TightRows::~TightRows() {
    for (size_t i = 0; i < parameter_count(); ++i) gl_.pixel_storei(parameters_[i].name, parameters_[i].before);
    if (gl_.has_gl3_objects) gl_.bind_buffer(buffer_target_, buffer_);
}

// OpenGL ES 2.0 knows the alignment alone (and with GL_EXT_unpack_subimage the others for unpacking).
size_t TightRows::parameter_count() const {
    const bool unpack = buffer_target_ == GL_PIXEL_UNPACK_BUFFER;
    const bool has_rows = unpack ? gl_.has_unpack_rows : gl_.has_gl3_objects;
    return has_rows ? parameters_.size() : 1;
}

SavedVertices::SavedVertices(const Gl &gl) : gl_(gl), array_buffer_(name_of(gl, GL_ARRAY_BUFFER_BINDING)) {
    if (gl_.has_gl3_objects) {
        vertex_array_ = name_of(gl_, GL_VERTEX_ARRAY_BINDING);
    } else {
        save_attributes();
    }
}

SavedVertices::~SavedVertices() {
    if (gl_.has_gl3_objects) {
        gl_.bind_vertex_array(vertex_array_);
    } else {
        restore_attributes();
    }
    gl_.bind_buffer(GL_ARRAY_BUFFER, array_buffer_);
}

void SavedVertices::save_attributes() {
    const auto attribute_count = static_cast<GLuint>(gl_.integer(GL_MAX_VERTEX_ATTRIBS));
    for (GLuint i = 0; i < attribute_count; ++i) {
        GLint enabled = GL_FALSE;
        gl_.get_vertex_attribiv(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
        if (enabled == GL_FALSE) continue;
        // An array that another program uses may be shorter than ours, or gone.
        gl_.disable_vertex_attrib_array(i);
        enabled_attributes_.push_back(i);
    }
    AttributeArray &array = first_attribute_;
    gl_.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &array.buffer);
    gl_.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_SIZE, &array.size);
    gl_.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_TYPE, &array.type);
    gl_.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &array.normalized);
    gl_.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_STRIDE, &array.stride);
    gl_.get_vertex_attrib_pointerv(0, GL_VERTEX_ATTRIB_ARRAY_POINTER, &array.pointer);
}

void SavedVertices::restore_attributes() {
    const AttributeArray &array = first_attribute_;
    gl_.bind_buffer(GL_ARRAY_BUFFER, static_cast<GLuint>(array.buffer));
    gl_.vertex_attrib_pointer(0, array.size, static_cast<GLenum>(array.type), static_cast<GLboolean>(array.normalized),
                              array.stride, array.pointer);
    gl_.disable_vertex_attrib_array(0);
    for (GLuint i : enabled_attributes_) gl_.enable_vertex_attrib_array(i);
}

SavedDrawState::SavedDrawState(const Gl &gl)
    : gl_(gl), program_(name_of(gl, GL_CURRENT_PROGRAM)), active_texture_(name_of(gl, GL_ACTIVE_TEXTURE)) {
    gl_.get_integerv(GL_VIEWPORT, viewport_.data());
    gl_.get_booleanv(GL_COLOR_WRITEMASK, color_mask_.data());
    gl_.color_mask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    save_capabilities();
    save_texture_unit();
}

SavedDrawState::~SavedDrawState() {
    restore_texture_unit();
    for (GLenum capability : enabled_) gl_.enable(capability);
    gl_.color_mask(color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
    gl_.viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    gl_.use_program(program_);
}

void SavedDrawState::save_capabilities() {
    const auto turn_off = [this](GLenum capability) {
        if (gl_.is_enabled(capability) == GL_FALSE) return;
        enabled_.push_back(capability);
        gl_.disable(capability);
    };
    for (GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_SAMPLE_ALPHA_TO_COVERAGE,
                              GL_SAMPLE_COVERAGE, GL_SCISSOR_TEST, GL_STENCIL_TEST}) {
        turn_off(capability);
    }
    if (gl_.has_gl3_objects) turn_off(GL_RASTERIZER_DISCARD);
    if (gl_.has_sample_mask) turn_off(sample_mask);
    if (gl_.has_srgb_switch) turn_off(GL_FRAMEBUFFER_SRGB_EXT);
    if (!gl_.is_es) turn_off(color_logic_op);
}

void SavedDrawState::save_texture_unit() {
    gl_.active_texture(GL_TEXTURE0);
    texture_ = name_of(gl_, GL_TEXTURE_BINDING_2D);
    if (!gl_.has_gl3_objects) return;
    // A sampler object would overrule the texture's own filter.
    sampler_ = name_of(gl_, GL_SAMPLER_BINDING);
    gl_.bind_sampler(0, 0);
}

void SavedDrawState::restore_texture_unit() {
    gl_.bind_texture(GL_TEXTURE_2D, texture_);
    if (gl_.has_gl3_objects) gl_.bind_sampler(0, sampler_);
    gl_.active_texture(active_texture_);
}

SavedBlending::SavedBlending(const Gl &gl, GLenum source) : gl_(gl) {
    const auto value = [&gl](GLenum name) { return static_cast<GLenum>(gl.integer(name)); };
    functions_ = {value(GL_BLEND_SRC_RGB), value(GL_BLEND_DST_RGB), value(GL_BLEND_SRC_ALPHA),
                  value(GL_BLEND_DST_ALPHA)};
    equations_ = {value(GL_BLEND_EQUATION_RGB), value(GL_BLEND_EQUATION_ALPHA)};
    gl_.blend_func_separate(source, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.blend_equation_separate(GL_FUNC_ADD, GL_FUNC_ADD);
    gl_.enable(GL_BLEND);
}

SavedBlending::~SavedBlending() {
    gl_.disable(GL_BLEND);
    gl_.blend_equation_separate(equations_[0], equations_[1]);
    gl_.blend_func_separate(functions_[0], functions_[1], functions_[2], functions_[3]);
}

} // namespace glint::gles
