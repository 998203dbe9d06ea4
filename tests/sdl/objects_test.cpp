// What each dialect's objects become: every number in its place.
#include <gtest/gtest.h>

#include "sdl/small_scene.hpp"

namespace glint::test {
namespace {

class Objects : public SmallScene {
protected:
    /// The object of a scene that has only this line, an eye and a light.
    [[nodiscard]] Object object(const std::string &line, const std::string &dialect) const {
        const SceneFile file =
            read("dialect " + dialect + "\neye 0 0 5\nreflections 3\nlight lamp.obj 1 1 1 1\n" + line + "\n");
        EXPECT_EQ(file.scene->objects().size(), 1u);
        EXPECT_TRUE(file.warnings.empty()) << file.warnings.front().text();
        return file.scene->objects()[0];
    }
    /// The warning that the object comes with.
    [[nodiscard]] std::string warning(const std::string &line, const std::string &dialect) const {
        const SceneFile file =
            read("dialect " + dialect + "\neye 0 0 5\nreflections 3\nlight lamp.obj 1 1 1 1\n" + line + "\n");
        EXPECT_EQ(file.warnings.size(), 1u);
        return file.warnings.empty() ? std::string() : file.warnings[0].message;
    }
};

void expect_base(const Material &m) {
    EXPECT_EQ(m.color, Color(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.ambient, 0.4f);
    EXPECT_EQ(m.diffuse, 0.5f);
    EXPECT_EQ(m.specular, 0.6f);
    EXPECT_EQ(m.highlight_color, Color(1, 1, 1));
    EXPECT_EQ(m.texture, nullptr);
}

constexpr const char *base = " .1 .2 .3 .4 .5 .6 ";

TEST_F(Objects, of_mobile2013_have_nine_numbers) {
    const Object object = this->object(std::string("object wall.obj") + base + "7 .125 .25", "mobile2013");
    expect_base(object.material);
    EXPECT_EQ(object.material.specular_exponent, 7.0f);
    EXPECT_EQ(object.material.reflection, 0.125f);
    EXPECT_EQ(object.material.transmission, 0.25f);
    EXPECT_EQ(object.material.ior, 1.0f);
    EXPECT_FALSE(object.material.adds_to_local);
    EXPECT_EQ(object.name, "wall.obj");
    EXPECT_EQ(object.mesh->triangles.size(), 1u);
    EXPECT_FALSE(object.quadric);
}

TEST_F(Objects, of_path2005_and_raycife_have_eight_or_nine_numbers) {
    for (const char *dialect : {"path2005", "raycife"}) {
        const Object thin = object(std::string("object wall.obj") + base + ".25 7", dialect);
        expect_base(thin.material);
        EXPECT_EQ(thin.material.transmission, 0.25f);
        EXPECT_EQ(thin.material.specular_exponent, 7.0f);
        EXPECT_EQ(thin.material.reflection, 0.0f);
        EXPECT_EQ(thin.material.ior, 1.0f);
        EXPECT_TRUE(thin.material.adds_to_local);
        const Object glass = object(std::string("object wall.obj") + base + ".25 7 1.5", dialect);
        expect_base(glass.material);
        EXPECT_EQ(glass.material.transmission, 0.25f);
        EXPECT_EQ(glass.material.specular_exponent, 7.0f);
        EXPECT_EQ(glass.material.ior, 1.5f);
    }
}

TEST_F(Objects, of_cg_path_tracer_are_moved_and_have_thirteen_numbers) {
    for (const char *dialect : {"cg-path-tracer", "glint"}) {
        const Object object = this->object(std::string("object wall.obj 1 -2 .5") + base + "7 .125 .25 1.5", dialect);
        expect_base(object.material);
        EXPECT_EQ(object.material.specular_exponent, 7.0f);
        EXPECT_EQ(object.material.reflection, 0.125f);
        EXPECT_EQ(object.material.transmission, 0.25f);
        EXPECT_EQ(object.material.ior, 1.5f);
        EXPECT_EQ(object.material.adds_to_local, std::string(dialect) == "cg-path-tracer");
        EXPECT_EQ(object.mesh->positions[0], Point(1, -2, 0.5f));
        EXPECT_EQ(object.mesh->positions[1], Point(2, -2, 0.5f));
    }
}

TEST_F(Objects, that_move_by_the_same_share_a_mesh) {
    const auto scene = read("eye 0 0 5\nlight wall.obj 1 1 1 1\n"
                            "object wall.obj 0 0 0 1 1 1 0 1 0 0 0 0 1\nobject wall.obj 1 0 0 1 1 1 0 1 0 0 0 0 1\n"
                            "object ./wall.obj 1 0 0 1 1 1 0 1 0 0 0 0 1\n")
                           .scene;
    EXPECT_EQ(scene->objects()[0].mesh, scene->lights()[0].mesh) << "one that stays is the file's own";
    EXPECT_NE(scene->objects()[1].mesh, scene->objects()[0].mesh);
    EXPECT_EQ(scene->objects()[1].mesh, scene->objects()[2].mesh);
}

TEST_F(Objects, that_move_far_lose_triangles_that_have_no_area_there) {
    write("pair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\nf 1 4 5\n");
    EXPECT_EQ(warning("object pair.obj 3e7 3e7 0 1 1 1 0 1 0 0 0 0 1", "glint"),
              "1 of the 2 triangles of the mesh 'pair.obj' have no area so far from the origin, and are left out");
}

constexpr const char *ten = " 2 3 4 .5 .25 .125 6 7 8 -9";

TEST_F(Objects, of_ray2005_are_quadrics_whose_mixed_and_linear_terms_count_twice) {
    const Quadric expected = {2, 3, 4, 0.5f, 0.25f, 0.125f, 6, 7, 8, -9};
    for (const char *keyword : {"object", "objectquadric"}) {
        for (const char *dialect : {"ray2005", "glint"}) {
            const Object object = this->object(std::string(keyword) + ten + base + "7 .125 .25 1.5", dialect);
            expect_base(object.material);
            EXPECT_EQ(object.material.specular_exponent, 7.0f);
            EXPECT_EQ(object.material.reflection, 0.125f);
            EXPECT_EQ(object.material.transmission, 0.25f);
            EXPECT_EQ(object.material.ior, 1.5f);
            EXPECT_EQ(object.quadric, expected);
            EXPECT_EQ(object.mesh, nullptr);
            EXPECT_EQ(object.material.adds_to_local, std::string(dialect) == "ray2005");
        }
    }
}

TEST_F(Objects, of_cg_path_tracer_may_be_quadrics_whose_terms_count_once_and_mix_in_another_order) {
    // d xy + e xz + f yz: half of each, and the last two change places.
    const Quadric expected = {2, 3, 4, 0.25f, 0.0625f, 0.125f, 3, 3.5f, 4, -9};
    for (const char *keyword : {"object", "objectquadric"}) {
        const Object object = this->object(std::string(keyword) + ten + base + "7 .125 .25 1.5", "cg-path-tracer");
        expect_base(object.material);
        EXPECT_EQ(object.material.specular_exponent, 7.0f);
        EXPECT_EQ(object.material.reflection, 0.125f);
        EXPECT_EQ(object.material.transmission, 0.25f);
        EXPECT_EQ(object.material.ior, 1.5f);
        EXPECT_EQ(object.quadric, expected);
    }
}

TEST_F(Objects, of_path2005_may_be_quadrics_with_eighteen_or_nineteen_numbers) {
    const Quadric expected = {2, 3, 4, 0.5f, 0.25f, 0.125f, 6, 7, 8, -9};
    for (const char *dialect : {"path2005", "raycife"}) {
        for (const char *keyword : {"quadric", "objectquadric"}) {
            const Object thin = object(std::string(keyword) + ten + base + ".25 7", dialect);
            expect_base(thin.material);
            EXPECT_EQ(thin.quadric, expected);
            EXPECT_EQ(thin.material.transmission, 0.25f);
            EXPECT_EQ(thin.material.specular_exponent, 7.0f);
            EXPECT_EQ(thin.material.ior, 1.0f);
            const Object glass = object(std::string(keyword) + ten + base + ".25 7 1.5", dialect);
            EXPECT_EQ(glass.quadric, expected);
            EXPECT_EQ(glass.material.ior, 1.5f);
        }
    }
}

TEST_F(Objects, that_let_nothing_through_may_have_an_ior_that_means_nothing) {
    for (const char *ior : {"0", "0.005", "1.33"}) {
        const Object object = this->object(std::string("object wall.obj 1 1 1 .3 .7 0 0 5 ") + ior, "path2005");
        EXPECT_EQ(object.material.ior, std::string(ior) == "1.33" ? 1.33f : 1.0f);
    }
    EXPECT_EQ(error_of("dialect path2005\neye 0 0 5\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 .3 .7 0 .5 5 0\n")
                  .diagnostics.at(0)
                  .message,
              "ior is '0', expected a number from 0.01 to 100");
}

TEST_F(Objects, of_2005_that_give_more_light_than_comes_in_are_scaled_with_a_warning) {
    for (const char *dialect : {"ray2005", "cg-path-tracer", "glint"}) {
        const std::string line = std::string("object 1 1 1 0 0 0 0 0 0 -1 1 1 1 0 1 0 5 .9 .6 1.5");
        EXPECT_EQ(warning(line, dialect), "kr + kt is more than 1 ('.9' + '.6'); both are scaled to add up to 1");
        const SceneFile file =
            read(std::string("dialect ") + dialect + "\neye 0 0 5\nreflections 3\nlight lamp.obj 1 1 1 1\n" + line);
        const Material &m = file.scene->objects()[0].material;
        EXPECT_FLOAT_EQ(m.reflection, 0.6f);
        EXPECT_FLOAT_EQ(m.transmission, 0.4f);
        EXPECT_LE(m.reflection + m.transmission, 1.0f);
    }
    EXPECT_EQ(error_of("dialect mobile2013\neye 0 0 5\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 0 1 0 5 .9 .6\n")
                  .diagnostics.at(0)
                  .message,
              "kr + kt is more than 1 ('.9' + '.6')")
        << "there the local colour gets the rest, and less than nothing is left";
}

TEST_F(Objects, whose_shares_are_all_of_the_light_are_fine_however_the_decimals_round) {
    for (int part = 0; part <= 1000; part += 7) {
        const auto decimal = [](int thousandths) {
            std::string digits = std::to_string(1000 + thousandths);
            return std::string(thousandths == 1000 ? "1." : "0.") + digits.substr(1);
        };
        const std::string shares = decimal(part) + ' ' + decimal(1000 - part);
        const Object adding = object("object 1 1 1 0 0 0 0 0 0 -1 1 1 1 0 1 0 5 " + shares + " 1.5", "ray2005");
        EXPECT_NEAR(adding.material.reflection + adding.material.transmission, 1.0f, 1e-6f);
        const Object replacing = object("object wall.obj 1 1 1 0 1 0 5 " + shares, "mobile2013");
        EXPECT_NEAR(replacing.material.reflection + replacing.material.transmission, 1.0f, 1e-6f);
    }
}

} // namespace
} // namespace glint::test
