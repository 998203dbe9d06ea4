// What every reader of a whole text file does about failures.
#pragma once

#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include <glint/read.hpp>

#include "text/files.hpp"
#include "text/words.hpp"

namespace glint {

/// What `read` makes of the file's text. Errors that name no file get this one's name; running out of memory and faults
/// of the file system become errors.
template <typename T, typename Read>
[[nodiscard]] Result<T> from_file(const std::filesystem::path &file, const ReadOptions &options, Read &&read) {
    const std::string name = file.string();
    const auto about_it = [&](Error error) {
        for (Diagnostic &diagnostic : error.diagnostics) {
            if (diagnostic.file.empty()) diagnostic.file = name;
        }
        return error;
    };
    try {
        Result<TextFile> text = Files(options.files.get()).read(file, options.max_file_bytes);
        if (!text.ok()) return about_it(std::move(text).error());
        Result<T> result = read(std::move(text).value());
        if (!result.ok()) return about_it(std::move(result).error());
        return result;
    } catch (const std::bad_alloc &) {
        return about_it(Error(ErrorCode::out_of_memory, "there is not enough memory to read this file"));
    } catch (const std::system_error &failure) { // std::filesystem's among them
        return about_it(Error(ErrorCode::io, words("the file system failed: ", failure.what())));
    }
}

} // namespace glint
