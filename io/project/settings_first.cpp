#include "io/recipe/recipe_of_project.h"

#include "core/document/history.h"

#include <algorithm>
#include <limits>

namespace knead {

namespace {

/// Takes a command over into a scene. @return whether it is one that can be
struct Settler {
    Scene& scene;

    bool operator()(const SetMaterial& command) const
    {
        Body& body = scene.bodies.at(command.body);
        if (command.objects.empty())
            body.material = command.material;
        else
            body.regions.push_back({"region", command.objects, command.material});
        return true;
    }
    bool operator()(const SetBodyKind& command) const
    {
        scene.bodies.at(command.body).kind = command.kind;
        return true;
    }
    bool operator()(const SetGravity& command) const
    {
        scene.gravity = command.gravity;
        return true;
    }
    bool operator()(const SetFloor& command) const
    {
        scene.floorHeight = command.height;
        scene.floorFriction = command.friction;
        scene.floorAdhesion = command.adhesion;
        return true;
    }
    bool operator()(const SetIntegrator& command) const
    {
        scene.integrator = command.integrator;
        return true;
    }
    template <class Other>
    bool operator()(const Other&) const
    {
        return false;
    }
};

/// @return whether time goes on after these
bool settle(std::vector<RecordedCommand>& commands, Scene& scene)
{
    const auto isLater = [](const RecordedCommand& recorded) {
        return recorded.step > 0 || std::holds_alternative<Reset>(recorded.command);
    };
    const auto end = std::find_if(commands.begin(), commands.end(), isLater);
    const bool goesOn = end != commands.end();
    const auto kept = std::remove_if(commands.begin(), end, [&](const RecordedCommand& recorded) {
        return std::visit(Settler{scene}, recorded.command);
    });
    commands.erase(kept, end);
    return goesOn;
}

} // namespace

Project withSettingsFirst(Project project)
{
    const History history(project.entries, project.current, std::numeric_limits<std::size_t>::max());
    const std::uint32_t start = project.entries.at(project.current).start;
    for (const History::Entry entry : history.pathTo(project.current)) {
        HistoryRecord& record = project.entries[entry];
        if (record.start == start && (settle(record.commands, project.starts.at(start).scene) || record.step > 0))
            break;
    }
    return project;
}

} // namespace knead
