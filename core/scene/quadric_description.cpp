// What the ten coefficients of a quadric describe, for people.
#include <glint/quadric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include <glm/vec3.hpp>

#include "scene/principal_form.hpp"

namespace glint {

namespace {

/// Lengths that differ by less than this share of the larger one are shown as equal.
constexpr double equal_share = 1e-5;

bool nearly_equal(double a, double b) {
    return std::abs(a - b) <= equal_share * std::fmax(std::abs(a), std::abs(b));
}

class Describer {
public:
    explicit Describer(const Quadric &quadric) : quadric_(quadric), form_(principal_form(quadric)) {
        for (int i = 0; i < 3; ++i) {
            if (form_.value[i] == 0.0) continue;
            (form_.value[i] > 0.0 ? positive_ : negative_).push_back(i);
        }
        for (int i = 0; i < 3; ++i) slope_ += form_.slope[i] * form_.slope[i];
        slope_ = std::sqrt(slope_);
        rest_is_zero_ = std::abs(form_.rest) <= form_.rounding;
    }

    QuadricDescription describe() {
        switch (positive_.size() + negative_.size()) {
        case 0:
            plane();
            break;
        case 1:
            of_one_square();
            break;
        case 2:
            slope_ > 0.0 ? paraboloid() : of_two_squares();
            break;
        default:
            of_three_squares();
        }
        std::sort(description_.radii.begin(), description_.radii.end(), std::greater<>());
        return std::move(description_);
    }

private:
    [[nodiscard]] glm::dvec3 axis(int i) const { return {form_.axis[0][i], form_.axis[1][i], form_.axis[2][i]}; }

    /// Where the linear part vanishes, as near to the origin as can be.
    [[nodiscard]] glm::dvec3 centre() const {
        glm::dvec3 centre(0.0);
        for (int i = 0; i < 3; ++i) {
            if (form_.value[i] != 0.0) centre -= axis(i) * (form_.along[i] / form_.value[i]);
        }
        return centre;
    }

    /// The axis along which the quadratic part is 0; there is one.
    [[nodiscard]] int null_axis() const {
        return static_cast<int>(std::find(std::begin(form_.value), std::end(form_.value), 0.0) - form_.value);
    }

    // Adding 0 takes the sign off a -0.
    void set_centre(const glm::dvec3 &centre) { description_.centre = Point(centre + 0.0); }

    void set_direction(const glm::dvec3 &axis) { description_.axis = Vector(axis + 0.0); }

    /// A line has no direction: of the two, the one whose largest component is positive.
    void set_line(const glm::dvec3 &axis) {
        double largest = axis.x;
        if (std::abs(axis.y) > std::abs(largest)) largest = axis.y;
        if (std::abs(axis.z) > std::abs(largest)) largest = axis.z;
        set_direction(largest < 0.0 ? -axis : axis);
    }

    /// Lengths along the given axes; one where all are equal.
    void set_radii(const std::vector<int> &axes) {
        bool equal = true;
        for (const int i : axes) {
            const double radius = std::sqrt(std::abs(form_.rest / form_.value[i]));
            equal = equal && (description_.radii.empty() || nearly_equal(radius, double(description_.radii[0])));
            description_.radii.push_back(static_cast<float>(radius));
        }
        if (equal) description_.radii.resize(1);
    }

    [[nodiscard]] bool is_round(const std::vector<int> &axes) const {
        return nearly_equal(form_.value[axes[0]], form_.value[axes[1]]);
    }

    void plane() {
        const glm::dvec3 g(quadric_.g, quadric_.h, quadric_.j);
        const double squared = g.x * g.x + g.y * g.y + g.z * g.z;
        description_.name = "plane";
        set_centre(g * (-0.5 * double(quadric_.k) / squared));
        set_line(g * (1.0 / std::sqrt(squared)));
    }

    void of_one_square() {
        if (slope_ > 0.0) {
            description_.name = "parabolic cylinder";
            return;
        }
        description_.name = "pair of parallel planes";
        set_centre(centre());
        set_line(axis(positive_.empty() ? negative_[0] : positive_[0]));
    }

    /// v x^2 + w y^2 + 2 s z + rest = 0
    void paraboloid() {
        const int along = null_axis();
        const double slope = form_.slope[along];
        set_centre(centre() - axis(along) * (0.5 * form_.rest / slope));
        if (!positive_.empty() && !negative_.empty()) {
            description_.name = "hyperbolic paraboloid";
            set_line(axis(along));
            return;
        }
        const std::vector<int> &squares = positive_.empty() ? negative_ : positive_;
        description_.name = is_round(squares) ? "paraboloid" : "elliptic paraboloid";
        const bool opens_forward = (form_.value[squares[0]] > 0.0) != (slope > 0.0);
        set_direction(opens_forward ? axis(along) : -axis(along));
    }

    void of_two_squares() {
        set_centre(centre());
        if (!positive_.empty() && !negative_.empty()) {
            description_.name = rest_is_zero_ ? "pair of crossing planes" : "hyperbolic cylinder";
        } else {
            const std::vector<int> &squares = positive_.empty() ? negative_ : positive_;
            set_radii(squares);
            description_.name = description_.radii.size() == 1 ? "cylinder" : "elliptic cylinder";
        }
        if (!rest_is_zero_) set_line(axis(null_axis()));
    }

    void of_three_squares() {
        set_centre(centre());
        if (positive_.empty() || negative_.empty()) {
            set_radii(positive_.empty() ? negative_ : positive_);
            description_.name = description_.radii.size() == 1 ? "sphere" : "ellipsoid";
            return;
        }
        const bool one_is_positive = positive_.size() == 1;
        const std::vector<int> &pair = one_is_positive ? negative_ : positive_;
        const int lone = one_is_positive ? positive_[0] : negative_[0];
        set_line(axis(lone));
        if (rest_is_zero_) {
            description_.name = is_round(pair) ? "cone" : "elliptic cone";
            if (is_round(pair)) {
                constexpr double degrees = 57.29577951308232;
                const double slope = std::sqrt(-form_.value[lone] / form_.value[pair[0]]);
                description_.half_angle_degrees = static_cast<float>(std::atan(slope) * degrees);
            }
            return;
        }
        // Across the axis the pair's squares make an ellipse where the rest has the other sign: a waist.
        const bool has_waist = (form_.rest > 0.0) == one_is_positive;
        description_.name = has_waist ? "hyperboloid of one sheet" : "hyperboloid of two sheets";
        if (has_waist) set_radii(pair);
    }

    const Quadric &quadric_;
    PrincipalForm form_;
    std::vector<int> positive_, negative_; ///< axes whose eigenvalue is
    double slope_ = 0.0;                   ///< of the linear part, where there is no square
    bool rest_is_zero_ = false;
    QuadricDescription description_;
};

} // namespace

QuadricDescription describe_quadric(const Quadric &quadric) {
    return Describer(quadric).describe();
}

} // namespace glint
