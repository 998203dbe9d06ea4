// Whether two scenes are the same in everything that can be seen of them.
#pragma once

#include <glint/scene.hpp>

namespace glint::fuzz {

/// Stops the program, saying what differs, unless all numbers are equal, and so all pictures to the bit. (A zero's sign
/// is left aside: a coordinate's, which no picture shows.)
void require_same(const Scene &one, const Scene &other);

} // namespace glint::fuzz
