// Writing meshes as Wavefront OBJ text, small and the same to the byte everywhere.
#include "generate/obj_writer.hpp"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>

#include <unistd.h>

namespace glint::scenes {
namespace {

constexpr int decimals = 5;
constexpr double decimal_scale = 1e5;

void append_number(std::string &text, uint64_t number) {
    char digits[20];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    text.append(digits, end);
}

/// Fixed point without trailing zeros: "-0.5", "12", "0.00001". No locale, no printf.
void append_coordinate(std::string &text, double value) {
    const auto scaled = static_cast<int64_t>(std::floor(value * decimal_scale + 0.5));
    const auto magnitude = static_cast<uint64_t>(scaled < 0 ? -scaled : scaled);
    if (scaled < 0) text += '-';
    constexpr auto unit = static_cast<uint64_t>(decimal_scale);
    append_number(text, magnitude / unit);

    uint64_t fraction = magnitude % unit;
    if (fraction == 0) return;
    int digit_count = decimals;
    for (; fraction % 10 == 0; fraction /= 10) --digit_count;
    text += '.';
    text.append(static_cast<size_t>(digit_count), '0');
    for (auto place = text.end(); fraction != 0; fraction /= 10) *--place = static_cast<char>('0' + fraction % 10);
}

} // namespace

std::string obj_text(const NamedMesh &named) {
    std::string text;
    text.reserve(named.comment.size() + 80 + named.mesh.positions.size() * 30 + named.mesh.triangles.size() * 25);
    text += "# " + named.comment + "\n# Made by glint_scenes (scenes/generate): edit that, not this.\n";
    for (const Vec3 &position : named.mesh.positions) {
        text += 'v';
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            append_coordinate(text, position[axis]);
        }
        text += '\n';
    }
    for (const auto &triangle : named.mesh.triangles) {
        text += 'f';
        for (const uint32_t index : triangle) {
            text += ' ';
            append_number(text, uint64_t{index} + 1);
        }
        text += '\n';
    }
    return text;
}

void write_obj(const NamedMesh &named, const std::filesystem::path &folder) {
    const auto path = folder / named.file_name;
    // Two builds of one source tree may write the same file at the same time: each has a temporary of its own.
    auto temporary = path;
    temporary += "." + std::to_string(getpid()) + ".tmp";
    const std::string text = obj_text(named);
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) {
        const std::error_code cause(errno != 0 ? errno : EIO, std::generic_category());
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw std::filesystem::filesystem_error("cannot write", temporary, cause);
    }
    std::filesystem::rename(temporary, path);
}

} // namespace glint::scenes
