// OBJ files with MTL files beside them, for tests.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {

constexpr std::string_view four_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class ModelFiles : public WrittenFiles {
protected:
    /// Of an OBJ file in the test's folder, which must be good.
    [[nodiscard]] ModelFile read(std::string_view obj, const ReadOptions &options = {}) const {
        auto model = read_model(write("model.obj", obj), options);
        if (!model.ok()) throw std::runtime_error(model.error().text());
        return std::move(model).value();
    }
    /// The same with a library of this text, which has the material "m"; all faces have it.
    [[nodiscard]] ModelFile read_with(std::string_view mtl, const ReadOptions &options = {}) const {
        write("model.mtl", mtl);
        return read("mtllib model.mtl\nusemtl m\n" + std::string(four_vertices) + "f 1 2 3\n", options);
    }
    [[nodiscard]] Material material_of(std::string_view mtl) const { return read_with(mtl).parts.at(0).material; }
};

/// Options whose textures are one texel that counts the calls in its red channel, in thousandths.
struct CountedTextures {
    int calls = 0;

    [[nodiscard]] ReadOptions options() {
        ReadOptions options;
        options.read_texture = [this](const std::filesystem::path &) -> Result<Texture> {
            ++calls;
            return Texture{1, 1, {Color(static_cast<float>(calls) * 1e-3f, 0.0f, 0.0f)}};
        };
        return options;
    }
};

} // namespace glint::test
