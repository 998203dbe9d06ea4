// Keeps a program that runs for hours as small as it began.
#pragma once

namespace glint::cli {

/// From now on large blocks come from the system one by one and go back to it when they are freed, and what lies free
/// now goes back at once. For a loop that makes and drops pictures: glibc would soon put them among what stays, and its
/// heaps would grow by the gaps. Elsewhere it does nothing.
void keep_memory_steady();

} // namespace glint::cli
