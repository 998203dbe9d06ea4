// A converted scene file says what the old one said, to the last bit, and converts into itself.
#include <cstring>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glint/glint.hpp>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

class Conversion : public WrittenFiles {
protected:
    void SetUp() override {
        WrittenFiles::SetUp();
        write("wall.obj", "v -1 -1 -4\nv 1 -1 -4\nv 1 1 -4.5\nv -1 1 -4.5\nf 1 2 3 4\n");
        write("lamp.obj", "v -0.2 0.8 -3.2\nv 0.2 0.8 -3.2\nv 0.2 0.8 -2.8\nv -0.2 0.8 -2.8\nf 1 2 3 4\n");
    }

    /// Reads `text` as a file and converts it for the folder it lies in.
    [[nodiscard]] ConvertedScene convert(std::string_view text, const ReadOptions &options = {}) const {
        return converted(write("old.sdl", text), in_folder(""), options);
    }
    [[nodiscard]] static ConvertedScene converted(const fs::path &file, const fs::path &folder,
                                                  const ReadOptions &options = {}) {
        auto scene = convert_scene(file, folder, options);
        if (!scene.ok()) throw std::runtime_error(scene.error().text());
        return std::move(scene).value();
    }
};

bool same_bits(const void *a, const void *b, size_t size) {
    return std::memcmp(a, b, size) == 0;
}
template <typename Vec> bool same_vec(const Vec &a, const Vec &b) {
    return same_bits(&a, &b, sizeof(a));
}
template <typename Vec> bool same_vec(const std::optional<Vec> &a, const std::optional<Vec> &b) {
    return a.has_value() == b.has_value() && (!a || same_vec(*a, *b));
}

void expect_same(const std::shared_ptr<const Mesh> &a, const std::shared_ptr<const Mesh> &b) {
    ASSERT_EQ(a == nullptr, b == nullptr);
    if (!a) return;
    ASSERT_EQ(a->positions.size(), b->positions.size());
    EXPECT_TRUE(same_bits(a->positions.data(), b->positions.data(), a->positions.size() * sizeof(Point)));
    EXPECT_EQ(a->triangles, b->triangles);
}

void expect_same(const Material &a, const Material &b) {
    EXPECT_TRUE(same_vec(a.color, b.color));
    const auto numbers = [](const Material &m) {
        return std::vector<float>{m.ambient,    m.diffuse,      m.specular, m.specular_exponent,
                                  m.reflection, m.transmission, m.ior};
    };
    EXPECT_EQ(numbers(a), numbers(b));
    EXPECT_EQ(a.adds_to_local, b.adds_to_local);
}

void expect_same(const Light &a, const Light &b) {
    EXPECT_EQ(a.kind, b.kind);
    expect_same(a.mesh, b.mesh);
    EXPECT_TRUE(same_vec(a.color, b.color));
    EXPECT_TRUE(same_vec(a.quadric, b.quadric));
    EXPECT_TRUE(same_vec(a.position, b.position));
    EXPECT_TRUE(same_vec(a.direction, b.direction));
    EXPECT_EQ(a.intensity, b.intensity);
    EXPECT_EQ(a.inner_angle, b.inner_angle);
    EXPECT_EQ(a.outer_angle, b.outer_angle);
    EXPECT_EQ(a.has_falloff, b.has_falloff);
    EXPECT_EQ(a.shadow_rays, b.shadow_rays);
    EXPECT_EQ(a.grid_width, b.grid_width);
    EXPECT_EQ(a.grid_height, b.grid_height);
}

void expect_same(const PictureSettings &a, const PictureSettings &b) {
    EXPECT_EQ(a.width_px, b.width_px);
    EXPECT_EQ(a.height_px, b.height_px);
    EXPECT_EQ(a.max_depth, b.max_depth);
    EXPECT_EQ(a.samples_per_pixel, b.samples_per_pixel);
    EXPECT_EQ(a.pattern, b.pattern);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.tone_scale, b.tone_scale);
    EXPECT_EQ(a.paths_per_pixel, b.paths_per_pixel);
}

