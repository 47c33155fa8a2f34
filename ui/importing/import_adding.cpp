// Parts of other files beside those that are open. Part of ImportFeature.
#include "core/message/message.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/format_filters.h"
#include "ui/frame/notices.h"
#include "ui/importing/import_feature.h"
#include "ui/language/said.h"
#include "ui/project/projects_feature.h"

#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QTimer>

#include <algorithm>
#include <ranges>
#include <utility>

namespace knead {

namespace {

/// "a.step", or "a.step and 2 more".
QString namesOf(const QStringList& paths)
{
    const QString first = QFileInfo(paths.front()).fileName();
    const auto others = static_cast<int>(paths.size()) - 1;
    return others == 0 ? first : ImportFeature::tr("%1 and %n more", nullptr, others).arg(first);
}

} // namespace

void ImportFeature::askForParts()
{
    const FileQuestion question{.name = "addPartDialog",
                                .title = tr("Add parts"),
                                .filters = QStringList(tr("Parts (%1)").arg(patternsToRead())) + filtersToRead(),
                                .key = "folder"};
    askForFilesToRead(m_bench.window, question, [this](const QStringList& paths) { addParts(paths); });
}

void ImportFeature::addParts(const QStringList& paths)
{
    if (m_bench.document.isEmpty() || paths.empty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    m_bench.document.pause();
    m_bench.document.whenSettled([this, paths] {
        if (!m_bench.document.isEmpty() && !m_bench.isBusy())
            startAdding(paths);
    });
}

void ImportFeature::startAdding(const QStringList& paths)
{
    constexpr int untilNextLook = 20; // [ms]
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    if (m_bench.document.isPlaying())
        return addParts(paths);
    if (!m_bench.document.showsEdits()) { // a frame of what was done last is on its way
        QTimer::singleShot(untilNextLook, this, [this, paths] { startAdding(paths); });
        return;
    }
    const ImportChoices choices = usualChoices(paths);
    const AdditionRequest request{choices.paths, choices.options, startMaterial(m_bench.services.materials)};
    const auto work = [before = m_bench.document.content(), shown = m_bench.document.frame(),
                       fixtures = m_bench.document.fixtures().list(), request, import = m_bench.services.import,
                       writeAndRead = m_bench.services.writeAndRead](TaskControl& control) {
        return prepareAddition(before, shown, fixtures, request, import, writeAndRead, control);
    };
    const auto finish = [this, paths, edits = m_bench.document.edits(),
                         entry = m_bench.document.history().tree().current()](PreparedAddition addition) {
        const Document& document = m_bench.document;
        if (document.isEmpty())
            return;
        if (document.edits() == edits && document.history().tree().current() == entry && !document.isPlaying() &&
            !document.isAnythingUnderWay() && !document.isGoing())
            showAdded(std::move(addition), paths);
        else
            m_bench.notices.problem(
                tr("Something else was done while parts were read, so none were added. Add them again."),
                tr("Add again"), [this, paths] { addParts(paths); });
    };
    m_bench.tasks.run<PreparedAddition>(tr("Adding %1").arg(namesOf(paths)), work, finish);
}

void ImportFeature::showAdded(PreparedAddition addition, const QStringList& paths)
{
    const FilledModel before = m_bench.document.content();
    const std::vector<std::size_t> origin = addition.done.carried.origin;
    const ExportReport report = std::move(addition.done.report);
    const std::string name = QFileInfo(paths.front()).fileName().toStdString();
    m_bench.document.deform(
        std::move(addition.done),
        (paths.size() == 1 ? Message("Document", "Add %1") : Message("Document", "Add %1 and others")).with(name));
    for (const QString& path : std::views::reverse(paths)) // the first one is the first of the list
        m_projects.addRecent(path);
    const FilledModel& content = m_bench.document.content();
    const auto body = std::ranges::find(content.bodies, addition.first, &FilledBody::part);
    if (body != content.bodies.end())
        m_bench.document.select({Selection::Kind::Body, static_cast<BodyId>(body - content.bodies.begin())});
    if (!addition.moved.empty()) {
        QStringList moved;
        for (const std::string& path : addition.moved)
            moved << QFile::decodeName(path.c_str());
        m_bench.notices.remark(
            tr("Put beside other things or on the floor, where there is room: %1.").arg(namesOf(moved)));
    }
    if (!addition.freed.empty()) {
        QStringList freed;
        for (const std::string& fixture : addition.freed)
            freed << QString::fromStdString(fixture);
        m_bench.notices.problem(tr("What these fixtures held was kneaded and has other objects now; they are gone: %1.")
                                    .arg(freed.join(", ")));
    }
    tellOfSurfaces(addition.first, before.unfilled, origin);
    for (const Message& missing : addition.missing)
        m_bench.notices.problem(said(missing));
    if (!report.parts.empty())
        emit shapesTaken(report);
}

/// Parts that are only shown: the new ones, and others that the filling has no room for any more.
/// @param first of the new parts @param before what was unfilled @param origin see PartsInstead
void ImportFeature::tellOfSurfaces(std::size_t first, const std::map<std::size_t, Message>& before,
                                   const std::vector<std::size_t>& origin)
{
    const FilledModel& content = m_bench.document.content();
    for (const auto& surface : content.surfaces) {
        const std::size_t part = surface->body->part;
        const std::string name = m_bench.document.nameOfPart(part).toStdString();
        const auto why = content.unfilled.find(part);
        if (why != content.unfilled.end() && !(part < first && before.contains(origin[part])))
            m_bench.notices.problem(
                said(Message("ImportFeature", "\"%1\" is not simulated: %2").with(name, why->second)));
        else if (why == content.unfilled.end() && part >= first)
            m_bench.notices.problem(said(Message("Filling", "\"%1\" is not a closed solid: it is shown, and not "
                                                            "simulated. Close its surfaces and import it again.")
                                             .with(name)));
    }
}

} // namespace knead
