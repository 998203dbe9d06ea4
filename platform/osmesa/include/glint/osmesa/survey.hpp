// What OSMesa offers on this machine, and why it is missing if it is.
#pragma once

#include <string>

#include <glint/export.hpp>
#include <glint/gles/context_facts.hpp>

namespace glint::osmesa {

/// What OSMesa offers.
struct Survey {
    std::string missing; ///< why there is none; empty where there is
    std::string hint;    ///< what to install then
    gles::ContextFacts facts;
};

/// Tries it. Afterwards no OSMesa context is current in this thread.
[[nodiscard]] GLINT_API Survey survey();

} // namespace glint::osmesa
