#pragma once

#include "core/document/moment_bytes.h"
#include "io/importer.h"
#include "io/project/packing.h"
#include "support/random_session.h"

#include <string>

/// A session as the window makes them: a part from a file, a block that is dragged with the mouse, edits, undo.
namespace knead::sessions {

/// All bodies of a model, soft, on a floor.
inline Scene restingScene(const Model& model, double spacing)
{
    Scene scene;
    double floor = 0;
    for (const Part& part : model.parts) {
        scene.bodies.push_back({.name = part.name,
                                .aggregate = std::make_shared<const Aggregate>(fill(part.mesh, {.spacing = spacing})),
                                .material = scenes::soft(),
                                .surface = std::make_shared<const TriangleMesh>(part.mesh)});
        floor = std::min(floor, part.box.min().z());
    }
    scene.floorHeight = floor;
    return scene;
}

/// Drags a tool down by some way [m], as with a mouse that moves every few steps.
inline void drag(Document& document, ToolId tool, const Vec3& from, const Vec3& way, int moves)
{
    for (int i = 1; i <= moves; ++i) {
        document.simulation.post(SetManipulatorMotion{tool, GoTo{scenes::placedAt(from + way * i / moves)}});
        for (int step = 0; step <= i % 3; ++step)
            document.simulation.step();
    }
}

inline void endGesture(Document& document, const std::string& name)
{
    document.history.append(recordOf(knead::endGesture(document.simulation), name));
}

/// The middle of what lies highest.
inline Vec3 topOf(const Part& part)
{
    Box top;
    for (const Vec3& vertex : part.mesh.vertices)
        if (vertex.z() > part.box.max().z() - 1e-6)
            top.extend(vertex);
    return top.center();
}

/// Entries: 0 start, 1 block added, 2 pushed down, 3 softened, 4 pushed aside from 2, which is the present one.
inline Project pressedPart(const std::string& file, double spacing)
{
    auto model = std::make_shared<const Model>(importFile(file));
    Document document(restingScene(*model, spacing));
    const Box box = model->parts[0].box;
    Manipulator block{.name = "Block 1", .size = Vec3::Constant(0.3 * box.sizes().x()), .forceLimit = 50};
    block.pose.position = topOf(model->parts[0]) + Vec3(0, 0, block.size.z() / 2 + spacing / 4);
    block.speedLimit = 3;
    document.simulation.post(AddManipulator{block});
    document.simulation.applyCommands();
    endGesture(document, "Add Block 1");
    const Vec3 down(0, 0, -1.5 * spacing);
    drag(document, 0, block.pose.position, down, 60);
    endGesture(document, "Push with Block 1");
    document.simulation.post(SetMaterial{0, scenes::clay()});
    for (int i = 0; i < 30; ++i)
        document.simulation.step();
    endGesture(document, "Material");
    document.visit(2);
    drag(document, 0, block.pose.position + down, Vec3(spacing, 0, 0), 30);
    endGesture(document, "Push aside");
    std::vector<std::size_t> parts(model->parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i] = i;
    Project project = projectOf(document, model, parts);
    project.import.paths = {file};
    project.import.spacing = SpacingChoice{SpacingChoice::Kind::Length, spacing};
    return project;
}

/// With moments as the window keeps them.
inline Project packed(Project project)
{
    for (HistoryRecord& entry : project.entries)
        if (const auto& bodies = project.starts[entry.start].scene.bodies; entry.moment)
            entry.moment = std::make_shared<const Bytes>(
                momentToBytes(momentFromBytes(*entry.moment, bodies), zstandardPacking()));
    return project;
}

} // namespace knead::sessions
