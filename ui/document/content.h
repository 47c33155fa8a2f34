#pragma once

#include "core/aggregate/fill.h"
#include "core/simulation/simulation.h"
#include "core/skin/skin.h"
#include "ui/services.h"
#include "ui/viewport/render_mesh.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// A body as the window shows it: the fine surface of its part and the map that carries it along. Immutable, shared
/// between threads.
struct ContentBody {
    std::size_t part = 0; ///< index into Model::parts
    std::string name;     ///< unique in the document
    Color color;
    TriangleMesh mesh; ///< surface, fine enough to bend [m]
    RenderMesh render;
    std::shared_ptr<const Aggregate> aggregate;
    std::optional<Skin> skin;                ///< of mesh.vertices
    std::vector<ObjectIndex> surfaceObjects; ///< those a person can see
};

/// Everything made from a file, ready to be shown and simulated.
struct Content {
    std::shared_ptr<const Model> model;
    std::vector<std::shared_ptr<const ContentBody>> bodies; ///< in the order of Scene::bodies
    double spacing = 0;                                     ///< [m]
    Box box;                                                ///< of all bodies at rest [m]
    std::vector<std::string> warnings;                      ///< sentences for the person
};

/// The color of a CAD face.
Color faceColor(const Part& part, std::uint32_t face);

/// A content with the simulation of its bodies, as a task hands it over.
struct PreparedContent {
    Content content;
    Simulation simulation;
};

/// What a person asked to be opened, and how.
struct OpenRequest {
    std::vector<std::string> paths; ///< at least one
    ImportOptions options;
    double spacing = 0; ///< [m]; 0: chosen for real time
};

/// Reads files, fills their closed parts with a material and lets them rest on a floor. Runs on a task thread.
/// @throws std::runtime_error with a sentence, also when no part has a surface; Cancelled
PreparedContent prepareFiles(const Services& services, const OpenRequest& request, const Material& material,
                             TaskControl& control);

/// Fills a model again with another spacing [m]; materials, kinds of bodies, tools, gravity and floor stay as in `now`. Runs on a task
/// thread.
/// @throws as prepareFile
PreparedContent prepareRefill(std::shared_ptr<const Model> model, double spacing, const Snapshot& now,
                              TaskControl& control);

} // namespace knead
