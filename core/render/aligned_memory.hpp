// Memory for vectors: aligned, not initialised, and kept from one picture to the next.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

#include "kernel/kernel.hpp"

namespace glint {

class AlignedMemory {
public:
    /// At least `bytes` bytes; what was there before may be gone.
    [[nodiscard]] std::byte *at_least(size_t bytes) {
        if (bytes > size_) {
            memory_.reset();
            size_ = 0;
            memory_.reset(static_cast<std::byte *>(::operator new(bytes, alignment)));
            size_ = bytes;
        }
        return memory_.get();
    }

private:
    static constexpr std::align_val_t alignment{scratch_alignment};
    struct Free {
        void operator()(std::byte *memory) const { ::operator delete(memory, alignment); }
    };
    std::unique_ptr<std::byte, Free> memory_;
    size_t size_ = 0;
};

} // namespace glint
