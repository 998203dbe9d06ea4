// The table of directives. Everything that tells one SDL dialect from another stands here.
//
// To add a directive: add a row, with a handler in directives_*.cpp. To add a dialect: name it in dialects.hpp, add it
// to `names` below, and give it rows. A row says
//   usage     how the directive is written; the words also name the arguments in messages
//   dialects  which dialects have it
//   evidence  which dialects a file with such a line belongs to; `nothing` where every dialect may have the line
//   handler   what it does
//   role      whether it adds a light, an object or a step of a motion; all else is a setting, which a file may give
//   once
// Where a line fits several rows, the evidence is for any of their dialects. Detection (detect.cpp) looks at nothing
// else.
//
// Directives of one dialect that mean the same everywhere are taken in files of the others, too: where one says
// `dialect` and then `maxdepth`, nothing is left to guess.
#include "sdl/dialects.hpp"

#include <algorithm>

#include "sdl/directives.hpp"
#include "text/number.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

constexpr std::array<std::string_view, dialect_count> names = {"mobile2013",     "path2005", "ray2005",
                                                               "cg-path-tracer", "raycife",  "glint"};

constexpr Dialect mobile = Dialect::mobile2013, path = Dialect::path2005, ray = Dialect::ray2005,
                  cg = Dialect::cg_path_tracer, cife = Dialect::raycife, own = Dialect::glint;
constexpr DialectSet all = DialectSet::all();
constexpr DialectSet nothing;
/// raycife is path2005 with one more form of `light`.
constexpr DialectSet paths = DialectSet(path) | cife;
constexpr DialectSet tracers = paths | cg;
constexpr auto light = DirectiveForm::Role::light, object = DirectiveForm::Role::object,
               motion = DirectiveForm::Role::motion;

// clang-format off
constexpr DirectiveForm forms[] = {
    // usage                                                  dialects     evidence  handler           role
    {"dialect name",                                          all,         nothing,  read_dialect},
    {"eye x y z",                                             all,         nothing,  read_eye},
    {"target x y z",                                          all,         nothing,  read_target},
    {"up x y z",                                              all,         nothing,  read_up},
    {"window_size w h",                                       all,         nothing,  read_window_size},
    {"fov degrees",                                           all,         nothing,  read_fov},
    {"ortho x0 y0 x1 y1",                                     all,         nothing,  read_ortho},
    {"size w h",                                              all,         nothing,  read_size},
    {"background r g b",                                      all,         nothing,  read_background},
    {"ambient Ia",                                            all,         nothing,  read_ambient},
    {"output file",                                           all,         nothing,  read_output},

    {"max_depth n",                                           all,         mobile,   read_max_depth},
    {"maxdepth n",                                            all,         cg,       read_max_depth},
    {"profundidade n",                                        all,         ray,      read_max_depth},
    {"reflections n",                                         all,         nothing,  read_max_depth},

    {"supersample on/off",                                    all,         ray,      read_supersample},
    {"npaths n",                                              all,         tracers,  read_npaths},
    {"tonemapping t",                                         all,         tracers,  read_tonemapping},
    {"seed n",                                                all,         tracers,  read_seed},
    {"nshadowrays n",                                         all,         nothing,  read_nshadowrays},
    {"lightresolution w h",                                   all,         cg,       read_lightresolution},

    // Extensions: see scenes/sdl/README.md.
    {"samples n [pattern]",                                   all,         nothing,  read_samples},
    {"reflection_adds on/off",                                all,         nothing,  read_reflection_adds},
    {"fresnel on/off",                                        all,         nothing,  read_fresnel},
    {"shadows_through_glass on/off",                          all,         nothing,  read_shadows_through_glass},
    {"animate_eye time x y z",                                all,         nothing,  read_eye_move,          motion},
    {"animate_object name 'pivot' x y z",                     all,         nothing,  read_object_pivot,      motion},
    {"animate_object name time 'translate' x y z",            all,         nothing,  read_object_move,       motion},
    {"animate_object name time 'rotate' ax ay az degrees",    all,         nothing,  read_object_turn,       motion},

    {"light file.obj r g b I",                                all,         nothing,  read_mesh_light,        light},
    {"light file.obj r g b I x y z",                          DialectSet(cife) | own,
                                                                           cife,     read_aimed_light,       light},
    {"light x y z I",                                         ray,         ray,      read_white_point_light, light},
    {"lightpoint x y z r g b I",                              cg,          cg,       read_point_light,       light},
    {"lightarea file.obj r g b I",                            cg,          cg,       read_mesh_light,        light},
    {"light_point x y z r g b I ['falloff'] [on/off]",        all,         nothing,  read_point_light,       light},
    {"light_directional dx dy dz r g b I",                    all,         nothing,  read_directional_light, light},
    {"light_spot x y z dx dy dz inner outer r g b I ['falloff'] [on/off]",
                                                              all,         nothing,  read_spot_light,        light},
    {"light_quadric a b c d e f g h j k r g b I",             all,         nothing,  read_quadric_light,     light},

    {"object file.obj r g b ka kd ks ke kr kt",               mobile,      mobile,   read_mobile2013_object, object},
    {"object file.obj r g b ka kd ks kt n [ior]",             paths,       paths,    read_path2005_object,   object},
    {"object file.obj dx dy dz r g b ka kd ks n kr kt ior",   DialectSet(cg) | own,
                                                                           cg,       read_moved_object,      object},
    {"object file.obj 'mtl'",                                 all,         nothing,  read_mtl_object,        object},
    {"object a b c d e f g h j k r g b ka kd ks n kr kt ior", DialectSet(ray) | own,
                                                                           ray,      read_ray2005_quadric,   object},
    {"object a b c d e f g h j k r g b ka kd ks n kr kt ior", cg,          cg,       read_cg_quadric,        object},
    {"objectquadric a b c d e f g h j k r g b ka kd ks n kr kt ior",
                                                              DialectSet(ray) | own,
                                                                           ray,      read_ray2005_quadric,   object},
    {"objectquadric a b c d e f g h j k r g b ka kd ks n kr kt ior",
                                                              cg,          cg,       read_cg_quadric,        object},
    {"objectquadric a b c d e f g h j k r g b ka kd ks kt n [ior]",
                                                              paths,       paths,    read_path2005_quadric,  object},
    {"quadric a b c d e f g h j k r g b ka kd ks kt n [ior]", paths,       paths,    read_path2005_quadric,  object},
};
// clang-format on

} // namespace

