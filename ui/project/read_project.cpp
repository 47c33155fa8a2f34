#include "ui/project/read_project.h"

#include "core/document/mended_project.h"

#include <filesystem>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr double readingShare = 0.4; // of the progress bar
constexpr double mendingShare = 0.6;

/// What was read, before anything of it is shown.
struct Raw {
    Project project;
    WorkState state; ///< of a recovery
};

void append(std::vector<Message>& list, std::vector<Message> more)
{
    list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

Raw readFile(const ProjectRequest& request, const ProjectServices& services, ReadProject& result, TaskControl& control)
{
    if (request.rescues) {
        RescuedProject rescued = services.rescue(request.path, control);
        append(result.missing, std::move(rescued.missing));
        return {std::move(rescued.project), {}};
    }
    if (!request.isCopy) {
        try {
            result.lock = request.lock ? request.lock : services.lock(request.path);
        } catch (const std::runtime_error& error) {
            result.obstacle = ReadProject::Obstacle::lock;
            result.sentence = messageOf(error);
            return {};
        }
        result.path = request.path;
    }
    try {
        result.isSaved = true;
        return {services.read(request.path, control), {}};
    } catch (const DamagedProject& error) {
        result.obstacle = ReadProject::Obstacle::damage;
        result.sentence = messageOf(error);
        return {};
    }
}

std::string nameOf(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

Message about(const std::string& path, const Message& sentence)
{
    return sentence.with(nameOf(path));
}

/// The file of recovered work may have been written since, or be another window's by now: then the work has none.
void takeFileOf(const WorkState& state, const ProjectRequest& request, const ProjectServices& services,
                ReadProject& result)
{
    if (state.projectFile.empty())
        return;
    if (state.isFileReplaced) {
        result.sentence =
            about(state.projectFile,
                  Message("ReadProject", "%1 was written after this work was cut off, and stays as it is: "
                                         "save the work under a name of its own, or in place of that file."));
        return;
    }
    try {
        result.lock = request.lock ? request.lock : services.lock(state.projectFile);
        result.path = state.projectFile;
    } catch (const std::runtime_error& error) {
        result.sentence = messageOf(error);
    }
}

/// Work of which something is missing shall not take the place of what may be whole.
void letGoOfFile(ReadProject& result)
{
    if (result.path.empty())
        return;
    result.sentence =
        about(result.path, Message("ReadProject", "%1 stays as it is, since the recovered work is not whole: save "
                                                  "the work under a name of its own, or in place of that file."));
    result.path.clear();
    result.lock.reset();
}

Raw readRecovery(const ProjectRequest& request, const ProjectServices& services, ReadProject& result,
                 TaskControl& control)
{
    result.kept = services.takeOver(*request.recovery);
    RecoveredWork work = result.kept->read(control);
    append(result.missing, std::move(work.missing));
    takeFileOf(work.state, request, services, result);
    return {std::move(work.project), std::move(work.state)};
}

/// Moments that are not whole, and what was under way.
Project mended(Raw raw, const Packing& packing, ReadProject& result, TaskControl& control)
{
    MendedProject reachable = withReachableEntry(std::move(raw.project), packing, control);
    const bool isCut = !reachable.missing.empty(); // the gesture went on from what is missing
    append(result.missing, std::move(reachable.missing));
    MendedProject done = withGesture(std::move(reachable.project), isCut ? WorkState{} : raw.state, packing, control);
    append(result.missing, std::move(done.missing));
    return std::move(done.project);
}

void prepare(Project project, const Packing& packing, ReadProject& result, TaskControl& control)
{
    if (project.model == nullptr)
        throw Problem(Message("ReadProject", "The parts of this project are lost, so that nothing of it can be shown. "
                                             "Open the part that it was made from."));
    result.view = project.view;
    result.marks = project.marks;
    result.panels = project.panels;
    if (!project.entries.empty()) {
        result.project = prepareProject(std::move(project), packing, control);
        return;
    }
    result.parts = prepareModel(project.model, project.import, {}, control);
    result.missing.push_back(Message("Project", "what was done to the parts"));
}

} // namespace

ReadProject readProjectFor(const ProjectRequest& request, const ProjectServices& services, const Packing& packing,
                           TaskControl& control)
{
    ReadProject result;
    TaskPortion reading(control, 0, readingShare);
    Raw raw = request.recovery ? readRecovery(request, services, result, reading)
                               : readFile(request, services, result, reading);
    if (result.obstacle != ReadProject::Obstacle::none)
        return result;
    Project project;
    if (request.recovery || request.rescues) {
        TaskPortion mending(control, readingShare, mendingShare);
        project = mended(std::move(raw), packing, result, mending);
    } else
        project = std::move(raw.project);
    TaskPortion preparing(control, mendingShare, 1);
    try {
        prepare(std::move(project), packing, result, preparing);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        if (request.recovery || request.rescues)
            throw;
        result.obstacle = ReadProject::Obstacle::damage;
        result.sentence = Message("Project", "%1: what was seen last cannot be shown. %2 What is whole can be rescued.")
                              .with(nameOf(request.path), messageOf(error));
    }
    if (request.recovery && !result.missing.empty())
        letGoOfFile(result);
    return result;
}

} // namespace knead
