// From a draft back to SDL text, in the canonical dialect.
#include "sdl/write_scene.hpp"

#include <filesystem>
#include <initializer_list>
#include <map>
#include <string_view>

#include "sdl/dialects.hpp"
#include "sdl/sample_patterns.hpp"
#include "sdl/sdl_table.hpp"
#include "text/shortest.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// A directive being put together.
class Directive {
public:
    explicit Directive(std::string_view keyword) : line_(keyword) {}

    Directive &word(std::string_view word) {
        line_ += ' ';
        line_ += word;
        return *this;
    }
    Directive &whole(uint64_t number) { return word(std::to_string(number)); }
    Directive &number(float value) { return word(shortest(value)); }
    Directive &numbers(std::initializer_list<float> values) {
        for (const float value : values) number(value);
        return *this;
    }
    Directive &triple(const glm::vec3 &v) { return numbers({v.x, v.y, v.z}); }
    Directive &quadric(const Quadric &q) { return numbers({q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.j, q.k}); }
    /// r g b ka kd ks n kr kt ior
    Directive &material(const Material &m) {
        return triple(m.color).numbers(
            {m.ambient, m.diffuse, m.specular, m.specular_exponent, m.reflection, m.transmission, m.ior});
    }
    /// r g b I
    Directive &glow(const Light &light) { return triple(light.color).number(light.intensity); }
    Directive &falloff(const Light &light) { return light.has_falloff ? word("falloff").word("on") : *this; }

    [[nodiscard]] const std::string &line() const { return line_; }

private:
    std::string line_;
};

class SceneWriter {
public:
    SceneWriter(const SceneDraft &draft, FileNames &names, Problems &problems)
        : draft_(draft), names_(names), problems_(problems) {}

    std::string write() {
        write_camera();
        write_picture();
        write_optics();
        for (const LightDraft &light : draft_.lights) write_light(light);
        for (const ObjectDraft &object : draft_.objects) write_object(object);
        write_motion();
        std::string text = words("dialect ", dialect_name(Dialect::glint), '\n');
        for (const SdlTable *table : {&camera_, &picture_, &optics_, &lights_, &objects_, &motion_}) {
            text += table->text();
        }
        return text;
    }

private:
    void write_camera() {
        camera_.add(Directive("eye").triple(draft_.eye->value).line());
        if (!draft_.target) {
            const Window window = draft_.ortho ? draft_.ortho->value : Window{};
            camera_.add(Directive("ortho").numbers({window.x0, window.y0, window.x1, window.y1}).line());
            return;
        }
        camera_.add(Directive("target").triple(draft_.target->value).line());
        if (draft_.up) camera_.add(Directive("up").triple(draft_.up->value).line());
        if (draft_.window_size) {
            const WindowSize &size = draft_.window_size->value;
            camera_.add(Directive("window_size").numbers({size.width, size.height}).line());
        }
        if (draft_.fov) camera_.add(Directive("fov").number(draft_.fov->value).line());
    }

    void write_picture() {
        const PictureSettings &picture = draft_.picture;
        const PictureSettings defaults;
        picture_.add(Directive("size").whole(picture.width_px).whole(picture.height_px).line());
        picture_.add(Directive("background").triple(draft_.background).line());
        picture_.add(Directive("ambient").number(draft_.ambient).line());
        picture_.add(Directive("max_depth").whole(picture.max_depth).line());
        if (picture.samples_per_pixel != defaults.samples_per_pixel || picture.pattern != defaults.pattern) {
            picture_.add(Directive("samples")
                             .whole(picture.samples_per_pixel)
                             .word(sample_pattern_name(picture.pattern))
                             .line());
        }
        if (picture.paths_per_pixel != defaults.paths_per_pixel) {
            picture_.add(Directive("npaths").whole(picture.paths_per_pixel).line());
        }
        if (picture.tone_scale != defaults.tone_scale) {
            picture_.add(Directive("tonemapping").number(picture.tone_scale).line());
        }
        if (picture.seed != defaults.seed) picture_.add(Directive("seed").whole(picture.seed).line());
        if (draft_.output_file) {
            names_.keep(*draft_.output_file);
            picture_.add(Directive("output").word(*draft_.output_file).line());
        }
    }

