// The presenter's shaders, in the language of OpenGL ES 2.0.
#pragma once

namespace glint::gles {

inline constexpr const char *vertex_source = R"(#version 100
attribute vec4 corner; // x, y on the screen; s, t in the texture
varying vec2 place;
void main() {
    place = corner.zw;
    gl_Position = vec4(corner.xy, 0.0, 1.0);
}
)";

/// Before either fragment shader. Sampler and coordinate ask for full precision where there is: mediump has too few
/// bits to tell the texels of a wide picture apart, and Mesa's llvmpipe takes its fast path for highp samplers only.
inline constexpr const char *fragment_head = R"(#version 100
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
precision highp sampler2D;
#else
precision mediump float;
#endif
uniform sampler2D picture; // stays 0, the first texture unit
varying vec2 place;
)";

/// The texture's own filter.
inline constexpr const char *plain_fragment_source = R"(void main() {
    gl_FragColor = texture2D(picture, place);
}
)";

/// The sixteen texels around a place, weighted by the spline of E. Catmull and R. Rom ("A Class of Local Interpolating
/// Splines", 1974). The texture's own filter is to be GL_NEAREST. Overshoot beyond the inner four, which would be a
/// halo along edges, is cut off. Without highp, whose bits it takes to find the texels, it is the texture's filter.
inline constexpr const char *sharp_fragment_source = R"(#ifdef GL_FRAGMENT_PRECISION_HIGH
uniform vec2 size_px; // the texture's

vec4 spline(float t) { // weights of the texels at -1, 0, 1, 2
    return vec4(t * (-0.5 + t * (1.0 - 0.5 * t)),
                1.0 + t * t * (-2.5 + 1.5 * t),
                t * (0.5 + t * (2.0 - 1.5 * t)),
                t * t * (-0.5 + 0.5 * t));
}

void main() {
    vec2 step = 1.0 / size_px;
    vec2 at = place * size_px - 0.5;
    vec2 first = floor(at);
    vec4 across = spline(at.x - first.x);
    vec4 down = spline(at.y - first.y);
    vec4 s = (first.x + vec4(-0.5, 0.5, 1.5, 2.5)) * step.x;
    vec4 t = (first.y + vec4(-0.5, 0.5, 1.5, 2.5)) * step.y;
    vec4 b1 = texture2D(picture, vec2(s.y, t.y)), c1 = texture2D(picture, vec2(s.z, t.y));
    vec4 b2 = texture2D(picture, vec2(s.y, t.z)), c2 = texture2D(picture, vec2(s.z, t.z));
    vec4 row0 = across.x * texture2D(picture, vec2(s.x, t.x)) + across.y * texture2D(picture, vec2(s.y, t.x)) +
                across.z * texture2D(picture, vec2(s.z, t.x)) + across.w * texture2D(picture, vec2(s.w, t.x));
    vec4 row1 = across.x * texture2D(picture, vec2(s.x, t.y)) + across.y * b1 +
                across.z * c1 + across.w * texture2D(picture, vec2(s.w, t.y));
    vec4 row2 = across.x * texture2D(picture, vec2(s.x, t.z)) + across.y * b2 +
                across.z * c2 + across.w * texture2D(picture, vec2(s.w, t.z));
    vec4 row3 = across.x * texture2D(picture, vec2(s.x, t.w)) + across.y * texture2D(picture, vec2(s.y, t.w)) +
                across.z * texture2D(picture, vec2(s.z, t.w)) + across.w * texture2D(picture, vec2(s.w, t.w));
    vec4 color = down.x * row0 + down.y * row1 + down.z * row2 + down.w * row3;
    gl_FragColor = clamp(color, min(min(b1, c1), min(b2, c2)), max(max(b1, c1), max(b2, c2)));
}
#else
void main() {
    gl_FragColor = texture2D(picture, place);
}
#endif
)";

} // namespace glint::gles
