#include "app/opened_shape.h"

#include "app/cad_process.h"
#include "core/message/message.h"
#include "core/model/file_names.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"

#include <set>
#include <utility>

namespace knead {

namespace {

OpenedShape openProject(const std::string& path, std::optional<std::uint32_t> entry, TaskControl& control)
{
    PreparedProject prepared = openEntry(path, entry, control);
    OpenedShape shape{.content = *prepared.destination.content,
                      .frame = prepared.destination.frame,
                      .entry = prepared.project.current};
    for (const HistoryRecord& record : prepared.project.entries)
        shape.entries.push_back(record.name);
    shape.content.bodies = shape.frame->filled; // perhaps filled anew, or in pieces
    return shape;
}

/// Its closed parts as they are: nothing has to be filled for what does not move.
OpenedShape openFile(const std::string& path, const ImportOptions& how, TaskControl& control)
{
    OpenedShape shape;
    auto model = std::make_shared<const Model>(importInChild(path, how, control));
    auto frame = std::make_shared<Frame>();
    auto snapshot = std::make_shared<Snapshot>();
    std::set<std::string> names;
    for (std::size_t p = 0; p < model->parts.size(); ++p) {
        const Part& part = model->parts[p];
        if (!part.canBeFilled())
            continue;
        auto body = std::make_shared<FilledBody>();
        body->part = p;
        body->name = uniqueName(part.name, names);
        body->color = part.color.value_or(Color{});
        body->mesh = part.mesh;
        shape.content.box.extend(part.box);
        shape.content.bodies.push_back(body);
        auto places = std::make_shared<BodyFrame>();
        places->places = part.mesh.vertices;
        frame->bodies.push_back(std::move(places));
        snapshot->bodies.emplace_back();
        snapshot->materials.emplace_back();
    }
    shape.warnings = remarksOnImport(*model);
    shape.content.model = std::move(model);
    frame->filled = shape.content.bodies;
    frame->snapshot = std::move(snapshot);
    shape.frame = std::move(frame);
    return shape;
}

} // namespace

std::vector<Message> remarksOnImport(const Model& model)
{
    std::vector<Message> all = model.missing;
    all.insert(all.end(), model.warnings.begin(), model.warnings.end());
    if (model.unitRemark)
        all.push_back(model.unitRemark->sentence);
    for (const Part& part : model.parts)
        for (const Message& warning : part.warnings)
            all.push_back(Message::verbatim("%1 %2").with(part.name, warning));
    return all;
}

PreparedProject openEntry(const std::string& path, std::optional<std::uint32_t> entry, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.3);
    Project project = readProjectAfterTrial(path, reading);
    if (project.model == nullptr || project.entries.empty())
        throw Problem(aboutFile(path, Message("Measurement", "the project has no parts.")));
    project.current = entry.value_or(project.current);
    if (project.current >= project.entries.size())
        throw Problem(aboutFile(path, Message("Measurement", "the project has no entry %1; its last is %2.")
                                          .with(project.current, project.entries.size() - 1)));
    TaskPortion going(control, 0.3, 1);
    return prepareProject(std::move(project), zstandardPacking(), going);
}

OpenedShape openShape(const std::string& path, std::optional<std::uint32_t> entry, const ImportOptions& how,
                      TaskControl& control)
{
    const bool isProject = isProjectFile(path);
    if (entry && !isProject)
        throw Problem(aboutFile(path, Message("Measurement", "this is no project: it has no entries.")));
    OpenedShape shape = isProject ? openProject(path, entry, control) : openFile(path, how, control);
    if (shape.content.bodies.empty())
        throw Problem(
            aboutFile(path, Message("Measurement", "no part of it is closed, so there is nothing to measure.")));
    return shape;
}

} // namespace knead
