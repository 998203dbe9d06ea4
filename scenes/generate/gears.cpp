// A clockwork on a table: gears that really mesh, on three levels, some sharing an axle.
//
// After the model "gears" of Eric Haines, "A Proposal for Standard Graphics Environments", IEEE Computer Graphics and
// Applications 7(11), 1987; ours is a train of wheels of many sizes rather than a lattice of equal ones.
#include "generate/gear.hpp"
#include "generate/models.hpp"
#include "generate/shapes.hpp"
#include "generate/trig.hpp"

namespace glint::scenes {
namespace {

enum Metal : size_t { brass, steel, copper, metal_count };

/// How a gear joins those before it.
struct Joint {
    enum Kind { first, meshes_with, on_axle_of } kind;
    size_t other;     ///< index of the gear it joins
    double direction; ///< meshes_with: turns, from the other's middle to its own
};

struct TrainGear {
    Gear gear;
    Metal metal;
    int level;
    Joint joint;
};

struct Placed {
    Vec2 middle;
    double phase; ///< turns by which a tooth is off the x axis
};

/// Level 0 lies just over the table.
double level_y(int level) {
    return 0.35 + 0.5 * level;
}

/// Seen at 53 degrees over the table (3-4-5).
constexpr Tilt view_tilt{0.6, 0.8};

const std::vector<TrainGear> &clockwork() {
    using enum Joint::Kind;
    static const std::vector<TrainGear> train{
        {{56, 0.32, 0.20, 6}, brass, 0, {first, 0, 0.0}},         // 0: the great wheel
        {{18, 0.32, 0.20, 0}, steel, 1, {on_axle_of, 0, 0.0}},    // 1
        {{20, 0.32, 0.15, 0}, steel, 0, {meshes_with, 0, 0.93}},  // 2: to the right
        {{40, 0.28, 0.15, 5}, copper, 1, {on_axle_of, 2, 0.0}},   // 3
        {{16, 0.32, 0.12, 0}, steel, 1, {meshes_with, 3, 0.20}},  // 4
        {{32, 0.28, 0.12, 4}, brass, 2, {on_axle_of, 4, 0.0}},    // 5
        {{46, 0.30, 0.15, 6}, copper, 1, {meshes_with, 1, 0.41}}, // 6: to the left and back
        {{14, 0.32, 0.15, 0}, steel, 2, {on_axle_of, 6, 0.0}},    // 7
        {{38, 0.28, 0.15, 5}, brass, 2, {meshes_with, 7, 0.19}},  // 8
        {{24, 0.32, 0.15, 4}, copper, 0, {meshes_with, 0, 0.64}}, // 9: to the front
        {{16, 0.32, 0.12, 0}, steel, 0, {meshes_with, 9, 0.40}},  // 10
        {{22, 0.32, 0.12, 0}, brass, 0, {meshes_with, 9, 0.92}},  // 11
        {{28, 0.30, 0.12, 4}, steel, 1, {on_axle_of, 11, 0.0}},   // 12
    };
    return train;
}

Placed place(const TrainGear &gear, const std::vector<Placed> &placed, const std::vector<TrainGear> &train) {
    if (gear.joint.kind == Joint::first) return {{0.0, 0.0}, 0.0};
    const Placed &other = placed[gear.joint.other];
    if (gear.joint.kind == Joint::on_axle_of) return other;
    const uint32_t other_teeth = train[gear.joint.other].gear.teeth;
    const double distance = pitch_radius(other_teeth) + pitch_radius(gear.gear.teeth);
    const auto [cosine, sine] = cos_sin_turns(gear.joint.direction);
    return {other.middle + distance * Vec2{cosine, sine},
            meshing_phase(gear.gear.teeth, gear.joint.direction, other_teeth, other.phase)};
}

} // namespace

std::vector<NamedMesh> gears() {
    std::vector<NamedMesh> files{{"gears_brass.obj", "Gears: the wheels of brass.", {}},
                                 {"gears_steel.obj", "Gears: the wheels of steel.", {}},
                                 {"gears_copper.obj", "Gears: the wheels of copper.", {}},
                                 {"gears_axles.obj", "Gears: the axles.", {}}};
    Mesh &axles = files[metal_count].mesh;

    const std::vector<TrainGear> &train = clockwork();
    std::vector<Placed> placed;
    for (const TrainGear &gear : train) {
        const Placed &here = placed.emplace_back(place(gear, placed, train));
        Mesh mesh = gear_mesh(gear.gear);
        const auto [cosine, sine] = cos_sin_turns(here.phase);
        for (Vec3 &p : mesh.positions) p = Turn{cosine, sine}(p);
        files[gear.metal].mesh.append(mesh, 1.0, {here.middle.x, level_y(gear.level), -here.middle.y});
    }

    // One axle for each gear that is not on another's, up through the highest gear on it.
    for (size_t g = 0; g < train.size(); ++g) {
        if (train[g].joint.kind == Joint::on_axle_of) continue;
        int top_level = train[g].level;
        for (const TrainGear &other : train)
            if (other.joint.kind == Joint::on_axle_of && other.joint.other == g) top_level = other.level;
        const double radius = train[g].gear.bore_radius - 0.01;
        const double top = level_y(top_level) + 0.35;
        const Mesh axle =
            lathe({{0.0, 0.02}, {radius, 0.02}, {radius, top - 0.06}, {radius - 0.06, top}, {0.0, top}}, 48);
        axles.append(axle, 1.0, {placed[g].middle.x, 0.0, -placed[g].middle.y});
    }
    files.push_back({"gears_table.obj", "Gears: the table top.", box({-20.0, -0.4, -20.0}, {20.0, 0.0, 20.0})});
    rotate_all(files, view_tilt);
    return files;
}

} // namespace glint::scenes
