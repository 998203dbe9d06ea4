// Trying OSMesa.
#include <glint/osmesa/survey.hpp>

#include <utility>

#include <glint/osmesa/surface.hpp>

#include "osmesa/library.hpp"

namespace glint::osmesa {

Survey survey() {
    Survey result;
    const auto missing = [&result](const Error &error) {
        result.missing = error.diagnostics.front().message;
        result.hint = OsMesa::default_names().install_hint;
        return result;
    };
    const Result<std::unique_ptr<gles::Surface>> surface = create(1, 1);
    if (!surface) return missing(surface.error());
    Result<gles::ContextFacts> facts = gles::describe_context(surface.value()->proc_loader());
    if (!facts) return missing(facts.error());
    result.facts = std::move(facts).value();
    return result;
}

} // namespace glint::osmesa
