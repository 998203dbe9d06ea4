// Uploading pictures, in one part or in several.
#include "gles/picture_texture.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "gles/saved_state.hpp"
#include "gles/size_text.hpp"

namespace glint::gles {

namespace {

// Rows whose bytes must change order pass through a buffer: many rows, so that calls do not count, yet few enough to
// stay in a core's own cache.
constexpr size_t staging_bytes = size_t{256} << 10;

Status check_pixels(const PixelView &picture) {
    const bool fits = picture.stride_bytes >= size_t{picture.width_px} * 4;
    if (picture.rgba8 != nullptr && picture.width_px > 0 && picture.height_px > 0 && fits) return Done{};
    return Error(ErrorCode::bad_input, "a picture of " + size_text(picture.width_px, picture.height_px) +
                                           " pixels, rows " + std::to_string(picture.stride_bytes) + " bytes apart" +
                                           (picture.rgba8 == nullptr ? " at no address" : "") +
                                           ", expected at least 1 x 1 and rows of four bytes a pixel");
}

} // namespace

PictureTexture::PictureTexture(const Gl &gl)
    : gl_(gl),
      texel_(fastest_texel_format(gl)),
      largest_px_(static_cast<uint32_t>(std::max(gl.integer(GL_MAX_TEXTURE_SIZE), 0))) {}

Status PictureTexture::upload(const PixelView &picture) {
    if (Status status = check_pixels(picture); !status) return status;
    const SavedTexture saved_texture(gl_);
    const TightRows tight_rows(gl_, TightRows::Direction::unpack);
    if (Status status = allocate(picture.width_px, picture.height_px); !status) return status;
    for (size_t i = 0; i < tiles_.size(); ++i) {
        gl_.bind_texture(GL_TEXTURE_2D, textures_[i].name);
        transfer(picture, tiles_[i]);
    }
    return gl_.check("glTexSubImage2D");
}

Status PictureTexture::allocate(uint32_t width_px, uint32_t height_px) {
    if (width_px == width_px_ && height_px == height_px_) return Done{};
    std::vector<Tile> tiles = cut_into_tiles(width_px, height_px, largest_px_);
    if (tiles.empty()) {
        return Error(ErrorCode::unsupported, "the OpenGL context has textures of at most " +
                                                 size_text(largest_px_, largest_px_) + " pixels, expected more");
    }
    tiles_.clear(); // until it is known to have worked, there is no picture
    width_px_ = height_px_ = 0;
    if (Status status = create_textures(tiles.size()); !status) return status;
    if (Status status = allocate_tiles(tiles); !status) return status;
    tiles_ = std::move(tiles);
    width_px_ = width_px;
    height_px_ = height_px;
    return Done{};
}

/// Textures that are there are kept, those too many are deleted.
Status PictureTexture::create_textures(size_t count) {
    for (; textures_.size() > count; textures_.pop_back()) gl_.delete_textures(1, &textures_.back().name);
    while (textures_.size() < count) {
        Texture &texture = textures_.emplace_back();
        gl_.gen_textures(1, &texture.name);
        gl_.bind_texture(GL_TEXTURE_2D, texture.name);
        // OpenGL ES 2.0 samples sizes that are no powers of two with exactly this: no repeating, no smaller levels.
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, texture.filter);
        gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, texture.filter);
    }
    return gl_.check("glTexParameteri");
}

Status PictureTexture::allocate_tiles(const std::vector<Tile> &tiles) {
    for (size_t i = 0; i < tiles.size(); ++i) {
        gl_.bind_texture(GL_TEXTURE_2D, textures_[i].name);
        gl_.tex_image_2d(GL_TEXTURE_2D, 0, texel_.internal_format, static_cast<GLsizei>(tiles[i].texture_width_px),
                         static_cast<GLsizei>(tiles[i].texture_height_px), 0, texel_.format, GL_UNSIGNED_BYTE, nullptr);
        if (Status status = gl_.check("glTexImage2D"); !status) return status;
    }
    return Done{};
}

/// Fills the bound texture, the tile's.
void PictureTexture::transfer(const PixelView &picture, const Tile &tile) {
    const uint8_t *pixels = picture.rgba8 + tile.texture_y * picture.stride_bytes + size_t{tile.texture_x} * 4;
    const bool has_gaps = picture.stride_bytes != size_t{tile.texture_width_px} * 4;
    const bool whole_pixels = picture.stride_bytes % 4 == 0 && picture.stride_bytes / 4 <= INT32_MAX;
    if (texel_.red_blue_swapped || (has_gaps && !(gl_.has_unpack_rows && whole_pixels))) {
        return transfer_staged(pixels, picture.stride_bytes, tile);
    }
    if (has_gaps) gl_.pixel_storei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(picture.stride_bytes / 4));
    gl_.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(tile.texture_width_px),
                         static_cast<GLsizei>(tile.texture_height_px), texel_.format, GL_UNSIGNED_BYTE, pixels);
    if (has_gaps) gl_.pixel_storei(GL_UNPACK_ROW_LENGTH, 0);
}

/// Through a buffer, where bytes change order and gaps vanish.
void PictureTexture::transfer_staged(const uint8_t *pixels, size_t stride_bytes, const Tile &tile) {
    const size_t row_bytes = size_t{tile.texture_width_px} * 4;
    const auto rows_at_once = static_cast<uint32_t>(std::max<size_t>(1, staging_bytes / row_bytes));
    if (staging_.size() < rows_at_once * row_bytes) staging_.resize(rows_at_once * row_bytes);
    const auto copy = [this](const uint8_t *from, uint8_t *to, size_t pixel_count) {
        if (texel_.red_blue_swapped) {
            copy_red_blue_swapped(from, to, pixel_count);
        } else {
            std::memcpy(to, from, pixel_count * 4);
        }
    };
    for (uint32_t y = 0; y < tile.texture_height_px; y += rows_at_once) {
        const uint32_t rows = std::min(rows_at_once, tile.texture_height_px - y);
        const uint8_t *from = pixels + y * stride_bytes;
        if (stride_bytes == row_bytes) {
            copy(from, staging_.data(), size_t{rows} * tile.texture_width_px);
        } else {
            for (size_t row = 0; row < rows; ++row) {
                copy(from + row * stride_bytes, staging_.data() + row * row_bytes, tile.texture_width_px);
            }
        }
        gl_.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(y), static_cast<GLsizei>(tile.texture_width_px),
                             static_cast<GLsizei>(rows), texel_.format, GL_UNSIGNED_BYTE, staging_.data());
    }
}

void PictureTexture::bind(size_t tile_id, GLint filter) {
    Texture &texture = textures_[tile_id];
    gl_.bind_texture(GL_TEXTURE_2D, texture.name);
    if (filter == texture.filter) return;
    gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    texture.filter = filter;
}

void PictureTexture::delete_textures() {
    for (const Texture &texture : textures_) gl_.delete_textures(1, &texture.name);
}

} // namespace glint::gles
