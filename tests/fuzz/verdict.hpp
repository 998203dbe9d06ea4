// What every reader owes for every text: something valid, or a reason; and that it stays small and quick.
#pragma once

#include <glint/read.hpp>

namespace glint::fuzz {

/// Stops the program, with words, where `holds` is false. That is how libFuzzer learns of a fault.
void require(bool holds, const char *what);

/// Indices in range, numbers finite, no triangle without area.
void require_valid(const Mesh &mesh);

/// Shares and colours from 0 to 1, all else within its limits, textures as large as they say.
void require_valid(const Material &material);

/// Everything that the builder promises of a scene, looked at afresh.
void require_valid(const Scene &scene);

/// Every diagnostic of a refusal has a position, or is about the file as a whole in words that are known here.
void require_reasons(const Error &error);

/// Warnings are warnings, and have words.
void require_words(const std::vector<Diagnostic> &warnings);

} // namespace glint::fuzz
