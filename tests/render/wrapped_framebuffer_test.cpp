// Pictures in memory that belongs to the caller: the same bytes at other places, and nothing between rows.
#include <cstring>

#include <gtest/gtest.h>

#include <glint/glint.hpp>

namespace glint::test {
namespace {

constexpr uint8_t untouched = 0xa5;

/// Room for a picture with gaps between its rows, and before and behind it.
struct Room {
    uint32_t width_px, height_px;
    size_t stride_bytes, light_stride_bytes;
    std::vector<uint8_t> bytes, light; ///< `light` as bytes, so that gaps can be told

    Room(uint32_t width, uint32_t height, size_t gap_bytes, size_t light_gap_bytes)
        : width_px(width),
          height_px(height),
          stride_bytes(size_t{width} * 4 + gap_bytes),
          light_stride_bytes(size_t{width} * 12 + light_gap_bytes),
          bytes((height + 2) * stride_bytes, untouched),
          light((height + 2) * light_stride_bytes, untouched) {}

    [[nodiscard]] uint8_t *first_row() { return bytes.data() + stride_bytes; }
    [[nodiscard]] float *first_light() { return reinterpret_cast<float *>(light.data() + light_stride_bytes); }
    [[nodiscard]] Framebuffer wrapped(bool with_radiance = true) {
        auto wrapped =
            Framebuffer::wrap(width_px, height_px, first_row(), stride_bytes, with_radiance ? first_light() : nullptr,
                              with_radiance ? light_stride_bytes : 0);
        if (!wrapped) throw std::runtime_error(wrapped.error().text());
        return std::move(wrapped).value();
    }

