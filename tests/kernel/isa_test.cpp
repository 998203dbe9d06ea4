// Instruction sets by name, and that the one asked for is the one that traces.
#include <set>

#include <gtest/gtest.h>

#include <glint/glint.hpp>
#include <glint/ray_query.hpp>

#include "kernel/kernel.hpp"
#include "support/meshes.hpp"

namespace glint::test {
namespace {

constexpr Isa every_isa[] = {Isa::scalar, Isa::sse4, Isa::avx2, Isa::avx512, Isa::neon, Isa::wasm};

std::vector<Isa> unavailable_isas() {
    std::vector<Isa> isas(std::begin(every_isa), std::end(every_isa));
    std::erase_if(isas, [](Isa isa) { return std::ranges::count(available_isas(), isa) > 0; });
    return isas;
}

TEST(Isas, have_names_of_their_own) {
    std::set<std::string_view> names;
    for (const Isa isa : every_isa) names.insert(isa_name(isa));
    EXPECT_EQ(names, (std::set<std::string_view>{"scalar", "sse4", "avx2", "avx512", "neon", "wasm"}));
}

TEST(Isas, begin_with_the_definition_and_end_with_the_one_in_use) {
    EXPECT_EQ(available_isas().front(), Isa::scalar);
    EXPECT_EQ(available_isas().back(), best_isa());
    EXPECT_EQ(Renderer(Accel::build(scene_of(cube())), {.threads = 1}).isa(), best_isa());
}

TEST(Isas, that_are_available_are_found_by_name) {
    for (const Isa isa : available_isas()) {
        const Result<Isa> found = find_isa(isa_name(isa));
        ASSERT_TRUE(found);
        EXPECT_EQ(*found, isa);
    }
}

/// The name is refused; the message says why, and lists all that there is.
void expect_refused(std::string_view name, std::string_view reason) {
    const Result<Isa> found = find_isa(name);
    ASSERT_FALSE(found) << name;
    EXPECT_EQ(found.error().code, ErrorCode::bad_input);
    const std::string message = found.error().text();
    EXPECT_NE(message.find("'" + std::string(name) + "'"), std::string::npos) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    std::string list = "there is: ";
    for (const Isa isa : available_isas())
        list += std::string(isa == Isa::scalar ? "" : ", ") + std::string(isa_name(isa));
    EXPECT_NE(message.find(list), std::string::npos) << message;
}

TEST(Isas, that_are_unknown_or_of_another_machine_are_refused_with_those_there_are) {
    for (const std::string_view name : {"", "sse9", "AVX2", "avx2 ", "avx", "unknown"}) {
        expect_refused(name, "unknown instruction set");
    }
    ASSERT_FALSE(unavailable_isas().empty()) << "no machine has them all";
    for (const Isa isa : unavailable_isas()) expect_refused(isa_name(isa), "not available on this machine");
}

TEST(Isas, that_are_not_available_count_as_scalar) {
    const auto accel = Accel::build(scene_of(cube()));
    for (const Isa isa : unavailable_isas()) {
        EXPECT_EQ(Renderer(accel, {1, isa}).isa(), Isa::scalar);
        EXPECT_EQ(RayQuery(accel, isa).isa(), Isa::scalar);
    }
}

TEST(Isas, have_kernels_of_their_own_which_renderers_and_queries_use) {
    const auto accel = Accel::build(scene_of(cube()));
    std::set<RenderTile> tiles;
    std::set<ClosestHits> closest;
    std::set<AnyHits> any;
    for (const Isa isa : available_isas()) {
        const Kernel &kernel = kernel_for(isa);
        EXPECT_EQ(kernel.isa, isa);
        tiles.insert(kernel.render_tile);
        closest.insert(kernel.closest_hits);
        any.insert(kernel.any_hits);
        EXPECT_EQ(Renderer(accel, {1, isa}).isa(), isa);
        EXPECT_EQ(RayQuery(accel, isa).isa(), isa);
    }
    EXPECT_EQ(tiles.size(), available_isas().size());
    EXPECT_EQ(closest.size(), available_isas().size());
    EXPECT_EQ(any.size(), available_isas().size());
}

} // namespace
} // namespace glint::test
