// Leaving a context as it was found: each class here notes a part of the state, and puts it back when it goes.
#pragma once

#include <array>
#include <vector>

#include "gles/gl.hpp"

namespace glint::gles {

/// The 2D texture bound to the active unit.
class SavedTexture {
public:
    explicit SavedTexture(const Gl &gl);
    ~SavedTexture();
    SavedTexture(const SavedTexture &) = delete;
    SavedTexture &operator=(const SavedTexture &) = delete;

private:
    const Gl &gl_;
    GLuint texture_;
};

/// How rows of pixels lie in memory. Sets them to follow each other without gaps, in client memory.
class TightRows {
public:
    enum class Direction {
        unpack, ///< from memory to a texture
        pack,   ///< from the framebuffer to memory
    };
    TightRows(const Gl &gl, Direction direction);
    ~TightRows();
    TightRows(const TightRows &) = delete;
    TightRows &operator=(const TightRows &) = delete;

private:
    struct Parameter {
        GLenum name;
        GLint tight; ///< the value for rows without gaps
        GLint before;
    };
    [[nodiscard]] size_t parameter_count() const;

    const Gl &gl_;
    std::array<Parameter, 4> parameters_;
    GLenum buffer_target_;
    GLuint buffer_ = 0;
};

/// Where vertices come from: the vertex array object, or, where contexts have none, the attributes themselves. The
/// buffer bound to GL_ARRAY_BUFFER in either case.
class SavedVertices {
public:
    explicit SavedVertices(const Gl &gl);
    ~SavedVertices();
    SavedVertices(const SavedVertices &) = delete;
    SavedVertices &operator=(const SavedVertices &) = delete;

private:
    /// Attribute 0's array; the presenter uses no other.
    struct AttributeArray {
        GLint buffer = 0, size = 4, type = GL_FLOAT, normalized = GL_FALSE, stride = 0;
        void *pointer = nullptr;
    };
    void save_attributes();
    void restore_attributes();

    const Gl &gl_;
    GLuint array_buffer_;
    GLuint vertex_array_ = 0;
    AttributeArray first_attribute_;
    std::vector<GLuint> enabled_attributes_;
};

/// All that decides where and how triangles land: program, texture unit 0, viewport, tests, masks and blending. Turns
/// off everything that could keep a fragment from arriving as it is.
class SavedDrawState {
public:
    explicit SavedDrawState(const Gl &gl);
    ~SavedDrawState();
    SavedDrawState(const SavedDrawState &) = delete;
    SavedDrawState &operator=(const SavedDrawState &) = delete;

private:
    void save_capabilities();
    void save_texture_unit();
    void restore_texture_unit();

    const Gl &gl_;
    GLuint program_;
    GLuint active_texture_;
    GLuint texture_ = 0;
    GLuint sampler_ = 0;
    std::array<GLint, 4> viewport_;
    std::array<GLboolean, 4> color_mask_;
    std::vector<GLenum> enabled_;
};

/// How colours are blended, for blending that it turns on. Within the life of a SavedDrawState, which has turned it
/// off.
class SavedBlending {
public:
    /// Blends with `source` * the picture's colour + (1 - its alpha) * what is there; alphas add up as coverages do.
    SavedBlending(const Gl &gl, GLenum source);
    ~SavedBlending();
    SavedBlending(const SavedBlending &) = delete;
    SavedBlending &operator=(const SavedBlending &) = delete;

private:
    const Gl &gl_;
    std::array<GLenum, 4> functions_; ///< of source and destination: colour; alpha
    std::array<GLenum, 2> equations_; ///< of colour, of alpha
};

} // namespace glint::gles
