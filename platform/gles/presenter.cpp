// Drawing uploaded pictures on two triangles.
#include <glint/gles/presenter.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "gles/picture_texture.hpp"
#include "gles/program.hpp"
#include "gles/saved_state.hpp"
#include "gles/shaders.hpp"
#include "gles/size_text.hpp"

namespace glint::gles {

namespace {

/// A linked program, once it is needed.
struct FilterProgram {
    GLuint name = 0;
    GLint size_px = -1; ///< where the texture's size goes; -1 where it is not asked for
};

} // namespace

struct Presenter::Impl {
    explicit Impl(Gl gl_) : gl(std::move(gl_)), texture(gl) {}

    Status create_objects();
    void delete_objects();
    Status prepare(FilterProgram &program, const char *fragment_source);
    Status set_vertices();
    void set_vertex_array() const;
    void draw_tiles(const FilterProgram &program, GLint texture_filter);
    [[nodiscard]] bool is_enlarged_by(int width_px, int height_px) const;
    [[nodiscard]] bool is_unchanged_by(int width_px, int height_px) const;
    [[nodiscard]] Status check_usable() const;
    [[nodiscard]] Status check_viewport(int width_px, int height_px) const;

    Gl gl;
    PictureTexture texture;
    std::array<GLint, 2> max_viewport_px = {};
    FilterProgram plain, sharp;
    GLuint vertex_buffer = 0;
    GLuint vertex_array = 0;                                          // stays 0 where contexts have none
    std::vector<Tile> tiles_of_vertices = {{0, 0, 1, 1, 0, 0, 1, 1}}; // what the vertex buffer is for
    bool abandoned = false;
};

Status Presenter::Impl::create_objects() {
    gl.get_integerv(GL_MAX_VIEWPORT_DIMS, max_viewport_px.data());
    if (Status status = prepare(plain, plain_fragment_source); !status) return status;
    const SavedVertices saved(gl);
    const TileVertices corners = tile_vertices(tiles_of_vertices.front(), 1, 1);
    gl.gen_buffers(1, &vertex_buffer);
    gl.bind_buffer(GL_ARRAY_BUFFER, vertex_buffer);
    gl.buffer_data(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
    if (Status status = gl.check("glBufferData"); !status) return status;
    if (!gl.has_gl3_objects) return Done{};
    gl.gen_vertex_arrays(1, &vertex_array);
    gl.bind_vertex_array(vertex_array);
    set_vertex_array();
    return gl.check("glVertexAttribPointer");
}

void Presenter::Impl::delete_objects() {
    texture.delete_textures();
    // Names that are 0 are ignored by OpenGL.
    gl.delete_buffers(1, &vertex_buffer);
    if (gl.has_gl3_objects) gl.delete_vertex_arrays(1, &vertex_array);
    for (const FilterProgram &program : {plain, sharp}) {
        if (program.name != 0) gl.delete_program(program.name);
    }
}

/// Links the program when it is first asked for: whoever never scales does not wait for it.
Status Presenter::Impl::prepare(FilterProgram &program, const char *fragment_source) {
    if (program.name != 0) return Done{};
    const std::string fragment = std::string(fragment_head) + fragment_source;
    Result<GLuint> linked = link_program(gl, vertex_source, fragment.c_str(), "corner");
    if (!linked) return std::move(linked).error();
    program.name = *linked;
    program.size_px = gl.get_uniform_location(program.name, "size_px");
    return Done{};
}

/// Two triangles a tile. A picture in one texture needs the same for every size.
Status Presenter::Impl::set_vertices() {
    const std::vector<Tile> &tiles = texture.tiles();
    if (tiles == tiles_of_vertices || (tiles.size() == 1 && tiles_of_vertices.size() == 1)) return Done{};
    std::vector<TileVertices> vertices;
    vertices.reserve(tiles.size());
    for (const Tile &tile : tiles) vertices.push_back(tile_vertices(tile, texture.width_px(), texture.height_px()));
    tiles_of_vertices.clear(); // of none, should this fail
    gl.bind_buffer(GL_ARRAY_BUFFER, vertex_buffer);
    gl.buffer_data(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(TileVertices)), vertices.data(),
                   GL_STATIC_DRAW);
    if (Status status = gl.check("glBufferData"); !status) return status;
    tiles_of_vertices = tiles;
    return Done{};
}

/// Attribute 0 reads the vertices. The vertex buffer must be bound.
void Presenter::Impl::set_vertex_array() const {
    gl.vertex_attrib_pointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.enable_vertex_attrib_array(0);
}

void Presenter::Impl::draw_tiles(const FilterProgram &program, GLint texture_filter) {
    gl.use_program(program.name);
    if (gl.has_gl3_objects) {
        gl.bind_vertex_array(vertex_array);
    } else {
        gl.bind_buffer(GL_ARRAY_BUFFER, vertex_buffer);
        set_vertex_array();
    }
    const std::vector<Tile> &tiles = texture.tiles();
    for (size_t i = 0; i < tiles.size(); ++i) {
        texture.bind(i, texture_filter);
        if (program.size_px >= 0) {
            gl.uniform_2f(program.size_px, static_cast<GLfloat>(tiles[i].texture_width_px),
                          static_cast<GLfloat>(tiles[i].texture_height_px));
        }
        gl.draw_arrays(GL_TRIANGLES, static_cast<GLint>(6 * i), 6);
    }
}

/// No side of the picture shrinks.
bool Presenter::Impl::is_enlarged_by(int width_px, int height_px) const {
    return static_cast<uint32_t>(width_px) >= texture.width_px() &&
           static_cast<uint32_t>(height_px) >= texture.height_px();
}

bool Presenter::Impl::is_unchanged_by(int width_px, int height_px) const {
    return static_cast<uint32_t>(width_px) == texture.width_px() &&
           static_cast<uint32_t>(height_px) == texture.height_px();
}

Status Presenter::Impl::check_usable() const {
    if (abandoned) return Error(ErrorCode::unsupported, "the presenter's context is gone, expected a new presenter");
    return gl.check_nothing_pending();
}

/// OpenGL would cut the rectangle to the limit without a word, and show a scaled picture.
Status Presenter::Impl::check_viewport(int width_px, int height_px) const {
    if (width_px < 0 || height_px < 0) {
        return Error(ErrorCode::bad_input,
                     "a rectangle of " + size_text(width_px, height_px) + " pixels, expected no negative sizes");
    }
    if (width_px > max_viewport_px[0] || height_px > max_viewport_px[1]) {
        return Error(ErrorCode::limit_exceeded,
                     "a rectangle of " + size_text(width_px, height_px) + " pixels, expected at most " +
                         size_text(max_viewport_px[0], max_viewport_px[1]) + " on this context");
    }
    return Done{};
}

Result<std::unique_ptr<Presenter>> Presenter::create(const ProcLoader &load) {
    Result<Gl> gl = Gl::load(load);
    if (!gl) return std::move(gl).error();
    if (Status status = gl->check_nothing_pending(); !status) return std::move(status).error();
    // From here on the destructor deletes what there is.
    std::unique_ptr<Presenter> presenter(new Presenter(std::make_unique<Impl>(std::move(gl).value())));
    if (Status status = presenter->impl_->create_objects(); !status) return std::move(status).error();
    return presenter;
}

Presenter::Presenter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Presenter::~Presenter() {
    if (!impl_->abandoned) impl_->delete_objects();
}

void Presenter::abandon() {
    impl_->abandoned = true;
}

bool Presenter::context_lost() const {
    return impl_->abandoned || impl_->gl.is_lost();
}

Status Presenter::upload(const PixelView &picture) {
    if (Status status = impl_->check_usable(); !status) return status;
    return impl_->texture.upload(picture);
}

Status Presenter::draw(int x, int y, int width_px, int height_px, const DrawOptions &how) {
    Impl &impl = *impl_;
    if (Status status = impl.check_usable(); !status) return status;
    if (impl.texture.tiles().empty()) {
        return Error(ErrorCode::bad_input, "there is nothing to draw yet, expected an upload() before draw()");
    }
    if (Status status = impl.check_viewport(width_px, height_px); !status) return status;
    if (width_px == 0 || height_px == 0) return Done{};

    const bool unchanged = impl.is_unchanged_by(width_px, height_px);
    const bool sharp = how.filter == Filter::sharp && !unchanged && impl.is_enlarged_by(width_px, height_px);
    if (sharp) {
        if (Status status = impl.prepare(impl.sharp, sharp_fragment_source); !status) return status;
    }
    const SavedDrawState saved_state(impl.gl);
    const SavedVertices saved_vertices(impl.gl);
    if (Status status = impl.set_vertices(); !status) return status;
    std::optional<SavedBlending> blending;
    if (how.blend == Blend::straight) blending.emplace(impl.gl, GL_SRC_ALPHA);
    if (how.blend == Blend::premultiplied) blending.emplace(impl.gl, GL_ONE);
    impl.gl.viewport(x, y, width_px, height_px);
    const bool nearest = unchanged || sharp || how.filter == Filter::nearest;
    impl.draw_tiles(sharp ? impl.sharp : impl.plain, nearest ? GL_NEAREST : GL_LINEAR);
    return impl.gl.check("glDrawArrays");
}

} // namespace glint::gles