std::string_view dialect_name(Dialect dialect) {
    return names[static_cast<size_t>(dialect)];
}

std::optional<Dialect> dialect_named(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Dialect>(found - names.begin());
}

bool adds_reflections(Dialect dialect) {
    return dialect != Dialect::mobile2013 && dialect != Dialect::glint;
}

std::optional<Dialect> DialectSet::only() const {
    for (size_t i = 0; i < dialect_count; ++i) {
        if (*this == DialectSet(static_cast<Dialect>(i))) return static_cast<Dialect>(i);
    }
    return std::nullopt;
}

std::string DialectSet::names() const {
    std::string text;
    DialectSet left = *this;
    for (size_t i = 0; i < dialect_count; ++i) {
        const auto dialect = static_cast<Dialect>(i);
        if (!has(dialect)) continue;
        left = left.without(dialect);
        if (!text.empty()) text += left.empty() ? " or " : ", ";
        text += dialect_name(dialect);
    }
    return text;
}

size_t DirectiveForm::least_arguments() const {
    size_t least = most_arguments();
    while (least > 0 && is_optional(least - 1)) --least;
    return least;
}

bool DirectiveForm::starts_like(const Line &line) const {
    if (line.argument_count == 0 || argument(0) == "name" || argument(0) == "on/off") return true;
    float value = 0.0f;
    const bool starts_with_number = !read_number(line.tokens[1].text, value);
    return is_path(0) != starts_with_number;
}

bool DirectiveForm::has_words_of(const Line &line) const {
    const size_t needed = least_arguments();
    for (size_t i = 0; i < most_arguments(); ++i) {
        const std::string_view name = argument(i);
        if (!name.starts_with('\'')) continue;
        const bool is_there = i < line.argument_count && i + 1 < line.tokens.size();
        if (is_there ? name.substr(1, name.size() - 2) != line.tokens[i + 1].text : i < needed) return false;
    }
    return true;
}

bool DirectiveForm::fits(const Line &line) const {
    if (line.argument_count < least_arguments() || line.argument_count > most_arguments()) return false;
    return starts_like(line) && has_words_of(line);
}

std::span<const DirectiveForm> directive_forms() {
    return forms;
}

std::span<const DirectiveForm> forms_of(std::string_view keyword) {
    const std::string lower = lower_case(keyword.substr(0, 64));
    const auto is_it = [&](const DirectiveForm &form) { return form.keyword() == lower; };
    const auto begin = std::find_if(std::begin(forms), std::end(forms), is_it);
    return {begin, std::find_if_not(begin, std::end(forms), is_it)};
}

} // namespace glint