    /// That the rows are the picture's and all else is untouched.
    void expect(const Framebuffer &picture, bool with_radiance = true) {
        for (size_t y = 0; y < height_px; ++y) {
            ASSERT_EQ(std::memcmp(first_row() + y * stride_bytes, picture.rgba8() + y * width_px * 4, width_px * 4), 0)
                << "row " << y;
            std::memset(first_row() + y * stride_bytes, untouched, width_px * 4);
            if (!with_radiance) continue;
            uint8_t *const row = light.data() + (y + 1) * light_stride_bytes;
            ASSERT_EQ(std::memcmp(row, picture.radiance() + y * width_px * 3, width_px * 12), 0)
                << "light of row " << y;
            std::memset(row, untouched, width_px * 12);
        }
        const auto is_touched = [](uint8_t byte) { return byte != untouched; };
        EXPECT_EQ(std::count_if(bytes.begin(), bytes.end(), is_touched), 0) << "bytes between rows were written";
        EXPECT_EQ(std::count_if(light.begin(), light.end(), is_touched), 0) << "floats between rows were written";
    }
};

std::shared_ptr<const Accel> accel_of(const char *name) {
    const auto file = read_scene(GLINT_SOURCE_DIR "/scenes/sdl/" + std::string(name) + ".sdl");
    if (!file) throw std::runtime_error(file.error().text());
    return Accel::build(file->scene);
}

TEST(WrappedFramebuffer, gets_the_same_picture_and_nothing_between_rows) {
    const auto accel = accel_of("cornell");
    for (const Isa isa : available_isas()) {
        Renderer renderer(accel, {2, isa});
        for (const auto &[width, height] : {std::pair{64u, 48u}, {1u, 1u}, {33u, 17u}, {7u, 40u}}) {
            auto own = Framebuffer::create(width, height);
            ASSERT_TRUE(renderer.render(*own));
            for (const size_t gap : {size_t{0}, size_t{1}, size_t{60}}) {
                Room room(width, height, gap, 4 * gap);
                Framebuffer wrapped = room.wrapped();
                ASSERT_TRUE(renderer.render(wrapped));
                EXPECT_EQ(wrapped.pixel_hash(), own->pixel_hash());
                EXPECT_EQ(wrapped.radiance_hash(), own->radiance_hash());
                SCOPED_TRACE(std::string(isa_name(isa)) + " " + std::to_string(width) + " gap " + std::to_string(gap));
                room.expect(*own);
            }
        }
    }
}

TEST(WrappedFramebuffer, can_do_without_radiance) {
    Renderer renderer(accel_of("cornell"), {2});
    auto own = Framebuffer::create(50, 30);
    ASSERT_TRUE(renderer.render(*own));
    Room room(50, 30, 12, 0);
    Framebuffer wrapped = room.wrapped(false);
    EXPECT_FALSE(wrapped.has_radiance());
    ASSERT_TRUE(renderer.render(wrapped));
    EXPECT_EQ(wrapped.pixel_hash(), own->pixel_hash());
    room.expect(*own, false);
}

TEST(WrappedFramebuffer, is_refined_like_any_other) {
    Renderer renderer(accel_of("cornell"), {2});
    // Wide enough for a band of the refiner to end within a row.
    auto own = Framebuffer::create(301, 120);
    Room room(301, 120, 20, 8);
    Framebuffer wrapped = room.wrapped();
    Refiner refiner, same;
    for (int pass = 0; pass < 4; ++pass) {
        ASSERT_TRUE(refiner.next(renderer, *own));
        ASSERT_TRUE(same.next(renderer, wrapped));
        ASSERT_EQ(wrapped.radiance_hash(), own->radiance_hash());
    }
    room.expect(*own);
}

TEST(WrappedFramebuffer, stays_as_it_is_when_the_render_is_cancelled) {
    Renderer renderer(accel_of("cornell"), {2});
    Room room(64, 48, 8, 8);
    Framebuffer wrapped = room.wrapped();
    RenderControl control;
    control.cancel();
    EXPECT_FALSE(renderer.render(wrapped, {}, &control));
    EXPECT_TRUE(std::all_of(room.bytes.begin(), room.bytes.end(), [](uint8_t byte) { return byte == untouched; }));
}

TEST(WrappedFramebuffer, does_not_own_its_memory) {
    alignas(4) uint8_t bytes[4] = {1, 2, 3, 4};
    {
        auto wrapped = Framebuffer::wrap(1, 1, bytes, 4);
        ASSERT_TRUE(wrapped);
        Framebuffer moved = std::move(wrapped).value();
        EXPECT_EQ(moved.rgba8(), bytes);
    } // deleting it would be seen by sanitizers, and by malloc
    EXPECT_EQ(bytes[2], 3) << "what was there stays until it is rendered to";
}

TEST(WrappedFramebuffer, takes_rows_of_floats_without_gaps_for_granted) {
    uint8_t bytes[24];
    float light[18];
    const auto wrapped = Framebuffer::wrap(3, 2, bytes, 12, light);
    ASSERT_TRUE(wrapped);
    EXPECT_EQ(wrapped->radiance_stride_bytes(), 36u);
    EXPECT_EQ(wrapped->radiance(), light);
}

TEST(WrappedFramebuffer, refuses_memory_that_cannot_be_right) {
    uint8_t bytes[64];
    alignas(4) char floats[256];
    const auto light_at = [&](size_t offset) { return reinterpret_cast<float *>(floats + offset); };
    const auto code = [](const Result<Framebuffer> &wrapped) { return wrapped ? ErrorCode::io : wrapped.error().code; };
    EXPECT_EQ(code(Framebuffer::wrap(0, 2, bytes, 8)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, 0, bytes, 8)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, 2, nullptr, 8)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, 2, bytes, 7)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, 2, bytes, 0)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, 2, bytes, 8, light_at(0), 20)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, 2, bytes, 8, light_at(0), 26)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, 2, bytes, 8, light_at(2), 24)), ErrorCode::bad_input);
    EXPECT_EQ(code(Framebuffer::wrap(2, UINT32_MAX, bytes, SIZE_MAX / 2)), ErrorCode::limit_exceeded);
    EXPECT_EQ(code(Framebuffer::wrap(2, 2, bytes, 8, light_at(0), SIZE_MAX - 3)), ErrorCode::limit_exceeded);
    EXPECT_TRUE(Framebuffer::wrap(2, 2, bytes, 9, light_at(0), 28));
}

} // namespace
} // namespace glint::test
