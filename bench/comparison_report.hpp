// Comparisons with a peer as text: for the terminal and for programs.
#pragma once

#include <string>
#include <vector>

#include "bench/build_comparison.hpp"
#include "bench/frame_comparison.hpp"
#include "bench/kernel_comparison.hpp"
#include "bench/machine.hpp"

namespace glint::bench {

/// A kernel comparison with what it was taken with.
struct KernelReport {
    Machine machine;
    std::string peer; ///< name and version
    std::string mesh; ///< or scene, as the user named it
    uint32_t triangles = 0;
    std::string isa; ///< that Glint ran with
    std::vector<ClassRow> classes;
    std::vector<BuildRow> builds;
};

/// A comparison of whole frames with what it was taken with.
struct FrameReport {
    Machine machine;
    std::string peer;  ///< name and version
    std::string scene; ///< as the user named it
    FrameComparison comparison;
};

[[nodiscard]] std::string to_text(const FrameReport &report);
/// `{"machine": ..., "peer": ..., "cells": [...]}`.
[[nodiscard]] std::string to_json(const FrameReport &report);

[[nodiscard]] std::string to_text(const KernelReport &report);
/// `{"machine": ..., "peer": ..., "classes": [...], "builds": [...]}`.
[[nodiscard]] std::string to_json(const KernelReport &report);

} // namespace glint::bench
