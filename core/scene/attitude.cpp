// Rotations as unit quaternions, in double.
#include "scene/attitude.hpp"

#include <cmath>

namespace glint {

Attitude attitude_of(const glm::vec3 &axis, double angle_rad) {
    const glm::dvec3 a(axis);
    const double sine = std::sin(0.5 * angle_rad) / std::sqrt((a.x * a.x + a.y * a.y) + a.z * a.z);
    return {std::cos(0.5 * angle_rad), a.x * sine, a.y * sine, a.z * sine};
}

Attitude between(const Attitude &a, const Attitude &b, double share) {
    double cosine = (a.w * b.w + a.x * b.x) + (a.y * b.y + a.z * b.z);
    const double sign = cosine < 0.0 ? -1.0 : 1.0; // both are the same turn
    cosine *= sign;
    double of_a = 1.0 - share, of_b = share;
    if (cosine < 1.0 - 1e-9) { // nearer to each other a straight line will do
        const double angle = std::acos(cosine), inverse = 1.0 / std::sin(angle);
        of_a = std::sin(of_a * angle) * inverse;
        of_b = std::sin(of_b * angle) * inverse;
    }
    of_b *= sign;
    const Attitude sum{a.w * of_a + b.w * of_b, a.x * of_a + b.x * of_b, a.y * of_a + b.y * of_b,
                       a.z * of_a + b.z * of_b};
    const double inverse = 1.0 / std::sqrt((sum.w * sum.w + sum.x * sum.x) + (sum.y * sum.y + sum.z * sum.z));
    return {sum.w * inverse, sum.x * inverse, sum.y * inverse, sum.z * inverse};
}

RigidTransform pose_of(const Attitude &q, const glm::vec3 &pivot, const glm::vec3 &moved_by) {
    const glm::dvec3 x(1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z),
                       2.0 * (q.x * q.z - q.w * q.y));
    const glm::dvec3 y(2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z),
                       2.0 * (q.y * q.z + q.w * q.x));
    const glm::dvec3 z(2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x),
                       1.0 - 2.0 * (q.x * q.x + q.y * q.y));
    const glm::dvec3 p(pivot);
    const glm::dvec3 turned = (x * p.x + y * p.y) + z * p.z;
    return {glm::vec3(x), glm::vec3(y), glm::vec3(z), glm::vec3((p - turned) + glm::dvec3(moved_by))};
}

} // namespace glint
