#pragma once

#include "core/aggregate/fill.h"
#include "core/aggregate/spacing_choice.h"
#include "core/document/project.h"
#include "core/message/message.h"
#include "core/session/import_files.h"
#include "core/session/recipe_start.h"
#include "core/session/render_mesh.h"
#include "core/simulation/gesture.h"
#include "core/simulation/scripted_events.h"
#include "core/skin/skin.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace knead {

class Fillings;

/// A body as the window shows it: the fine surface of its part and the map that carries it along. Immutable, shared
/// between threads. Those that the functions here return keep the fillings of the body with them.
struct FilledBody : std::enable_shared_from_this<FilledBody> {
    std::size_t part = 0; ///< index into Model::parts
    std::string name;     ///< unique in the document
    Color color;
    TriangleMesh mesh; ///< surface, fine enough to bend [m]
    RenderMesh render;
    std::shared_ptr<const Aggregate> aggregate;
    std::optional<Skin> skin;                ///< of mesh.vertices
    std::vector<ObjectIndex> surfaceObjects; ///< those a person can see
    std::weak_ptr<Fillings>
        fillings; ///< the same body as it was filled at other times, shared by all of them, which it keeps
    std::shared_ptr<const FilledBody> whole; ///< before it came apart or was cut into; null: neither
};

/// The body, with fillings that it has none of yet.
std::shared_ptr<const FilledBody> withNewFillings(const std::shared_ptr<FilledBody>& body);
std::vector<ObjectIndex> surfaceObjects(const Aggregate& aggregate); ///< those a person can see

/// The body with the objects of another filling of it: its surface is the same. Any thread; takes as long as a skin where that
/// filling was not seen lately.
std::shared_ptr<const FilledBody> filledAs(const std::shared_ptr<const FilledBody>& body,
                                           const std::shared_ptr<const Aggregate>& aggregate);

/// The body as it is shown when some of its connections are broken: where it has come apart or is cut into, with the surfaces of its
/// pieces and the sides of its cracks. Any thread; takes as long as these where they were not seen lately.
/// @param filled of any filling, come apart or not @param broken null: none
std::shared_ptr<const FilledBody> tornAs(const std::shared_ptr<const FilledBody>& filled,
                                         const std::shared_ptr<const std::vector<BrokenConnection>>& broken);

/// What tornAs() said a moment ago of the same pieces, where a crack has only grown since and it is too early to follow it; null
/// else. Any thread.
std::shared_ptr<const FilledBody> tornLately(const std::shared_ptr<const FilledBody>& filled,
                                             const std::shared_ptr<const std::vector<BrokenConnection>>& broken);

/// Whether two have the same surface, so that places on the one are places on the other. Bodies of another opened file, or of the
/// same one filled by another command, have not.
inline bool haveSameSurface(const FilledBody& one, const FilledBody& other)
{
    const bool isSameBody = !one.fillings.owner_before(other.fillings) && !other.fillings.owner_before(one.fillings);
    return one.part == other.part && isSameBody && (&one == &other || (!one.whole && !other.whole));
}

/// The surface of a body at one moment.
struct BodyFrame {
    std::vector<Vec3> places;                     ///< of the vertices of FilledBody::mesh [m]
    std::vector<float> points;                    ///< x y z per render vertex [m]
    std::vector<float> normals;                   ///< x y z per render vertex
    std::vector<float> shades;                    ///< per render vertex, see reliefShades(); empty: none
    std::vector<std::uint32_t> acrossCracks = {}; ///< triangles that are not drawn, see trianglesAcrossCracks()

    Vec3 point(std::uint32_t vertex) const ///< of a render vertex [m]
    {
        return Eigen::Map<const Eigen::Vector3f>(points.data() + std::size_t{3} * vertex).cast<double>();
    }
};

/// A part without an inside to fill: it is shown as it is and takes no part in the simulation.
struct FilledSurface {
    std::shared_ptr<const FilledBody> body; ///< without aggregate and skin
    BodyFrame frame;
};

