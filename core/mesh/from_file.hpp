// What every reader of a whole text file does about failures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include <glint/result.hpp>

#include "text/text_file.hpp"
#include "text/words.hpp"

namespace glint {

/// What `read` makes of the file's text. Errors that name no file get this one's name; running out of memory and faults
/// of the file system become errors.
template <typename T, typename Read>
[[nodiscard]] Result<T> from_file(const std::filesystem::path &file, uint64_t max_bytes, Read &&read) {
    const std::string name = file.string();
    const auto about_it = [&](Error error) {
        for (Diagnostic &diagnostic : error.diagnostics) {
            if (diagnostic.file.empty()) diagnostic.file = name;
        }
        return error;
    };
    try {
        Result<TextFile> text = read_text_file(file, max_bytes);
        if (!text.ok()) return about_it(std::move(text).error());
        Result<T> result = read(std::move(text).value());
        if (!result.ok()) return about_it(std::move(result).error());
        return result;
    } catch (const std::bad_alloc &) {
        return about_it(Error(ErrorCode::limit_exceeded, "there is not enough memory to read this file"));
    } catch (const std::system_error &failure) { // std::filesystem's among them
        return about_it(Error(ErrorCode::io, words("the file system failed: ", failure.what())));
    }
}

} // namespace glint
