// A picture in OpenGL's memory: one texture, or several where it is larger than a texture may be.
#pragma once

#include <cstdint>
#include <vector>

#include <glint/gles/pixel_view.hpp>
#include <glint/result.hpp>

#include "gles/gl.hpp"
#include "gles/texel_format.hpp"
#include "gles/tiles.hpp"

namespace glint::gles {

class PictureTexture {
public:
    /// Makes nothing yet. `gl` must outlive it.
    explicit PictureTexture(const Gl &gl);

    /// Copies a picture, making storage anew when its size is another. Leaves the context's state as it was.
    Status upload(const PixelView &picture);
    /// Binds the texture of one tile to the active unit, which asks for `filter` (GL_NEAREST, GL_LINEAR).
    void bind(size_t tile_id, GLint filter);
    void delete_textures();

    /// Of the picture last uploaded; empty when there is none.
    [[nodiscard]] const std::vector<Tile> &tiles() const { return tiles_; }
    [[nodiscard]] uint32_t width_px() const { return width_px_; }
    [[nodiscard]] uint32_t height_px() const { return height_px_; }

private:
    struct Texture {
        GLuint name = 0;
        GLint filter = GL_NEAREST;
    };
    Status allocate(uint32_t width_px, uint32_t height_px);
    Status create_textures(size_t count);
    Status allocate_tiles(const std::vector<Tile> &tiles);
    void transfer(const PixelView &picture, const Tile &tile);
    void transfer_staged(const uint8_t *pixels, size_t stride_bytes, const Tile &tile);

    const Gl &gl_;
    TexelFormat texel_;
    uint32_t largest_px_;
    std::vector<Texture> textures_; // as many as tiles
    std::vector<Tile> tiles_;
    uint32_t width_px_ = 0;
    uint32_t height_px_ = 0;
    std::vector<uint8_t> staging_;
};

} // namespace glint::gles
