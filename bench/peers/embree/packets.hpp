// Embree's ray layouts behind one face: N rays in a packet, a call to trace them.
#pragma once

#include <cstddef>

#include <embree3/rtcore.h>

namespace glint::bench::embree {

// The lanes of a field, be it one number (N = 1) or an array.
template <typename T> T *lanes(T &field) {
    return &field;
}
template <typename T, size_t N> T *lanes(T (&field)[N]) {
    return field;
}

/// Packet types and calls for each width; `valid` has -1 for the lanes that count.
template <int N> struct Packets;

template <> struct Packets<1> {
    using Ray = RTCRay;
    using RayHit = RTCRayHit;
    static void intersect(const int *, RTCScene scene, RTCIntersectContext *context, RayHit *packet) {
        rtcIntersect1(scene, context, packet);
    }
    static void occluded(const int *, RTCScene scene, RTCIntersectContext *context, Ray *packet) {
        rtcOccluded1(scene, context, packet);
    }
};

template <> struct Packets<4> {
    using Ray = RTCRay4;
    using RayHit = RTCRayHit4;
    static constexpr auto intersect = &rtcIntersect4;
    static constexpr auto occluded = &rtcOccluded4;
};

template <> struct Packets<8> {
    using Ray = RTCRay8;
    using RayHit = RTCRayHit8;
    static constexpr auto intersect = &rtcIntersect8;
    static constexpr auto occluded = &rtcOccluded8;
};

template <> struct Packets<16> {
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;
    static constexpr auto intersect = &rtcIntersect16;
    static constexpr auto occluded = &rtcOccluded16;
};

} // namespace glint::bench::embree
