// The table of directives. Everything that tells one SDL dialect from another stands here.
//
// To add a directive: add a row, with a handler in directives_*.cpp. To add a dialect: name it in dialects.hpp, add it
// to `names` below, and give it rows. A row says
//   usage     how the directive is written; the words also name the arguments in messages
//   dialects  which dialects have it
//   evidence  which dialects a file with such a line belongs to; `nothing` where every dialect may have the line
//   handler   what it does, or `not_yet`: then a file that has it is refused, by name, never read without it
//   role      whether it adds a light or an object; all else is a setting, which a file may give once
// Where a line fits several rows, the evidence is for any of their dialects. Detection (detect.cpp) looks at nothing
// else, so a dialect's rows are here before this version can read it: that is how a file of it is recognised and
// refused. Once a dialect has its handlers, set it in `supported`.
#include "sdl/dialects.hpp"

#include <algorithm>

#include "sdl/directives.hpp"
#include "text/number.hpp"

namespace glint {

namespace {

constexpr std::array<std::string_view, dialect_count> names = {"mobile2013", "path2005", "ray2005", "cg-path-tracer",
                                                               "raycife"};
constexpr DialectSet supported = Dialect::mobile2013;

constexpr Dialect mobile = Dialect::mobile2013, path = Dialect::path2005, ray = Dialect::ray2005,
                  cg = Dialect::cg_path_tracer, cife = Dialect::raycife;
constexpr DialectSet all = DialectSet::all();
constexpr DialectSet nothing;
constexpr DirectiveHandler not_yet = nullptr;
constexpr auto light = DirectiveForm::Role::light, object = DirectiveForm::Role::object;

// clang-format off
constexpr DirectiveForm forms[] = {
    // usage                                         dialects     evidence  handler           role
    {"dialect name",                                 all,         nothing,  read_dialect},
    {"eye x y z",                                    all,         nothing,  read_eye},
    {"target x y z",                                 all,         nothing,  not_yet},
    {"up x y z",                                     all,         nothing,  not_yet},
    {"window_size w h",                              all,         nothing,  not_yet},
    {"fov degrees",                                  all,         nothing,  not_yet},
    {"ortho x0 y0 x1 y1",                            all,         nothing,  read_ortho},
    {"size w h",                                     all,         nothing,  read_size},
    {"background r g b",                             all,         nothing,  read_background},
    {"ambient Ia",                                   all,         nothing,  read_ambient},
    {"output file",                                  all,         nothing,  read_output},

    {"max_depth n",                                  all,         mobile,   read_max_depth},
    {"maxdepth n",                                   all,         cg,       read_max_depth},
    {"profundidade n",                               all,         ray,      read_max_depth},
    {"reflections n",                                all,         nothing,  read_max_depth},

    {"supersample on/off",                           all,         ray,      not_yet},
    {"npaths n",                                     all,         path,     not_yet},
    {"tonemapping t",                                all,         path,     not_yet},
    {"seed n",                                       all,         path,     not_yet},
    {"nshadowrays n",                                all,         nothing,  not_yet},
    {"lightresolution w h",                          all,         cg,       not_yet},

    {"light file.obj r g b I",                       all,         nothing,  read_mesh_light,  light},
    {"light file.obj r g b I x y z",                 cife,        cife,     not_yet,          light},
    {"light x y z I",                                ray,         ray,      not_yet,          light},
    {"lightpoint x y z r g b I",                     cg,          cg,       not_yet,          light},
    {"lightarea file.obj r g b I",                   cg,          cg,       not_yet,          light},

    {"object file.obj r g b ka kd ks ke kr kt",      mobile,      mobile,   read_mobile2013_object, object},
    {"object file.obj r g b ka kd ks kt n [ior]",    path,        path,     not_yet,          object},
    {"object file.obj dx dy dz r g b ka kd ks n kr kt ior",
                                                     cg,          cg,       not_yet,          object},
    {"object a b c d e f g h j k r g b ka kd ks n kr kt ior",
                                                     DialectSet(ray) | cg,
                                                                  DialectSet(ray) | cg,
                                                                            not_yet,          object},
    {"objectquadric a b c d e f g h j k r g b ka kd ks n kr kt ior",
                                                     DialectSet(ray) | cg,
                                                                  DialectSet(ray) | cg,
                                                                            not_yet,          object},
    {"objectquadric a b c d e f g h j k r g b ka kd ks kt n [ior]",
                                                     path,        path,     not_yet,          object},
    {"quadric a b c d e f g h j k r g b ka kd ks kt n [ior]",
                                                     path,        path,     not_yet,          object},
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

bool is_supported(Dialect dialect) {
    return supported.has(dialect);
}

std::optional<Dialect> DialectSet::only() const {
    for (size_t i = 0; i < dialect_count; ++i) {
        if (*this == DialectSet(static_cast<Dialect>(i))) return static_cast<Dialect>(i);
    }
    return std::nullopt;
}

std::string DialectSet::names() const {
    std::string text;
    for (size_t i = 0; i < dialect_count; ++i) {
        if (!has(static_cast<Dialect>(i))) continue;
        if (!text.empty()) text += " or ";
        text += dialect_name(static_cast<Dialect>(i));
    }
    return text;
}

size_t DirectiveForm::least_arguments() const {
    size_t least = most_arguments();
    while (least > 0 && argument(least - 1).starts_with('[')) --least;
    return least;
}

bool DirectiveForm::fits(const Line &line) const {
    if (line.argument_count < least_arguments() || line.argument_count > most_arguments()) return false;
    if (line.argument_count == 0) return true;
    float value = 0.0f;
    const bool starts_with_number = !read_number(line.tokens[1].text, value);
    return is_path(0) != starts_with_number || argument(0) == "name" || argument(0) == "on/off";
}

std::span<const DirectiveForm> directive_forms() {
    return forms;
}

std::span<const DirectiveForm> forms_of(std::string_view keyword) {
    std::string lower(keyword.substr(0, 64));
    for (char &c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const auto is_it = [&](const DirectiveForm &form) { return form.keyword() == lower; };
    const auto begin = std::find_if(std::begin(forms), std::end(forms), is_it);
    return {begin, std::find_if_not(begin, std::end(forms), is_it)};
}

} // namespace glint