/// Everything made from files, ready to be shown and simulated.
struct FilledModel {
    std::shared_ptr<const Model> model;
    ImportChoices request; ///< that it was made for
    std::vector<std::shared_ptr<const FilledBody>>
        bodies; ///< in the order of Scene::bodies; none when no part is closed
    std::vector<std::shared_ptr<const FilledSurface>> surfaces;
    std::map<std::size_t, Message> unfilled; ///< parts that were to be filled and could not be, and why
    double spacing = 0;                      ///< [m]; 0 without bodies
    SpacingAssessment fineness;              ///< what the spacing means for the walls
    Box box;                                 ///< of all bodies and surfaces at rest [m]
    std::vector<Message> warnings;           ///< sentences for the person

    bool isEmpty() const { return bodies.empty() && surfaces.empty(); }
    /// Parts that are hidden in their file, by index into Model::parts.
    std::set<std::size_t> hiddenAtFirst() const;
};

/// A part with its objects, ready to be drawn and measured. @throws Cancelled
std::shared_ptr<const FilledBody> filledBody(const Model& model, std::size_t part, const std::string& name,
                                             std::shared_ptr<const Aggregate> aggregate, TaskControl& control);

/// "Part", or "Part 2" where that is taken.
std::string uniqueName(const std::string& name, std::set<std::string>& taken);

/// The color of a CAD face.
Color faceColor(const Part& part, std::uint32_t face);

/// tellingName() of a face of a body. @pre body < content.bodies.size()
std::string nameOfFace(const FilledModel& content, BodyId body, std::uint32_t face);

struct Frame; // core/session/frame.h

/// A content with the simulation of its bodies and what is drawn at its start, as a task hands it over.
struct PreparedModel {
    FilledModel content;
    Scene scene; ///< that the simulation begins with
    Simulation simulation;
    std::shared_ptr<const Frame> frame;
    Gesture first;                          ///< nothing was done yet: where a history begins
    Message name = {};                      ///< of the first entry of the history; empty: after the file
    ScriptedEventsMaker script = {};        ///< of a recipe: what happens while time runs
    std::vector<FaceFixture> fixtures = {}; ///< of a recipe: faces that its fixtures hold
};

/// Reads files, fills their closed parts with a material and lets them rest on a floor. Runs on a task thread.
/// @throws std::runtime_error with a sentence, also when no part has a surface; Cancelled
PreparedModel prepareFiles(const ImportFiles& import, const ImportChoices& request, const Material& material,
                           TaskControl& control);

/// As prepareFiles() with a model that was read already: after another choice of unit.
PreparedModel prepareModel(std::shared_ptr<const Model> model, const ImportChoices& request, const Material& material,
                           TaskControl& control);

/// As a recipe has it. Runs on a task thread. @throws as prepareFiles()
PreparedModel prepareRecipe(RecipeStart recipe, TaskControl& control);

/// Fills the parts of a content again with another spacing [m]; materials, kinds of bodies, tools, gravity and floor stay as in
/// `now`, and fixtures on their faces. Runs on a task thread.
/// @throws as prepareFiles(), and std::runtime_error with a sentence when none of them suits the spacing
PreparedModel prepareRefill(const FilledModel& before, double spacing, const Snapshot& now,
                            const std::vector<FaceFixture>& fixtures, TaskControl& control);

/// Parts that take the place of those of a content.
struct PartsInstead {
    static constexpr auto none = static_cast<std::size_t>(-1);
    std::shared_ptr<const Model> model;
    std::vector<std::size_t> origin; ///< per part: which one of the content's model it was; `none`: it was not there
    Material material = {};          ///< of those that were not there
};

/// Fills other parts in place of those of a content, as prepareRefill() does: after they were deformed, or others were added.
/// @param fixturesIn the fixtures in the new content
/// @throws as prepareFiles()
PreparedModel prepareInstead(const FilledModel& before, const PartsInstead& parts, const Snapshot& now,
                             const std::function<std::vector<FaceFixture>(const FilledModel&)>& fixturesIn,
                             TaskControl& control);

/// The content of a start that was kept in a project: as when it was filled, without filling. Runs on a task thread.
/// @throws std::runtime_error with a sentence; Cancelled
FilledModel contentOf(std::shared_ptr<const Model> model, const ImportChoices& choices, const ProjectStart& start,
                      TaskControl& control);

/// What a project keeps of a start.
ProjectStart startOf(const FilledModel& content, Scene scene);

} // namespace knead
