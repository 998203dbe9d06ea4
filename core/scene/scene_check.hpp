// Checks a scene's parts one by one and keeps every complaint.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <glint/scene.hpp>

namespace glint {

/// Whether it is a finite place within max_coordinate of the origin.
[[nodiscard]] bool is_place(const glm::vec3 &p);
/// "object 3 'floor'": how a complaint names a surface.
[[nodiscard]] std::string surface_name(const char *kind, size_t index, const std::string &name);

/// Everything that a scene's parts must fulfil. `owner` is what complaints call the part.
class SceneChecker {
public:
    void complain(std::string message);

    void number(float value, float lowest, float highest, const std::string &what);
    void color(const Color &value, float highest, const std::string &what);
    void material(const Material &material, const std::string &owner);
    /// Checks all of the object but its mesh's triangles, which mesh() looks at.
    void object(Object &object, const std::string &owner);
    void light(Light &light, const std::string &owner);
    void picture(const PictureSettings &picture);

    /// Triangles that were left out for lack of area, once for each use of their mesh.
    [[nodiscard]] uint64_t skipped_triangles() const { return skipped_; }
    [[nodiscard]] std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }
    [[nodiscard]] bool ok() const { return diagnostics_.empty(); }

private:
    struct CheckedMesh {
        std::shared_ptr<const Mesh> mesh;
        uint64_t skipped = 0;
    };

    /// The mesh without triangles that have no area: the same mesh where there are none, nullptr where it is not valid.
    std::shared_ptr<const Mesh> mesh(const std::shared_ptr<const Mesh> &mesh, const std::string &owner);
    CheckedMesh check_mesh(const std::shared_ptr<const Mesh> &mesh, const std::string &owner);
    [[nodiscard]] bool corners_are_valid(const Mesh &mesh, const std::string &owner);
    void texture(const Texture &texture, const std::string &owner);

    std::unordered_map<const Mesh *, CheckedMesh> checked_;
    std::vector<Diagnostic> diagnostics_;
    uint64_t skipped_ = 0;
};

} // namespace glint
