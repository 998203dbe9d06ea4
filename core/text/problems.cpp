// Collecting every problem of a file, so that one run shows them all.
#include "text/problems.hpp"

#include <utility>

#include "text/words.hpp"

namespace glint {

namespace {

/// Bytes of a source line that a diagnostic carries. Without a bound, a hundred problems on one line of ten megabytes
/// would carry a gigabyte.
constexpr size_t most_source_bytes = 4096;

Diagnostic left_out(Diagnostic::Severity severity, const std::string &file, uint64_t count, std::string_view what) {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.file = file;
    diagnostic.message = words("and ", count, " more ", what, count == 1 ? "" : "s");
    return diagnostic;
}

} // namespace

Diagnostic Problems::describe(Diagnostic::Severity severity, const Place &place, std::string message,
                              std::string hint) const {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.file = file_;
    diagnostic.line = place.line;
    diagnostic.column = place.column;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    if (place.column < most_source_bytes) diagnostic.source_line = place.source_line.substr(0, most_source_bytes);
    return diagnostic;
}

void Problems::keep_error(Diagnostic diagnostic, ErrorCode code) {
    if (!code_) code_ = code;
    if (*code_ != code) code_ = ErrorCode::bad_input;
    if (full()) {
        ++errors_left_out_;
    } else {
        errors_.push_back(std::move(diagnostic));
    }
}

void Problems::error(const Place &place, std::string message, std::string hint, ErrorCode code) {
    keep_error(describe(Diagnostic::Severity::error, place, std::move(message), std::move(hint)), code);
}

void Problems::warn(const Place &place, std::string message, std::string hint) {
    std::vector<Diagnostic> one;
    one.push_back(describe(Diagnostic::Severity::warning, place, std::move(message), std::move(hint)));
    adopt(std::move(one));
}

void Problems::adopt(Error error) {
    for (Diagnostic &diagnostic : error.diagnostics) keep_error(std::move(diagnostic), error.code);
}

void Problems::adopt(std::vector<Diagnostic> warnings) {
    for (Diagnostic &diagnostic : warnings) {
        if (warnings_.size() < most_kept) {
            warnings_.push_back(std::move(diagnostic));
        } else {
            ++warnings_left_out_;
        }
    }
}

void Problems::adopt(Problems other) {
    if (!other.ok()) adopt(other.take_error());
    adopt(other.take_warnings());
}

void Problems::adopt(Error error, const Place &place) {
    for (Diagnostic &diagnostic : error.diagnostics) {
        if (diagnostic.line == 0 && diagnostic.hint.empty()) {
            diagnostic.hint = words("named in ", file_, ':', place.line, ':', place.column);
        }
    }
    adopt(std::move(error));
}

Error Problems::take_error() {
    if (errors_left_out_ > 0) {
        errors_.push_back(left_out(Diagnostic::Severity::error, file_, errors_left_out_, "problem"));
    }
    return {code_.value_or(ErrorCode::bad_input), std::move(errors_)};
}

std::vector<Diagnostic> Problems::take_warnings() {
    if (warnings_left_out_ > 0) {
        warnings_.push_back(left_out(Diagnostic::Severity::warning, file_, warnings_left_out_, "warning"));
    }
    return std::move(warnings_);
}

} // namespace glint