/// All that a picture could depend on.
void expect_same(const Scene &a, const Scene &b) {
    ASSERT_EQ(a.objects().size(), b.objects().size());
    for (size_t i = 0; i < a.objects().size(); ++i) {
        SCOPED_TRACE(testing::Message() << "object " << i);
        expect_same(a.objects()[i].mesh, b.objects()[i].mesh);
        expect_same(a.objects()[i].material, b.objects()[i].material);
        EXPECT_TRUE(same_vec(a.objects()[i].quadric, b.objects()[i].quadric));
    }
    ASSERT_EQ(a.lights().size(), b.lights().size());
    for (size_t i = 0; i < a.lights().size(); ++i) {
        SCOPED_TRACE(testing::Message() << "light " << i);
        expect_same(a.lights()[i], b.lights()[i]);
    }
    EXPECT_TRUE(same_vec(a.camera(), b.camera()));
    expect_same(a.picture(), b.picture());
    EXPECT_TRUE(same_vec(a.background(), b.background()));
    EXPECT_EQ(a.ambient(), b.ambient());
    EXPECT_EQ(a.optics().fresnel, b.optics().fresnel);
    EXPECT_EQ(a.optics().shadows_through_glass, b.optics().shadows_through_glass);
}

/// The number of pixels and hash of what a scene looks like.
uint64_t picture_hash(const std::shared_ptr<const Scene> &scene) {
    Renderer renderer(Accel::build(scene), {.threads = 1});
    auto picture = Framebuffer::create(scene->picture().width_px, scene->picture().height_px);
    if (!picture || !renderer.render(*picture)) throw std::runtime_error("cannot render");
    return picture->radiance_hash();
}

TEST_F(Conversion, writes_all_that_a_file_can_say) {
    const ConvertedScene scene = convert("dialect glint\n"
                                         "eye 1 2 3\ntarget 0.1 0 -3.25\nup 0 1 0.5\nfov 40\nsize 640 480\n"
                                         "background 0.1 0.2 0.3\nambient 0.9\nreflections 5\nsamples 16 jittered\n"
                                         "npaths 0\ntonemapping 1.5\nseed 4294967295\noutput a.png\n"
                                         "reflection_adds on\nfresnel on\nshadows_through_glass on\n"
                                         "nshadowrays 9\nlightresolution 3 4\n"
                                         "light lamp.obj 1 0.5 0.25 2\n"
                                         "light_point 1 2 3 1 1 1 0.5 falloff on\n"
                                         "light_point -10 2 3 1 1 1 0.5\n"
                                         "light_directional 0 -1 0.5 1 0.9 0.8 0.7\n"
                                         "light_spot 0 3 0 0 -1 0 10 22.5 1 1 1 1\n"
                                         "light_quadric 1 1 1 0 0 0 0 -2 0 3.99 1 1 0.5 1\n"
                                         "light lamp.obj 1 1 1 1 0 0.75 -3\n"
                                         "object wall.obj 0 0 0 0.5 0 0.125 .3 0.7 1e-1 10 0.75 0.25 1.5\n"
                                         "objectquadric 1 1 1 0 0 0 0 0 4 15 1 1 1 0.1 0.2 0.3 5 0 1 1.33\n"
                                         "object wall.obj 0 -0.5 1e-7 1 1 1 1 1 1 0 0 0 1\n");
    EXPECT_EQ(scene.text, R"(dialect glint

# Camera
eye    1 2 3
target 0.1 0 -3.25
up     0 1 0.5
fov    40

# Picture
size        640 480
background  0.1 0.2 0.3
ambient     0.9
max_depth   5
samples     16 jittered
npaths      0
tonemapping 1.5
seed        4294967295
output      a.png

# How light behaves
reflection_adds       on
fresnel               on
shadows_through_glass on
nshadowrays           9
lightresolution       3 4

# Lights
#light file.obj r g   b    I
light  lamp.obj 1 0.5 0.25 2
#light_point x y z r g b I   falloff on/off
light_point  1 2 3 1 1 1 0.5 falloff on
#light_point x   y z r g b I
light_point  -10 2 3 1 1 1 0.5
#light_directional dx dy dz  r g   b   I
light_directional  0  -1 0.5 1 0.9 0.8 0.7
#light_spot x y z dx dy dz inner outer r g b I
light_spot  0 3 0 0  -1 0  10    22.5  1 1 1 1
#light_quadric a b c d e f g h  j k    r g b   I
light_quadric  1 1 1 0 0 0 0 -2 0 3.99 1 1 0.5 1
#light file.obj r g b I x y    z
light  lamp.obj 1 1 1 1 0 0.75 -3

# Objects
#object file.obj dx dy   dz    r   g b     ka  kd  ks  n  kr   kt   ior
object  wall.obj 0  0    0     0.5 0 0.125 0.3 0.7 0.1 10 0.75 0.25 1.5
#objectquadric a b c d e f g h j k  r g b ka  kd  ks  n kr kt ior
objectquadric  1 1 1 0 0 0 0 0 4 15 1 1 1 0.1 0.2 0.3 5 0  1  1.33
object  wall.obj 0  -0.5 1e-07 1   1 1     1   1   1   0  0    0    1
)");
    EXPECT_EQ(scene.source.dialect, "glint");
    EXPECT_EQ(scene.scene_root, std::nullopt);
}

