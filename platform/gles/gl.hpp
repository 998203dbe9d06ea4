// The OpenGL ES entry points that this room calls, and what the current context can do.
#pragma once

#include <string>

#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

// Every entry point is loaded at run time: no prototypes, so that none is linked by accident.
#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl3.h>
// After gl3.h, whose types it uses.
#include <GLES2/gl2ext.h>

namespace glint::gles {

/// One context's functions and facts. Plain data; copies are as good as the original while the context lives.
struct Gl {
    /// Loads everything from the context that is current. Fails with `unsupported` when none is, or when it lacks
    /// functions of OpenGL ES 2.0.
    [[nodiscard]] static Result<Gl> load(const ProcLoader &load_proc);

    /// Fails with what glGetError has to say after `call` ("glTexImage2D").
    [[nodiscard]] Status check(const char *call) const;
    /// Fails with, and clears, errors that calls of others left behind.
    [[nodiscard]] Status check_nothing_pending() const;
    /// Whether the context has said that it is lost, here or as an error that was checked for; never where contexts
    /// cannot tell.
    [[nodiscard]] bool is_lost() const;
    [[nodiscard]] GLint integer(GLenum name) const;
    /// "GL_VERSION, GL_RENDERER".
    [[nodiscard]] std::string description() const { return version + ", " + renderer; }
    /// Whether an OpenGL ES extension is there; the desktop's are not looked at.
    [[nodiscard]] bool has_es_extension(const char *name) const;

    std::string version;          ///< GL_VERSION
    std::string renderer;         ///< GL_RENDERER
    std::string extensions;       ///< of OpenGL ES, separated by spaces; empty on a desktop context
    bool is_es = false;           ///< OpenGL ES rather than a desktop profile
    int version_number = 0;       ///< 10 * major + minor
    bool has_gl3_objects = false; ///< vertex arrays, samplers, pixel buffers and row lengths: ES 3.0, desktop 3.3
    bool has_sample_mask = false; ///< GL_SAMPLE_MASK can be switched
    bool has_srgb_switch = false; ///< GL_FRAMEBUFFER_SRGB can be switched
    bool has_unpack_rows = false; ///< GL_UNPACK_ROW_LENGTH and its like

    PFNGLACTIVETEXTUREPROC active_texture = nullptr;
    PFNGLATTACHSHADERPROC attach_shader = nullptr;
    PFNGLBINDATTRIBLOCATIONPROC bind_attrib_location = nullptr;
    PFNGLBINDBUFFERPROC bind_buffer = nullptr;
    PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = nullptr;
    PFNGLBINDTEXTUREPROC bind_texture = nullptr;
    PFNGLBLENDEQUATIONSEPARATEPROC blend_equation_separate = nullptr;
    PFNGLBLENDFUNCSEPARATEPROC blend_func_separate = nullptr;
    PFNGLBUFFERDATAPROC buffer_data = nullptr;
    PFNGLCHECKFRAMEBUFFERSTATUSPROC check_framebuffer_status = nullptr;
    PFNGLCOLORMASKPROC color_mask = nullptr;
    PFNGLCOMPILESHADERPROC compile_shader = nullptr;
    PFNGLCREATEPROGRAMPROC create_program = nullptr;
    PFNGLCREATESHADERPROC create_shader = nullptr;
    PFNGLDELETEBUFFERSPROC delete_buffers = nullptr;
    PFNGLDELETEFRAMEBUFFERSPROC delete_framebuffers = nullptr;
    PFNGLDELETEPROGRAMPROC delete_program = nullptr;
    PFNGLDELETESHADERPROC delete_shader = nullptr;
    PFNGLDELETETEXTURESPROC delete_textures = nullptr;
    PFNGLDISABLEPROC disable = nullptr;
    PFNGLDISABLEVERTEXATTRIBARRAYPROC disable_vertex_attrib_array = nullptr;
    PFNGLDRAWARRAYSPROC draw_arrays = nullptr;
    PFNGLENABLEPROC enable = nullptr;
    PFNGLENABLEVERTEXATTRIBARRAYPROC enable_vertex_attrib_array = nullptr;
    PFNGLFINISHPROC finish = nullptr;
    PFNGLFRAMEBUFFERTEXTURE2DPROC framebuffer_texture_2d = nullptr;
    PFNGLGENBUFFERSPROC gen_buffers = nullptr;
    PFNGLGENFRAMEBUFFERSPROC gen_framebuffers = nullptr;
    PFNGLGENTEXTURESPROC gen_textures = nullptr;
    PFNGLGETBOOLEANVPROC get_booleanv = nullptr;
    PFNGLGETERRORPROC get_error = nullptr;
    PFNGLGETINTEGERVPROC get_integerv = nullptr;
    PFNGLGETPROGRAMINFOLOGPROC get_program_info_log = nullptr;
    PFNGLGETPROGRAMIVPROC get_programiv = nullptr;
    PFNGLGETSHADERINFOLOGPROC get_shader_info_log = nullptr;
    PFNGLGETSHADERIVPROC get_shaderiv = nullptr;
    PFNGLGETSTRINGPROC get_string = nullptr;
    PFNGLGETUNIFORMLOCATIONPROC get_uniform_location = nullptr;
    PFNGLGETVERTEXATTRIBIVPROC get_vertex_attribiv = nullptr;
    PFNGLGETVERTEXATTRIBPOINTERVPROC get_vertex_attrib_pointerv = nullptr;
    PFNGLISENABLEDPROC is_enabled = nullptr;
    PFNGLLINKPROGRAMPROC link_program = nullptr;
    PFNGLPIXELSTOREIPROC pixel_storei = nullptr;
    PFNGLREADPIXELSPROC read_pixels = nullptr;
    PFNGLSHADERSOURCEPROC shader_source = nullptr;
    PFNGLTEXIMAGE2DPROC tex_image_2d = nullptr;
    PFNGLTEXPARAMETERIPROC tex_parameteri = nullptr;
    PFNGLTEXSUBIMAGE2DPROC tex_sub_image_2d = nullptr;
    PFNGLUNIFORM2FPROC uniform_2f = nullptr;
    PFNGLUSEPROGRAMPROC use_program = nullptr;
    PFNGLVERTEXATTRIBPOINTERPROC vertex_attrib_pointer = nullptr;
    PFNGLVIEWPORTPROC viewport = nullptr;

    // Set where has_gl3_objects.
    PFNGLBINDSAMPLERPROC bind_sampler = nullptr;
    PFNGLBINDVERTEXARRAYPROC bind_vertex_array = nullptr;
    PFNGLDELETEVERTEXARRAYSPROC delete_vertex_arrays = nullptr;
    PFNGLGENVERTEXARRAYSPROC gen_vertex_arrays = nullptr;

    // Set where the context tells whether it is lost.
    PFNGLGETGRAPHICSRESETSTATUSEXTPROC get_graphics_reset_status = nullptr;

private:
    [[nodiscard]] GLenum next_error() const;
    mutable bool lost_ = false; // contexts may say so only once
};

/// "GL_INVALID_VALUE" and the like; other codes in hexadecimal.
[[nodiscard]] std::string error_name(GLenum code);

} // namespace glint::gles
