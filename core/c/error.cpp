// Codes, messages, and what became of an exception.
#include <glint/error.h>

#include <exception>

#include "c/handle.hpp"

namespace glint {

glint_error code_of(ErrorCode code) noexcept {
    switch (code) {
    case ErrorCode::bad_input:
        return GLINT_ERROR_BAD_INPUT;
    case ErrorCode::not_found:
        return GLINT_ERROR_NOT_FOUND;
    case ErrorCode::limit_exceeded:
        return GLINT_ERROR_LIMIT_EXCEEDED;
    case ErrorCode::io:
        return GLINT_ERROR_IO;
    case ErrorCode::unsupported:
        return GLINT_ERROR_UNSUPPORTED;
    case ErrorCode::out_of_memory:
        return GLINT_ERROR_OUT_OF_MEMORY;
    case ErrorCode::cancelled:
        return GLINT_ERROR_CANCELLED;
    }
    return GLINT_ERROR_INTERNAL;
}

glint_error Handle::fail(glint_error code, const char *message) noexcept {
    message_ = message;
    return code;
}

glint_error Handle::fail(const Error &error) noexcept {
    try {
        text_ = error.text();
        return fail(code_of(error.code), text_.c_str());
    } catch (...) {
        return fail_by_exception();
    }
}

glint_error Handle::fail_by_exception() noexcept {
    try {
        throw;
    } catch (const std::bad_alloc &) {
        return fail(GLINT_ERROR_OUT_OF_MEMORY, "out of memory");
    } catch (...) {
        return fail(GLINT_ERROR_INTERNAL, "an unexpected exception");
    }
}

} // namespace glint

const char *glint_error_name(glint_error code) {
    static constexpr const char *const names[] = {
        "OK", "INVALID_ARGUMENT", "BAD_INPUT", "NOT_FOUND",     "LIMIT_EXCEEDED",
        "IO", "UNSUPPORTED",      "CANCELLED", "OUT_OF_MEMORY", "INTERNAL"};
    return code >= 0 && code < static_cast<glint_error>(std::size(names)) ? names[code] : "UNKNOWN";
}

const char *glint_last_error_message(const void *handle) {
    return handle ? static_cast<const glint::Handle *>(handle)->message() : "there is no handle";
}
