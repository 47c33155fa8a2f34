#include "realtime/realtime_scenes.h"

#include "support/scenes.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double side = 0.04; // of the parts, about [m]
constexpr double pressShare = 0.06;

/// Objects of the part within a box are held.
void hold(Scene& scene, const Box& within)
{
    scene.fixtures.push_back({"held", 0, objectsInBox(*scene.bodies[0].aggregate, within)});
}

RealtimeScene pressed(const char* name, const TriangleMesh& mesh, const Material& material, double volume,
                      double objects)
{
    RealtimeScene result{.name = name};
    result.scene.bodies.push_back(scenes::body(mesh, std::cbrt(volume / objects), material, name));
    result.scene.integrator = Integrator::implicitEuler;
    return result;
}

/// A tool over a place of the part's upper side. Its limit is what half of its section bears at a strain of a fifth, or where
/// the material yields.
void addTool(RealtimeScene& scene, ToolKind kind, const Vec3& size, const Vec3& place, const Material& material)
{
    scene.height = 0.002;
    scene.depth = pressShare * side;
    scene.slide = Vec3(0.1 * side, 0, 0);
    const double strength = std::min(0.2 * material.youngsModulus,
                                     material.yieldStress > 0 ? material.yieldStress : material.youngsModulus);
    Manipulator tool{.name = "hand", .size = size, .speedLimit = 0.2};
    tool.kind = kind;
    tool.forceLimit = 0.5 * strength * size.x() * size.y();
    tool.pose.position = place + Vec3(0, 0, 0.5 * size.z() + scene.height);
    scene.scene.manipulators.push_back(tool);
}

} // namespace

std::vector<RealtimeScene> realtimeScenes(const Material& material, double objects)
{
    std::vector<RealtimeScene> scenes;
    constexpr double reach = 1;
    constexpr double tool = 0.3 * side;

    RealtimeScene block = pressed("block", shapes::box(Vec3(side, side, side)), material, side * side * side, objects);
    hold(block.scene, Box(Vec3(-reach, -reach, -reach), Vec3(reach, reach, -0.49 * side)));
    addTool(block, ToolKind::ball, Vec3(tool, tool, tool), Vec3(0, 0, 0.5 * side), material);
    scenes.push_back(block);

    const Vec3 bar(4 * side, side, side);
    RealtimeScene bent = pressed("bar", shapes::box(bar), material, bar.prod(), objects);
    hold(bent.scene, Box(Vec3(-reach, -reach, -reach), Vec3(-0.49 * bar.x(), reach, reach)));
    addTool(bent, ToolKind::box, Vec3(tool, bar.y(), tool), Vec3(0.4 * bar.x(), 0, 0.5 * bar.z()), material);
    scenes.push_back(bent);

    // Legs in x and y, extruded along z: it stands on one leg's side, and is pressed on the other's upper end.
    const double leg = 2 * side;
    const double thickness = 0.3 * side;
    RealtimeScene bracket = pressed("bracket", shapes::bracket(leg, thickness, side), material,
                                    (2 * leg - thickness) * thickness * side, objects);
    hold(bracket.scene, Box(Vec3(0.9 * leg, -reach, -reach), Vec3(reach, reach, reach)));
    addTool(bracket, ToolKind::ball, Vec3(tool, tool, tool), Vec3(0.5 * thickness, 0.8 * leg, side), material);
    scenes.push_back(bracket);

    const Vec3 box(2 * side, 2 * side, side);
    const Vec3 inside = box - Vec3::Constant(0.2 * side);
    RealtimeScene thin =
        pressed("thin box", shapes::hollowBox(box, inside), material, box.prod() - inside.prod(), objects);
    hold(thin.scene, Box(Vec3(-reach, -reach, -reach), Vec3(reach, reach, -0.49 * box.z())));
    addTool(thin, ToolKind::ball, Vec3(tool, tool, tool), Vec3(0, 0, 0.5 * box.z()), material);
    scenes.push_back(thin);

    RealtimeScene rubbing = pressed("two bodies", shapes::box(Vec3(side, side, 0.5 * side)), material,
                                    0.5 * side * side * side, objects / 2);
    Body upper = rubbing.scene.bodies[0];
    upper.name = "upper";
    upper.aggregate = std::make_shared<const Aggregate>(
        fill(shapes::moved(shapes::box(Vec3(side, side, 0.5 * side)), {.position = Vec3(0, 0, 0.5 * side)}),
             {.spacing = upper.aggregate->lattice.spacing}));
    rubbing.scene.bodies.push_back(upper);
    hold(rubbing.scene, Box(Vec3(-reach, -reach, -reach), Vec3(reach, reach, -0.245 * side)));
    addTool(rubbing, ToolKind::box, Vec3(0.8 * side, 0.8 * side, tool), Vec3(0, 0, 0.75 * side), material);
    scenes.push_back(rubbing);

    RealtimeScene rest = pressed("at rest", shapes::box(Vec3(side, side, side)), material, side * side * side, objects);
    rest.scene.gravity = Vec3(0, 0, -9.81);
    rest.scene.floorHeight = -0.5 * side;
    scenes.push_back(rest);
    return scenes;
}

Vec3 handAt(const RealtimeScene& scene, double time)
{
    // Comes, presses, stays, slides, stays, lifts.
    const double down = scene.height + scene.depth;
    const auto share = [time](double begin, double end) {
        return std::clamp((time - begin) / (end - begin), 0.0, 1.0);
    };
    const double z =
        -scene.height * share(0, 0.1) - scene.depth * share(0.1, 0.5) + (down + scene.height) * share(1, 1.2);
    return Vec3(0, 0, z) + share(0.65, 0.9) * scene.slide;
}

} // namespace knead
