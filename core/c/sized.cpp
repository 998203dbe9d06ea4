// Structs that grow.
#include "c/sized.hpp"

#include <algorithm>
#include <cstring>

namespace glint {

namespace {

/// Whether a struct may be so large: no member is ever cut in two, and a size that was never set is seldom taken.
bool is_size(size_t size) {
    return size >= sizeof(size_t) && size % sizeof(size_t) == 0 && size <= 4096;
}

size_t size_at(const void *place) {
    size_t size = 0;
    if (place) std::memcpy(&size, place, sizeof size);
    return size;
}

} // namespace

bool take_sized(const void *given, void *known, size_t known_size) {
    const size_t size = size_at(given);
    if (!is_size(size)) return false;
    const auto *const bytes = static_cast<const unsigned char *>(given);
    if (!std::all_of(bytes + std::min(size, known_size), bytes + size, [](unsigned char byte) { return byte == 0; })) {
        return false;
    }
    std::memcpy(known, given, std::min(size, known_size));
    return true;
}

bool is_sized(const void *place) {
    return is_size(size_at(place));
}

bool give_sized(void *place, const void *known, size_t known_size) {
    return init_sized(place, size_at(place), known, known_size) == GLINT_OK;
}

glint_error init_sized(void *place, size_t size, const void *known, size_t known_size) {
    if (!place || !is_size(size)) return GLINT_ERROR_INVALID_ARGUMENT;
    const size_t both = std::min(size, known_size);
    std::memcpy(place, known, both);
    std::memset(static_cast<unsigned char *>(place) + both, 0, size - both);
    std::memcpy(place, &size, sizeof size);
    return GLINT_OK;
}

} // namespace glint
