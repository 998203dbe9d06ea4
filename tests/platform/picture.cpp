// Making pictures and comparing them.
#include "platform/picture.hpp"

#include <algorithm>
#include <random>

namespace glint::test {

Framebuffer random_picture(uint32_t width_px, uint32_t height_px, uint32_t seed) {
    Result<Framebuffer> picture = Framebuffer::create(width_px, height_px, false);
    std::mt19937 random(seed);
    std::generate_n(picture->rgba8(), size_t{width_px} * height_px * 4, [&] { return static_cast<uint8_t>(random()); });
    return std::move(picture).value();
}

testing::AssertionResult same_bytes(const Framebuffer &picture, const std::vector<uint8_t> &shown) {
    const size_t byte_count = picture.rgba8_stride_bytes() * picture.height_px();
    if (shown.size() != byte_count) {
        return testing::AssertionFailure() << shown.size() << " bytes, expected " << byte_count;
    }
    const auto [wanted, found] = std::mismatch(picture.rgba8(), picture.rgba8() + byte_count, shown.begin());
    if (found == shown.end()) return testing::AssertionSuccess();
    const auto at = static_cast<size_t>(wanted - picture.rgba8());
    return testing::AssertionFailure() << "column " << at / 4 % picture.width_px() << ", row "
                                       << at / picture.rgba8_stride_bytes() << ", channel " << at % 4 << " of "
                                       << picture.width_px() << " x " << picture.height_px() << " shows " << int{*found}
                                       << ", expected " << int{*wanted};
}

testing::AssertionResult shows(gles::Surface &surface, gles::Presenter &presenter, const Framebuffer &picture) {
    if (Status status = presenter.upload(picture); !status) {
        return testing::AssertionFailure() << "upload: " << status.error().text();
    }
    const auto width_px = static_cast<int>(picture.width_px());
    const auto height_px = static_cast<int>(picture.height_px());
    if (Status status = presenter.draw(0, 0, width_px, height_px); !status) {
        return testing::AssertionFailure() << "draw: " << status.error().text();
    }
    surface.finish();
    Result<std::vector<uint8_t>> shown = surface.read_back();
    if (!shown) return testing::AssertionFailure() << "read_back: " << shown.error().text();
    return same_bytes(picture, *shown);
}

} // namespace glint::test
