// Errors as values: what went wrong, where in which file, and what was expected instead.
#pragma once

#include <cassert>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glint/export.hpp>

namespace glint {

/// What kind of failure an Error is; a program decides by it, a person reads the diagnostics.
enum class ErrorCode {
    bad_input,      ///< a file's contents, or a scene handed to a builder, are not valid
    not_found,      ///< a file is missing, is a folder, or may not be read
    limit_exceeded, ///< valid, but larger than a limit the caller set; raise the limit to go on
    io,             ///< the system refused to read or write (disk full, permission, broken device)
    unsupported,    ///< this machine or this build cannot do it
    cancelled,      ///< the caller asked to stop
    out_of_memory,  ///< the system gave no more memory
};

/// One problem, at one place. Lines and columns count from 1; 0 means "the file as a whole".
struct GLINT_API Diagnostic {
    enum class Severity { warning, error };

    Severity severity = Severity::error;
    std::string file;        ///< as the user named it; empty when there is no file
    uint32_t line = 0;       ///< from 1; 0 = no particular line
    uint32_t column = 0;     ///< from 1, in bytes; 0 = no particular column
    std::string message;     ///< what was found and what was expected, one sentence, no newline
    std::string hint;        ///< how to go on ("did you mean 'eye'?"); may be empty
    std::string source_line; ///< the line's text, without its newline; may be empty

    /// `file:line:column: error: message`, then the source line, a caret under the column and the hint,
    /// each where there is one. Lines are separated, not ended, by newlines.
    [[nodiscard]] std::string text() const;
};

/// A failure: its kind, and every problem that was found. Never without at least one diagnostic.
///
/// Functions that return one throw nothing but std::bad_alloc, and that only where there was no memory even for the
/// words of Error::out_of_memory().
struct GLINT_API Error {
    ErrorCode code = ErrorCode::bad_input;
    std::vector<Diagnostic> diagnostics;

    Error(ErrorCode code_, std::string message, std::string hint = {});
    Error(ErrorCode code_, std::vector<Diagnostic> diagnostics_) : code(code_), diagnostics(std::move(diagnostics_)) {}

    /// ErrorCode::out_of_memory, in words.
    [[nodiscard]] static Error out_of_memory();

    /// Every diagnostic's text, one after another, without a newline at the end.
    [[nodiscard]] std::string text() const;
};

/// A value, or the reason there is none. Asking for the one that is not there is a programming error (asserted).
template <typename T> class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] T &value() & { return assert(ok()), *std::get_if<0>(&state_); }
    [[nodiscard]] const T &value() const & { return assert(ok()), *std::get_if<0>(&state_); }
    [[nodiscard]] T &&value() && { return assert(ok()), std::move(*std::get_if<0>(&state_)); }
    [[nodiscard]] const Error &error() const & { return assert(!ok()), *std::get_if<1>(&state_); }
    [[nodiscard]] Error &&error() && { return assert(!ok()), std::move(*std::get_if<1>(&state_)); }

    T *operator->() { return &value(); }
    const T *operator->() const { return &value(); }
    T &operator*() { return value(); }
    const T &operator*() const { return value(); }

private:
    std::variant<T, Error> state_;
};

/// Success without a value, or the reason for failure.
struct Done {};
using Status = Result<Done>;

} // namespace glint
