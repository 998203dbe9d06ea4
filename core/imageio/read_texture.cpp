// An image file's way into a texture: have the module decode it, keep the values within what a texture may have.
#include <glint/imageio.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <string>
#include <system_error>

#include "imageio/module.hpp"

namespace fs = std::filesystem;

namespace glint {
namespace {

using imageio::Module;

constexpr uint64_t most_texels = uint64_t{1} << 26;
constexpr uint32_t longest_side_px = uint32_t{1} << 20;

/// A texture that is made when its size is known, or what is wrong with that size.
struct Room {
    Texture texture;
    std::string problem;
};

/// Called by the module: nothing may be thrown through it.
float *make_room(void *context, uint32_t width_px, uint32_t height_px) noexcept {
    Room &room = *static_cast<Room *>(context);
    try {
        const uint64_t texels = uint64_t{width_px} * height_px;
        const std::string size = std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels";
        if (texels > most_texels) {
            room.problem = "it has " + size + ", and a texture at most " + std::to_string(most_texels);
        } else if (width_px > longest_side_px || height_px > longest_side_px) {
            room.problem = "it has " + size + ", and a texture at most " + std::to_string(longest_side_px) + " a side";
        } else {
            room.texture.texels.resize(static_cast<size_t>(texels));
            room.texture.width_px = width_px;
            room.texture.height_px = height_px;
            return &room.texture.texels.front().x;
        }
    } catch (const std::bad_alloc &) {
        room.problem.clear();
    }
    return nullptr;
}

/// Files with floats may have any, NaN included.
float within_0_1(float value) {
    if (!(value > 0.0f)) return 0.0f;
    return value < 1.0f ? value : 1.0f;
}

/// The library's reasons may have several lines; a diagnostic has one.
Error cannot_read(const fs::path &file, ErrorCode code, std::string why) {
    while (!why.empty() && why.back() == '\n') why.pop_back();
    std::replace(why.begin(), why.end(), '\n', ' ');
    return {code, "cannot read the image '" + file.string() + "': " + why};
}

} // namespace

Result<Texture> read_texture(const fs::path &file) {
    static_assert(sizeof(Color) == 3 * sizeof(float));
    std::error_code unknown;
    const fs::file_status status = fs::status(file, unknown);
    if (!fs::exists(status)) return cannot_read(file, ErrorCode::not_found, "there is no such file");
    // The library would wait for a pipe, and does not say what a folder is.
    if (fs::is_directory(status)) return cannot_read(file, ErrorCode::not_found, "it is a folder, expected a file");
    if (!fs::is_regular_file(status)) return cannot_read(file, ErrorCode::not_found, "it is no regular file");

    const Result<Module> module = imageio::load_module();
    if (!module) return module.error();
    Room room;
    const glint_imageio_room asked{&make_room, &room};
    std::array<char, 512> message{};
    switch (module->decode(file.c_str(), &asked, message.data(), message.size())) {
    case GLINT_IMAGEIO_OK:
        break;
    case GLINT_IMAGEIO_STOPPED:
        return cannot_read(file, ErrorCode::limit_exceeded,
                           room.problem.empty() ? "there is not enough memory for it" : room.problem);
    default:
        return cannot_read(file, ErrorCode::bad_input, message.data());
    }
    for (Color &texel : room.texture.texels) {
        texel = {within_0_1(texel.x), within_0_1(texel.y), within_0_1(texel.z)};
    }
    return std::move(room.texture);
}

} // namespace glint
