// glint surfaces: what this machine can show pictures on, and why it cannot show them on the rest.
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glint/egl/survey.hpp>
#include <glint/osmesa/survey.hpp>

#include "command.hpp"
#include "console.hpp"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *examples =
    R"(Tries every display that EGL knows and OSMesa, and says what each offers, or why it is missing
and what to install. The exit code is 0 in any case: nothing to show pictures on is an answer,
and rendering to files needs none of it.

Examples:
  glint surfaces
  glint surfaces --json | python3 -m json.tool)";

/// "No" and why, on lines of their own below a heading.
std::string missing_text(const std::string &why, const std::string &hint) {
    std::string text = fmt::format("  missing: {}\n", why);
    if (!hint.empty()) text += fmt::format("    {}\n", hint);
    return text;
}

std::string facts_text(const gles::ContextFacts &facts) {
    return fmt::format("{}, {}\n    textures up to {} px, drawing up to {} x {} px{}{}\n", facts.version,
                       facts.renderer, facts.max_texture_px, facts.max_viewport_width_px, facts.max_viewport_height_px,
                       facts.takes_bgra ? ", BGRA" : "", facts.tells_loss ? ", says when it is lost" : "");
}

std::string display_text(const egl::DisplaySurvey &display) {
    std::string text =
        fmt::format("EGL {}{}\n", display.platform, display.detail.empty() ? "" : " (" + display.detail + ")");
    if (!display.missing.empty()) return text + missing_text(display.missing, display.hint);
    text += fmt::format("  EGL {}, {}{}\n", display.version, display.vendor,
                        display.surfaceless_contexts ? ", contexts without a surface" : "");
    for (const egl::GlesSurvey &gles : display.gles) {
        text += fmt::format("  OpenGL ES {}: ", gles.version);
        text += gles.missing.empty() ? facts_text(gles.facts) : gles.missing + '\n';
    }
    return text;
}

std::string to_text(const egl::Survey &egl, const osmesa::Survey &mesa) {
    std::string text;
    if (!egl.missing.empty()) text += "EGL\n" + missing_text(egl.missing, egl.hint);
    for (const egl::DisplaySurvey &display : egl.displays) text += display_text(display);
    text += "OSMesa\n";
    text += mesa.missing.empty() ? "  " + facts_text(mesa.facts) : missing_text(mesa.missing, mesa.hint);
    if (!egl.client_extensions.empty()) {
        text += "EGL's client extensions\n ";
        for (const std::string &extension : egl.client_extensions) text += ' ' + extension;
        text += '\n';
    }
    if (!egl.has_context() && !mesa.missing.empty()) {
        text += "\nThere is nothing to show pictures on. To show them, install libegl1 and libgl1-mesa-dri (Debian, "
                "Ubuntu);\nwithout, 'glint render' still writes them to files.\n";
    }
    return text;
}

Json absence(const std::string &why, const std::string &hint) {
    return {{"available", false}, {"missing", why}, {"hint", hint}};
}

Json to_json(const gles::ContextFacts &facts) {
    return {{"available", true},
            {"gl_version", facts.version},
            {"vendor", facts.vendor},
            {"renderer", facts.renderer},
            {"max_texture", facts.max_texture_px},
            {"max_viewport", {facts.max_viewport_width_px, facts.max_viewport_height_px}},
            {"bgra", facts.takes_bgra},
            {"tells_loss", facts.tells_loss}};
}

Json to_json(const egl::DisplaySurvey &display) {
    Json json = {{"platform", display.platform}, {"detail", display.detail}};
    if (!display.missing.empty()) {
        json.update(absence(display.missing, display.hint));
        return json;
    }
    Json contexts = Json::array();
    for (const egl::GlesSurvey &gles : display.gles) {
        Json context = {{"gles", gles.version}};
        context.update(gles.missing.empty() ? to_json(gles.facts) : absence(gles.missing, ""));
        contexts.push_back(std::move(context));
    }
    json.update({{"available", true},
                 {"egl_version", display.version},
                 {"vendor", display.vendor},
                 {"surfaceless_contexts", display.surfaceless_contexts},
                 {"contexts", std::move(contexts)}});
    return json;
}

std::string to_json_text(const egl::Survey &egl, const osmesa::Survey &mesa) {
    Json displays = Json::array();
    for (const egl::DisplaySurvey &display : egl.displays) displays.push_back(to_json(display));
    Json egl_json = egl.missing.empty() ? Json{{"available", true}} : absence(egl.missing, egl.hint);
    egl_json["client_extensions"] = egl.client_extensions;
    egl_json["displays"] = std::move(displays);
    const Json report = {{"egl", std::move(egl_json)},
                         {"osmesa", mesa.missing.empty() ? to_json(mesa.facts) : absence(mesa.missing, mesa.hint)}};
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; // drivers need not speak UTF-8
}

ExitCode run(bool json) {
    const egl::Survey egl = egl::survey();
    const osmesa::Survey mesa = osmesa::survey();
    print(json ? to_json_text(egl, mesa) : to_text(egl, mesa));
    return ExitCode::ok;
}

} // namespace

Command add_surfaces_command(CLI::App &parser) {
    auto json = std::make_shared<bool>(false);
    CLI::App *surfaces = parser.add_subcommand("surfaces", "Say what this machine can show pictures on");
    surfaces->add_flag("--json", *json, "Print JSON");
    surfaces->footer(examples);
    return {surfaces, [json] { return run(*json); }};
}

} // namespace glint::cli