    void write_optics() {
        const auto switched_on = [&](const char *keyword, bool on) {
            if (on) optics_.add(Directive(keyword).word("on").line());
        };
        switched_on("reflection_adds", draft_.reflection_adds == true);
        switched_on("fresnel", draft_.optics.fresnel);
        switched_on("shadows_through_glass", draft_.optics.shadows_through_glass);
        if (draft_.shadow_rays != 1) optics_.add(Directive("nshadowrays").whole(draft_.shadow_rays).line());
        if (draft_.grid_width > 0) {
            optics_.add(Directive("lightresolution").whole(draft_.grid_width).whole(draft_.grid_height).line());
        }
    }

    void write_light(const LightDraft &entry) {
        const Light &light = entry.light;
        switch (light.kind) {
        case Light::Kind::surface:
            if (light.quadric) {
                lights_.add(Directive("light_quadric").quadric(*light.quadric).glow(light).line());
            } else {
                Directive directive = Directive("light").word(name_of(entry.file)).glow(light);
                if (light.position) directive.triple(*light.position);
                lights_.add(directive.line());
            }
            break;
        case Light::Kind::point:
            lights_.add(Directive("light_point").triple(*light.position).glow(light).falloff(light).line());
            break;
        case Light::Kind::directional:
            lights_.add(Directive("light_directional").triple(light.direction).glow(light).line());
            break;
        case Light::Kind::spot:
            lights_.add(Directive("light_spot")
                            .triple(*light.position)
                            .triple(light.direction)
                            .numbers({entry.inner_degrees, entry.outer_degrees})
                            .glow(light)
                            .falloff(light)
                            .line());
            break;
        }
    }

    void write_object(const ObjectDraft &entry) {
        if (entry.from_mtl) {
            objects_.add(Directive("object").word(name_of(entry.file)).word("mtl").line());
            return;
        }
        for (const Object &object : entry.parts) {
            if (object.quadric) {
                objects_.add(Directive("objectquadric").quadric(*object.quadric).material(object.material).line());
            } else {
                objects_.add(Directive("object")
                                 .word(name_of(entry.file))
                                 .triple(entry.offset)
                                 .material(object.material)
                                 .line());
            }
        }
    }

    /// Objects by number, which their names may not be enough to tell apart.
    void write_motion() {
        for (const EyeKeyDraft &key : draft_.motion.eye) {
            motion_.add(Directive("animate_eye").number(key.time_s).triple(key.eye).line());
        }
        for (const ObjectKeyDraft &key : draft_.motion.objects) {
            Directive line = Directive("animate_object").whole(key.object + 1);
            switch (key.kind) {
            case ObjectKeyDraft::Kind::translate:
                line.number(key.time_s).word("translate").triple(key.value);
                break;
            case ObjectKeyDraft::Kind::rotate:
                line.number(key.time_s).word("rotate").triple(key.value).number(key.degrees);
                break;
            case ObjectKeyDraft::Kind::pivot:
                line.word("pivot").triple(key.value);
                break;
            }
            motion_.add(line.line());
        }
    }

    const std::string &name_of(const std::filesystem::path &file) {
        const auto [entry, is_new] = known_names_.try_emplace(file);
        if (!is_new) return entry->second;
        Result<std::string> name = names_.name_of(file);
        if (name.ok()) {
            entry->second = std::move(name).value();
        } else {
            problems_.adopt(std::move(name).error());
        }
        return entry->second;
    }

    const SceneDraft &draft_;
    FileNames &names_;
    Problems &problems_;
    std::map<std::filesystem::path, std::string> known_names_;
    SdlTable camera_{"Camera", SdlTable::Of::settings}, picture_{"Picture", SdlTable::Of::settings},
        optics_{"How light behaves", SdlTable::Of::settings}, lights_{"Lights", SdlTable::Of::surfaces},
        objects_{"Objects", SdlTable::Of::surfaces}, motion_{"Motion", SdlTable::Of::surfaces};
};

} // namespace

std::string write_scene(const SceneDraft &draft, FileNames &names, Problems &problems) {
    return SceneWriter(draft, names, problems).write();
}

} // namespace glint
