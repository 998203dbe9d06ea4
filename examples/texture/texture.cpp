// Renders into a texture that belongs to the program, in an EGL context that belongs to the program, too:
// texture SCENE PICTURE.pam, which is what is in the texture then.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <glint/glint.hpp>

namespace {

constexpr int width_px = 320, height_px = 240;

/// Any context will do; this one has no window.
bool make_context_current() {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_ES_API)) return false;
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return false;
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

GLuint make_texture() {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width_px, height_px);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); // there is one level
    return texture;
}

/// What the texture holds, its first row first.
std::vector<uint8_t> read_back(GLuint texture) {
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    std::vector<uint8_t> rgba8(size_t{4} * width_px * height_px);
    glReadPixels(0, 0, width_px, height_px, GL_RGBA, GL_UNSIGNED_BYTE, rgba8.data());
    glDeleteFramebuffers(1, &framebuffer);
    return rgba8;
}

} // namespace

int main(int, char **arguments) {
    if (!make_context_current()) return std::puts("no OpenGL ES 3 without a window"), 1;
    const GLuint texture = make_texture();

    const auto file = glint::read_scene(arguments[1]);
    if (!file) return std::puts(file.error().text().c_str()), 1;
    glint::Renderer renderer(glint::Accel::build(file->scene));
    auto picture = glint::Framebuffer::create(width_px, height_px, false); // the bytes alone
    if (!picture || !renderer.render(*picture)) return 1;

    // Row 0 is the picture's top: so its top is at the texture coordinate t = 0, whatever draws it must turn it over.
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_px, height_px, GL_RGBA, GL_UNSIGNED_BYTE, picture->rgba8());

    const std::vector<uint8_t> rgba8 = read_back(texture);
    std::FILE *out = std::fopen(arguments[2], "wb");
    if (!out || glGetError() != GL_NO_ERROR) return 1;
    std::fprintf(out, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", width_px,
                 height_px);
    std::fwrite(rgba8.data(), 1, rgba8.size(), out);
    return std::fclose(out) == 0 ? 0 : 1;
}
