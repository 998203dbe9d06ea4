// The ways that OpenGL ES has to put a picture on a surface, each timed: what the presenter's choice is among.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glint/framebuffer.hpp>
#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

namespace glint::bench {

enum class UploadWay {
    rgba,        ///< glTexSubImage2D from memory
    bgra,        ///< the same, bytes reordered while they are copied to a buffer
    rgba_buffer, ///< through a mapped pixel unpack buffer (OpenGL ES 3)
    bgra_buffer, ///< the same, reordered on the way
};

enum class DrawWay {
    six_vertices, ///< two triangles, GL_TRIANGLES
    strip,        ///< two triangles, GL_TRIANGLE_STRIP of four vertices
    one_triangle, ///< twice as wide and high as the surface
    blit,         ///< glBlitFramebuffer, upside down (OpenGL ES 3)
};

/// Milliseconds of each frame, with glFinish after uploading and after drawing.
struct WayTimes {
    UploadWay upload;
    DrawWay draw;
    std::string missing; ///< why it could not be done; empty where it was
    std::vector<double> upload_ms;
    std::vector<double> draw_ms;
};

[[nodiscard]] std::string way_name(UploadWay way);
[[nodiscard]] std::string way_name(DrawWay way);

/// Times all of them on the surface, which is current and has the picture's size, for at least `min_seconds` each.
/// Fails with io where the surface then shows another byte than the picture has.
[[nodiscard]] Result<std::vector<WayTimes>> time_ways(gles::Surface &surface, const Framebuffer &picture,
                                                      double min_seconds);

} // namespace glint::bench
