// Loaders that stand in for poorer contexts.
#include "platform/substitutes.hpp"

#include <utility>

namespace glint::test {

namespace {

// OpenGL's functions know no user data; tests run one after another in one thread.
PFNGLGETSTRINGPROC real_get_string = nullptr;

const GLubyte *es2_get_string(GLenum name) {
    switch (name) {
    case GL_VERSION:
        return reinterpret_cast<const GLubyte *>("OpenGL ES 2.0 (a test's)");
    case GL_EXTENSIONS:
        return reinterpret_cast<const GLubyte *>("");
    default:
        return real_get_string(name);
    }
}

} // namespace

gles::ProcLoader with_substitutes(gles::ProcLoader load, Substitutes substitutes) {
    return [load = std::move(load), substitutes = std::move(substitutes)](const char *name) {
        const auto substitute = substitutes.find(name);
        return substitute != substitutes.end() ? substitute->second : load(name);
    };
}

gles::ProcLoader as_es2(const gles::ProcLoader &load) {
    real_get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(load("glGetString"));
    return with_substitutes(load, {{"glGetString", as_proc(es2_get_string)},
                                   {"glBindSampler", nullptr},
                                   {"glBindVertexArray", nullptr},
                                   {"glDeleteVertexArrays", nullptr},
                                   {"glGenVertexArrays", nullptr}});
}

} // namespace glint::test