TEST_F(Conversion, writes_motions_with_the_numbers_of_objects) {
    const ConvertedScene scene = convert("dialect mobile2013\neye 0 0 3\n"
                                         "animate_object wall.obj pivot 0.5 0 -4\n"
                                         "animate_object wall.obj 0 rotate 0 0 1 -45.5\n"
                                         "animate_object wall.obj 1.25 rotate 0 0 1 720\n"
                                         "animate_eye -1 0 0 3\n"
                                         "light lamp.obj 1 1 1 1\n"
                                         "object lamp.obj 1 1 1 0 1 0 0 0 0\n"
                                         "object wall.obj 1 1 1 0 1 0 0 0 0\n"
                                         "animate_object 1 0 translate 0 1e-1 0\n"
                                         "animate_eye 2 0 0.5 3\n");
    const size_t motion = scene.text.find("\n# Motion\n");
    ASSERT_NE(motion, std::string::npos) << scene.text;
    EXPECT_EQ(scene.text.substr(motion), R"(
# Motion
#animate_eye time x y   z
animate_eye  -1   0 0   3
animate_eye  2    0 0.5 3
#animate_object name pivot x   y z
animate_object  2    pivot 0.5 0 -4
#animate_object name time rotate ax ay az degrees
animate_object  2    0    rotate 0  0  1  -45.5
animate_object  2    1.25 rotate 0  0  1  720
#animate_object name time translate x y   z
animate_object  1    0    translate 0 0.1 0
)");
    const auto again = converted(write("new.sdl", scene.text), in_folder(""));
    EXPECT_EQ(again.text, scene.text);
    ASSERT_TRUE(again.source.scene->animation());
    for (const double time_s : {-2.0, 0.3, 1.0, 5.0}) {
        const auto a = scene_at(scene.source.scene, time_s), b = scene_at(again.source.scene, time_s);
        ASSERT_TRUE(a && b);
        EXPECT_EQ((*a)->objects()[1].pose, (*b)->objects()[1].pose);
        EXPECT_EQ((*a)->camera().eye, (*b)->camera().eye);
    }
}

TEST_F(Conversion, leaves_out_what_every_scene_has_by_default) {
    EXPECT_EQ(convert("eye 0 0 5\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 0 1 0 0 0 0\nmax_depth 1\n").text,
              R"(dialect glint

# Camera
eye   0 0 5
ortho -1 -1 1 1

# Picture
size       256 256
background 0 0 0
ambient    0
max_depth  1

# Lights
#light file.obj r g b I
light  lamp.obj 1 1 1 1

# Objects
#object file.obj dx dy dz r g b ka kd ks n kr kt ior
object  wall.obj 0  0  0  1 1 1 0  1  0  0 0  0  1
)");
}

/// A file of some dialect.
struct Case {
    const char *dialect;
    std::string text;
};

std::ostream &operator<<(std::ostream &out, const Case &one) {
    return out << one.dialect;
}

