// tinyobjloader, as this library has it inside.
#pragma once

#include <span>
#include <streambuf>

// The library is compiled into ours, under a name of ours: a program that brings its own tinyobjloader, of whatever
// version, must not end up with two definitions of one function.
#define tinyobj glint_tinyobj
#include <tiny_obj_loader.h>

namespace glint {

/// A stream over a text that is already in memory, without a copy.
class TextStream : public std::streambuf {
public:
    explicit TextStream(std::span<char> text) { setg(text.data(), text.data(), text.data() + text.size()); }
};

} // namespace glint
