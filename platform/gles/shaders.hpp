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

/// The twelve texels around a place, weighted by a bell that follows edges: half as long again along an edge as across,
/// so that stairs become lines, and steeper than bilinear across, so that lines stay narrow. Where brightness changes
/// in all directions alike it is bilinear. A light form of kernel regression (H. Takeda et al., "Kernel Regression for
/// Image Processing and Reconstruction", 2007), with the taps of AMD's FidelityFX Super Resolution 1 (T. Lottes, 2021),
/// but without its negative lobes, which turn the stairs of pictures with one sample a pixel into halos.
///
/// The texture's own filter is to be GL_NEAREST. Without highp, whose bits it takes to tell texels apart, that is all.
inline constexpr const char *sharp_fragment_source = R"(
#ifdef GL_FRAGMENT_PRECISION_HIGH
uniform vec2 size_px; // the texture's

vec4 texel(vec2 at) {
    return texture2D(picture, (at + 0.5) / size_px);
}

float brightness(vec4 color) {
    return dot(color.rgb, vec3(0.299, 0.587, 0.114));
}

vec4 falling(vec4 distance) { // from 1 at 0 to 0 at 1
    vec4 d = min(distance, 1.0);
    return 1.0 - d * d * (3.0 - 2.0 * d);
}

// Of four texels, from their ways to the place; the edge runs at right angles to `across`.
vec4 bell(vec4 x, vec4 y, vec2 across) {
    return falling(abs(x * across.x + y * across.y)) * falling(abs(y * across.x - x * across.y) / 1.5);
}

void main() {
    vec2 at = place * size_px - 0.5;
    vec2 first = floor(at);
    vec2 part = at - first;
    //     t0 t1
    //  l0 a  b  r0
    //  l1 c  d  r1
    //     b0 b1
    vec4 a = texel(first), b = texel(first + vec2(1.0, 0.0));
    vec4 c = texel(first + vec2(0.0, 1.0)), d = texel(first + vec2(1.0, 1.0));
    vec4 t0 = texel(first + vec2(0.0, -1.0)), t1 = texel(first + vec2(1.0, -1.0));
    vec4 l0 = texel(first + vec2(-1.0, 0.0)), l1 = texel(first + vec2(-1.0, 1.0));
    vec4 r0 = texel(first + vec2(2.0, 0.0)), r1 = texel(first + vec2(2.0, 1.0));
    vec4 b0 = texel(first + vec2(0.0, 2.0)), b1 = texel(first + vec2(1.0, 2.0));

    // How brightness changes at a, b, c, d, and from that about the place: its structure tensor.
    vec4 inner = vec4(brightness(a), brightness(b), brightness(c), brightness(d));
    vec4 dx = vec4(inner.y, brightness(r0), inner.w, brightness(r1)) -
              vec4(brightness(l0), inner.x, brightness(l1), inner.z);
    vec4 dy = vec4(inner.zw, brightness(b0), brightness(b1)) - vec4(brightness(t0), brightness(t1), inner.xy);
    vec4 near = vec4((1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y,
                     part.x * part.y);
    float xx = dot(near, dx * dx), xy = dot(near, dx * dy), yy = dot(near, dy * dy);
    float difference = sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy);
    float one_way = difference / (xx + yy + 0.001); // 1 on an edge, 0 where all directions are alike
    vec2 across = vec2(xx - yy + difference, 2.0 * xy);
    float size = length(across);
    across = size > 1e-6 ? across / size : vec2(0.0, 1.0);

    vec4 x = vec4(0.0, 1.0, 0.0, 1.0) - part.x, y = vec4(0.0, 0.0, 1.0, 1.0) - part.y;
    vec4 weights = bell(x, y, across);
    vec4 beside = bell(vec4(-1.0, -1.0, 2.0, 2.0) - part.x, y.xzxz, across);
    vec4 above = bell(x.xyxy, vec4(-1.0, -1.0, 2.0, 2.0) - part.y, across);
    vec4 color = weights.x * a + weights.y * b + weights.z * c + weights.w * d +
                 beside.x * l0 + beside.y * l1 + beside.z * r0 + beside.w * r1 +
                 above.x * t0 + above.y * t1 + above.z * b0 + above.w * b1;
    color /= dot(weights + beside + above, vec4(1.0));
    vec4 bilinear = near.x * a + near.y * b + near.z * c + near.w * d;
    gl_FragColor = mix(bilinear, color, one_way);
}
#else
void main() {
    gl_FragColor = texture2D(picture, place);
}
#endif
)";

} // namespace glint::gles