class ConversionOf : public Conversion, public testing::WithParamInterface<Case> {};

TEST_P(ConversionOf, keeps_the_scene_to_the_bit_and_converts_into_itself) {
    const ConvertedScene first = convert(GetParam().text);
    EXPECT_EQ(first.source.dialect, GetParam().dialect);
    const ConvertedScene second = converted(write("new.sdl", first.text), in_folder(""));
    EXPECT_EQ(second.source.dialect, "glint");
    EXPECT_EQ(second.text, first.text);
    expect_same(*first.source.scene, *second.source.scene);
    EXPECT_EQ(second.source.output_file, first.source.output_file);
}

const std::string window = "eye 0.1 0.2 5.7\northo -2 -1.5 2 1.25\nsize 40 30\nbackground 0.1 0.2 0.3\nambient .7\n";
const std::string looking = "eye 1 2 5\ntarget 0.3 0.1 -4\nsize 40 30\n";
const std::string numbers20 = " 1 2 3 0.1 0.2 0.3 0.4 0.5 0.6 -7 1 0.7 .1 0.1 0.7 0.2 11 0.3 0.4 1.5\n";

INSTANTIATE_TEST_SUITE_P(
    Dialects, ConversionOf,
    testing::Values(Case{"mobile2013", window + "max_depth 3\noutput x.png\nlight lamp.obj 1 0.3 1 0.7\n"
                                                "object wall.obj 1 0.1 0.9 0.3 0.7 0.1 10 0.7 0.3\n"
                                                "object ./wall.obj 1 0.1 0.9 0.3 0.7 0.1 1e3 0 0.9\n"},
                    // These two add up to a little more than 1 in floats, which all dialects tolerate.
                    Case{"mobile2013", window + "max_depth 3\nlight lamp.obj 1 0.3 1 0.7\n"
                                                "object wall.obj 1 0.1 0.9 0.3 0.7 0.1 10 0.35000002 0.65000004\n"},
                    Case{"path2005", looking + "up 0 1 0.1\nwindow_size 2 1.5\nnpaths 50\ntonemapping 1\nseed 9\n"
                                               "light lamp.obj 1 1 1 1\nobject wall.obj 1 0 0 0.5 0.2 0.1 0 5\n"
                                               "object wall.obj 1 0 0 0.5 0.2 0.1 0.7 5 1.33\n"
                                               "quadric 1 1 1 0 0 0 -1 0 22 484 1 1 1 0 0 0 1 5 1.33\n"
                                               "objectquadric 1 1 0 0 0 0 -1 0 0 -1 1 1 1 0 0 0 1 5\n"},
                    Case{"path2005", looking + "tonemapping 0.3\nlight lamp.obj 1 1 1 1\n"
                                               "object wall.obj 1 0 0 0.5 0.2 0.1 0 5 0\n"},
                    Case{"ray2005", window +
                                        "profundidade 2\nsupersample on\nlight 1 2 3 0.8\nlight -1 2 3 0.2\n"
                                        "object" +
                                        numbers20 + "objectquadric" + numbers20},
                    Case{"cg-path-tracer", looking +
                                               "fov 33.3\nmaxdepth 4\nnshadowrays 5\nlightresolution 2 3\n"
                                               "lightpoint 1 2 3 1 1 0.5 1\nlightarea lamp.obj 1 1 1 0.1\n"
                                               "object wall.obj 0.1 -0.2 1e-3 1 1 1 .1 .7 .2 5 0.1 0.2 1.5\n"
                                               "objectquadric" +
                                               numbers20},
                    Case{"raycife", window + "npaths 10\nlight lamp.obj 1 1 1 1 0 3.836 -25\n"
                                             "object wall.obj 1 0 0 0.3 0.7 0 0 5 0\n"},
                    Case{"glint", window + "dialect glint\nlight_spot 0 3 0 0 -1 0 180 180 1 1 1 1 falloff on\n"
                                           "light_spot 0 3 0 0 -1 0 0.1 0.3 1 1 1 1 falloff off\n"
                                           "light_directional 1e-7 -1e6 3 1 1 1 1\n"
                                           "samples 4 stratified\nobject wall.obj 1e-7 12345.678 -0 1 1 1 1 1 1 "
                                           "0.333333333 0.1 0.1 2\n"}));

