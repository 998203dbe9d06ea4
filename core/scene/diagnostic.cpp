// How a problem is put into words for a person.
#include <glint/result.hpp>

namespace glint {

namespace {

/// Longest piece of a source line that is shown; a longer line is cut around the column.
constexpr size_t shown_columns = 120;

/// The source line and a caret under `column` (from 1). Tabs and other control bytes become blanks, so that the caret
/// stands where the eye looks for it and no byte of a broken file can drive a terminal.
std::string line_with_caret(const std::string &line, size_t column) {
    size_t first = 0;
    size_t at = column > 0 ? column - 1 : 0;
    if (at > line.size()) at = line.size();
    if (line.size() > shown_columns && at > shown_columns / 2) first = at - shown_columns / 2;
    std::string shown = line.substr(first, shown_columns);
    for (char &c : shown) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) c = ' ';
    }
    std::string text = "\n    " + shown;
    if (column > 0) {
        // Bytes of a UTF-8 sequence after the first take no column on screen.
        size_t indent = 0;
        for (size_t i = 0; i < at - first && i < shown.size(); ++i) {
            if ((static_cast<unsigned char>(shown[i]) & 0xc0) != 0x80) ++indent;
        }
        text += "\n    " + std::string(indent, ' ') + '^';
    }
    return text;
}

} // namespace

std::string Diagnostic::text() const {
    std::string text;
    if (!file.empty()) {
        text += file;
        if (line > 0) text += ':' + std::to_string(line);
        if (line > 0 && column > 0) text += ':' + std::to_string(column);
        text += ": ";
    }
    text += severity == Severity::error ? "error: " : "warning: ";
    text += message;
    if (!source_line.empty()) text += line_with_caret(source_line, column);
    if (!hint.empty()) text += "\n    " + hint;
    return text;
}

Error::Error(ErrorCode code_, std::string message, std::string hint) : code(code_) {
    Diagnostic diagnostic;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    diagnostics.push_back(std::move(diagnostic));
}

Error Error::out_of_memory() {
    return {ErrorCode::out_of_memory, "there is not enough memory"};
}

std::string Error::text() const {
    std::string text;
    for (const Diagnostic &diagnostic : diagnostics) {
        if (!text.empty()) text += '\n';
        text += diagnostic.text();
    }
    return text;
}

} // namespace glint
