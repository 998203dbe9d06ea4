// What all handles of the C interface have in common, and the one place where exceptions end.
#pragma once

#include <cstdint>
#include <new>
#include <string>
#include <utility>

#include <glint/error.h>
#include <glint/result.hpp>

namespace glint {

/// Every handle begins with what it is, so that one of another kind is refused. Numbers that are rare in memory.
enum class HandleKind : uint32_t {
    scene = 0x476c6901,
    scene_builder,
    framebuffer,
    renderer,
    job,
    governor,
    camera_control,
    refiner,
};

/// The base of every handle: its kind and the message of its last failure.
class Handle {
public:
    explicit Handle(HandleKind kind) : kind_(kind) {}
    Handle(const Handle &) = delete;
    Handle &operator=(const Handle &) = delete;

    [[nodiscard]] HandleKind kind() const { return kind_; }
    [[nodiscard]] const char *message() const { return message_; }

    /// Keep the message and return the code. `message` is a literal.
    glint_error fail(glint_error code, const char *message) noexcept;
    glint_error fail(const Error &error) noexcept;
    /// A call that is wrong.
    glint_error refuse(const char *message) noexcept { return fail(GLINT_ERROR_INVALID_ARGUMENT, message); }
    /// Inside a handler: tells of the exception in flight.
    glint_error fail_by_exception() noexcept;

private:
    HandleKind kind_;
    const char *message_ = "";
    std::string text_;
};

/// A handle of the kind `handle_kind`; may be copied nowhere, and is made by create() only.
template <HandleKind handle_kind> struct HandleOf : Handle {
    static constexpr HandleKind own_kind = handle_kind;
    HandleOf() : Handle(handle_kind) {}
};

[[nodiscard]] glint_error code_of(ErrorCode code) noexcept;

/// Whether it is a handle of this type, not NULL.
template <typename H> [[nodiscard]] bool is_handle(const H *handle) {
    return handle && handle->kind() == H::own_kind;
}
/// And whether what it stands for was made: each handle says so itself.
template <typename H> [[nodiscard]] bool is_made(const H *handle) {
    return is_handle(handle) && handle->is_made();
}

/// Calls body(), which returns a code. No exception leaves: the handle keeps what it was.
template <typename Body> glint_error guarded(Handle &handle, Body &&body) noexcept {
    try {
        return body();
    } catch (...) {
        return handle.fail_by_exception();
    }
}

/// A function on a handle: body(handle), guarded, if there is a handle that was made.
template <typename H, typename Body> glint_error call(H *handle, Body &&body) noexcept {
    if (!is_handle(handle)) return GLINT_ERROR_INVALID_ARGUMENT;
    if (!handle->is_made()) return GLINT_ERROR_INVALID_ARGUMENT; // its message says why it was not
    return guarded(*handle, [&] { return body(*handle); });
}

/// A creating function: puts a handle into *place and lets body(handle) fill it, or say why not.
template <typename H, typename Body> glint_error create(H **place, Body &&body) noexcept {
    if (!place) return GLINT_ERROR_INVALID_ARGUMENT;
    H *const handle = new (std::nothrow) H;
    *place = handle;
    if (!handle) return GLINT_ERROR_OUT_OF_MEMORY;
    return guarded(*handle, [&] { return body(*handle); });
}

template <typename H> void release(H *handle) noexcept {
    if (is_handle(handle)) delete handle;
}

} // namespace glint