TEST_F(Conversion, keeps_the_picture) {
    const std::string scenes[] = {
        window + "max_depth 3\nlight lamp.obj 1 0.3 1 0.7\nobject wall.obj 1 0.1 0.9 0.3 0.7 0.1 10 0.7 0.3\n",
        looking + "dialect path2005\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 0 0 0.5 0.2 0.1 0 5\nambient 0.3\n",
        looking + "dialect cg-path-tracer\nambient 0.1\nlightarea lamp.obj 1 1 1 0.9\n"
                  "object wall.obj 0.1 -0.2 1e-3 1 1 1 .1 .7 .2 5 0 0 1\n"};
    std::vector<uint64_t> hashes;
    for (const std::string &text : scenes) {
        const ConvertedScene scene = convert(text);
        const auto again = read_scene(write("new.sdl", scene.text));
        ASSERT_TRUE(again.ok()) << again.error().text();
        hashes.push_back(picture_hash(scene.source.scene));
        EXPECT_EQ(picture_hash(again->scene), hashes.back());
    }
    EXPECT_NE(hashes[0], hashes[1]);
    EXPECT_NE(hashes[1], hashes[2]);
}

TEST_F(Conversion, writes_scaled_shares_that_read_back_without_a_warning) {
    for (const std::string shares : {"0.9 0.9", "1 1", "0.7 0.300001", "1 0.0001", "0.123 1", "0.99 0.33"}) {
        const ConvertedScene scene = convert(window +
                                             "profundidade 2\nlight 1 2 3 0.8\n"
                                             "object 1 1 1 0 0 0 0 0 0 -1 1 1 1 0 1 0 1 " +
                                             shares + " 1.5\n");
        EXPECT_EQ(scene.source.warnings.size(), shares == "0.7 0.300001" ? 0u : 1u) << shares;
        const ConvertedScene again = converted(write("new.sdl", scene.text), in_folder(""));
        EXPECT_TRUE(again.source.warnings.empty()) << again.source.warnings.at(0).text();
        EXPECT_EQ(again.text, scene.text);
        expect_same(*scene.source.scene, *again.source.scene);
    }
}

TEST_F(Conversion, reads_the_old_file_as_the_dialect_the_caller_names) {
    ReadOptions options;
    options.dialect = "path2005";
    const std::string text = "eye 0 0 5\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 0 1 0 0.5 7 1.5\n";
    EXPECT_EQ(convert(text, options).source.scene->objects()[0].material.ior, 1.5f);
    options.dialect = "mobile2013";
    EXPECT_FALSE(convert_scene(write("old.sdl", text), in_folder(""), options).ok()) << "kt is 1.5";
}

TEST_F(Conversion, fails_as_reading_does) {
    const auto scene = convert_scene(write("bad.sdl", "eye 0 0 5\nmax_depth x\n"), in_folder(""));
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().diagnostics.size(), 3u) << scene.error().text();
    EXPECT_EQ(convert_scene(in_folder("missing.sdl"), in_folder("")).error().code, ErrorCode::not_found);
    const auto nowhere = convert_scene(write("old.sdl", ""), in_folder("missing"));
    ASSERT_FALSE(nowhere.ok());
    EXPECT_EQ(nowhere.error().code, ErrorCode::not_found);
}

class ConvertedPaths : public Conversion {
protected:
    /// What the mesh `mesh` of a scene in folder old/ is called by a scene in `folder`.
    [[nodiscard]] ConvertedScene name(const std::string &mesh, const std::string &folder) const {
        const auto scene = write("old/room.sdl", "eye 0 0 5\nmax_depth 1\nlight lamp.obj 1 1 1 1\nobject " + mesh +
                                                     " 1 1 1 0 1 0 0 0 0\n");
        fs::create_directories(in_folder(folder));
        ReadOptions options;
        options.scene_root = in_folder("");
        return converted(scene, in_folder(folder), options);
    }
    [[nodiscard]] static std::string object_line(const std::string &text) {
        return text.substr(text.find("\nobject ") + 1);
    }
};

