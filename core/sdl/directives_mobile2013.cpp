// What only the 2013 dialect has: its nine-number object.
#include "sdl/arguments.hpp"
#include "sdl/directives.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

void read_mobile2013_object(const Arguments &arguments, SceneDraft &draft) {
    const auto fraction = [&](size_t i) { return arguments.number(i, 0.0f, 1.0f); };
    Object object;
    object.name = std::string(arguments.word(0));
    Material &material = object.material;
    material.color = arguments.numbers(1, 0.0f, 1.0f);
    material.ambient = fraction(4);
    material.diffuse = fraction(5);
    material.specular = fraction(6);
    material.specular_exponent = arguments.number(7, 0.0f, max_intensity);
    material.reflection = fraction(8);
    material.transmission = fraction(9);
    // The tolerance is the scene builder's: decimals such as 0.7 + 0.3 may round to a little more than 1.
    if (material.reflection + material.transmission > 1.0f + 1e-6f) {
        arguments.error(
            8,
            words("kr + kt is more than 1 (", in_quotes(arguments.word(8)), " + ", in_quotes(arguments.word(9)), ")"),
            "kr and kt are shares of the surface's colour");
    }
    object.mesh = read_mesh(arguments, 0, draft);
    draft.objects.push_back(std::move(object));
}

} // namespace glint
