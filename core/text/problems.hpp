// Collecting every problem of a file, so that one run shows them all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glint/result.hpp>

namespace glint {

/// Where in a file something stands. The default is "the file as a whole".
struct Place {
    uint32_t line = 0;            ///< from 1
    uint32_t column = 0;          ///< from 1, in bytes
    std::string_view source_line; ///< without its newline
};

/// The errors and warnings of one file and of the files it names.
class Problems {
public:
    /// Errors beyond this many are counted, not kept; likewise warnings.
    static constexpr size_t most_kept = 100;

    /// `file` is the name that diagnostics carry.
    explicit Problems(std::string file) : file_(std::move(file)) {}

    void error(const Place &place, std::string message, std::string hint = {}, ErrorCode code = ErrorCode::bad_input);
    void warn(const Place &place, std::string message, std::string hint = {});

    /// Takes over what another file's reader found.
    void adopt(Error error);
    void adopt(std::vector<Diagnostic> warnings);
    void adopt(Problems other);
    /// The same, of a file that is named at `place` of this one: problems of it as a whole, which show no line, say so.
    void adopt(Error error, const Place &place);

    /// Whether a further error would only be counted, so that there is no need to look for good words.
    [[nodiscard]] bool full() const { return errors_.size() >= most_kept; }
    [[nodiscard]] bool ok() const { return errors_.empty(); }
    [[nodiscard]] const std::string &file() const { return file_; }

    /// All errors, closed by "and N more" where not all were kept. Its code is the one all errors share, else
    /// bad_input. There must be one.
    [[nodiscard]] Error take_error();
    [[nodiscard]] std::vector<Diagnostic> take_warnings();

private:
    Diagnostic describe(Diagnostic::Severity severity, const Place &place, std::string message, std::string hint) const;
    void keep_error(Diagnostic diagnostic, ErrorCode code);

    std::string file_;
    std::vector<Diagnostic> errors_;
    std::vector<Diagnostic> warnings_;
    std::optional<ErrorCode> code_;
    uint64_t errors_left_out_ = 0;
    uint64_t warnings_left_out_ = 0;
};

} // namespace glint