TEST_F(ConvertedPaths, start_at_the_new_files_folder) {
    write("old/meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto first_words = [&](const std::string &mesh, const std::string &folder) {
        std::istringstream line(object_line(name(mesh, folder).text));
        std::string keyword, file;
        line >> keyword >> file;
        return file;
    };
    EXPECT_EQ(first_words("meshes/a.obj", "old"), "meshes/a.obj");
    EXPECT_EQ(first_words("./meshes/../meshes/a.obj", "old"), "meshes/a.obj");
    EXPECT_EQ(first_words("wall.obj", "old"), "../wall.obj") << "found above, at the scene root";
    EXPECT_EQ(first_words("meshes/a.obj", ""), "old/meshes/a.obj");
    EXPECT_EQ(first_words("meshes/a.obj", "new/er"), "../../old/meshes/a.obj");
    EXPECT_EQ(first_words("meshes/a.obj", "old/meshes"), "a.obj");
    fs::create_symlink("meshes/a.obj", in_folder("old/link.obj"));
    EXPECT_EQ(first_words("link.obj", ""), "old/link.obj");
    fs::create_directory_symlink("meshes", in_folder("old/folder"));
    EXPECT_EQ(first_words("folder/../meshes/a.obj", "old"), "meshes/a.obj");
}

TEST_F(ConvertedPaths, that_lie_outside_the_new_files_folder_name_the_root_they_need) {
    write("old/meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(name("meshes/a.obj", "").scene_root, std::nullopt);
    const fs::path root = fs::canonical(in_folder(""));
    EXPECT_EQ(name("meshes/a.obj", "old").scene_root, root) << "the lamp lies there";
    write("old/lamp.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(name("meshes/a.obj", "old").scene_root, std::nullopt);
    EXPECT_EQ(name("meshes/a.obj", "old/new").scene_root, root / "old");

    const ConvertedScene far = name("meshes/a.obj", "new/er");
    EXPECT_EQ(far.scene_root, root);
    const auto file = write("new/er/room.sdl", far.text);
    EXPECT_FALSE(read_scene(file).ok());
    ReadOptions options;
    options.scene_root = *far.scene_root;
    const auto again = read_scene(file, options);
    ASSERT_TRUE(again.ok()) << again.error().text();
    expect_same(*far.source.scene, *again->scene);
    EXPECT_EQ(converted(file, in_folder("new/er"), options).text, far.text);
}

TEST_F(ConvertedPaths, that_are_numbers_do_not_become_coefficients) {
    write("old/5", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const ConvertedScene scene = name("5", "old");
    EXPECT_EQ(object_line(scene.text).substr(0, 12), "object  ./5 ");
}

TEST_F(ConvertedPaths, that_no_scene_file_can_name_are_refused) {
    write("old/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto scene = write("old/room.sdl", "eye 0 0 5\nmax_depth 1\nlight a.obj 1 1 1 1\n"
                                             "object a.obj 1 1 1 0 1 0 0 0 0\nobject a.obj 1 1 1 0 1 0 0 0 0\n");
    EXPECT_TRUE(convert_scene(scene, in_folder("old")).ok());
    for (const std::string folder : {"with blank", "with#mark", "with\ttab", "with\nline",
                                     "with\xff"
                                     "byte"}) {
        fs::create_directories(in_folder(folder));
        fs::copy(in_folder("old"), in_folder(folder), fs::copy_options::recursive);
        const auto refused = convert_scene(in_folder(folder) / "room.sdl", in_folder(""));
        ASSERT_FALSE(refused.ok()) << folder;
        ASSERT_EQ(refused.error().diagnostics.size(), 1u) << refused.error().text();
        EXPECT_NE(refused.error().diagnostics[0].message.find("from the new file's folder, the mesh is '"),
                  std::string::npos);
        EXPECT_TRUE(convert_scene(in_folder(folder) / "room.sdl", in_folder(folder)).ok());
    }
}

} // namespace
} // namespace glint::test
