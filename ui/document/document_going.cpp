// Undo, redo, and going to any entry of the history. The tree is at the wanted entry at once; the simulation follows as soon as
// its moment was found, on another thread. Many requests in a row make one way.
#include "ui/document/document.h"

#include "core/simulation/moment.h"
#include "ui/document/entry_names.h"
#include "ui/language/said.h"
#include "ui/selection/selection_model.h"
#include "ui/tasks/task_runner.h"

#include <QTimer>

#include <limits>
#include <new>
#include <utility>

namespace knead {

std::optional<QString> Document::undoName() const
{
    if (m_history.isEmpty())
        return {};
    if (m_gesture.isAny)
        return m_gesture.name.empty() ? tr("Simulate") : said(m_gesture.name);
    const History& tree = m_history.tree();
    return tree.undoTarget() ? std::optional(said(tree.record(tree.current()).label())) : std::nullopt;
}

std::optional<QString> Document::redoName() const
{
    if (m_history.isEmpty() || m_gesture.isAny)
        return {};
    const std::optional<Entry> target = m_history.tree().redoTarget();
    return target ? std::optional(said(m_history.tree().record(*target).label())) : std::nullopt;
}

void Document::undo()
{
    request([](const History& tree) { return tree.undoTarget(); });
}

void Document::redo()
{
    request([](const History& tree) { return tree.redoTarget(); });
}

void Document::goToEntry(Entry entry)
{
    request(
        [entry](const History& tree) { return entry < tree.records().size() ? std::optional(entry) : std::nullopt; });
}

/// What is under way becomes an entry before anything else, so that nothing is lost.
void Document::request(Request request)
{
    if (m_history.isEmpty())
        return;
    if (!isGoing())
        standStill();
    m_requests.push_back(std::move(request));
    takeRequests();
}

/// What was done until now is, or will be, in the history.
void Document::standStill()
{
    emit stopping();
    m_simulation->pause();
    m_isPlaying = false;
    finishGesture();
}

void Document::whenSettled(std::function<void()> action)
{
    if (isEmpty())
        return;
    if (!isGoing())
        finishGesture();
    m_whenSettled.push_back(std::move(action));
    if (m_history.isSettled())
        tellSettled();
}

void Document::tellSettled()
{
    takeRequests();
    const auto actions = std::exchange(m_whenSettled, {});
    for (const auto& action : actions)
        action();
}

void Document::takeRequests()
{
    if (!m_history.isSettled() || m_history.isEmpty())
        return; // called again when it is; where nothing is open there is nowhere to go
    const std::vector<Request> requests = std::exchange(m_requests, {});
    for (const Request& request : requests)
        if (const std::optional<Entry> entry = request(m_history.tree()))
            m_history.goTo(*entry);
    if (m_navigation != NavigationState::none)
        return; // goes on from there
    if (std::exchange(m_isTakenBack, false) || m_history.tree().current() != m_shown)
        setOut();
    else if (!requests.empty())
        endNavigation();
}

HistoryNavigation Document::navigationTo(Entry entry) const
{
    const History& tree = m_history.tree();
    HistoryNavigation navigation;
    navigation.way = tree.wayTo(entry);
    navigation.start = m_history.starts()[navigation.way.start];
    navigation.model = navigation.start.start.model ? navigation.start.start.model : m_opened;
    navigation.packing = m_history.packing();
    navigation.changesStart = navigation.way.start != tree.record(m_shown).start;
    return navigation;
}

void Document::setOut()
{
    m_target = m_history.tree().current();
    m_navigation = NavigationState::looking;
    ++m_travels;
    const HistoryNavigation navigation = navigationTo(m_target);
    if (navigation.isLong() && m_tasks != nullptr)
        goLong(navigation);
    else
        goShort(navigation);
}

/// With progress, to be cancelled.
void Document::goLong(const HistoryNavigation& navigation)
{
    const Message name = m_history.tree().record(m_target).label();
    const auto work = [navigation](TaskControl& control) { return navigation.go(control); };
    const auto finish = [this, travel = m_travels](HistoryDestination destination) {
        if (travel == m_travels)
            arrive(std::move(destination));
    };
    m_longTitle = said(Message("Document", "Going to %1").with(name));
    if (!m_tasks->run<HistoryDestination>(m_longTitle, work, finish))
        giveUp(said(Message("Document", "%1 is still going on: wait for it, or cancel it with Esc, then go to %2.")
                        .with(m_tasks->title().toStdString(), name)));
}

void Document::goShort(const HistoryNavigation& navigation)
{
    const Message name = m_history.tree().record(m_target).label();
    m_history.inBackground([this, navigation, name, travel = m_travels] {
        auto destination = std::make_shared<HistoryDestination>();
        QString failure;
        try {
            *destination = navigation.go(TaskControl::none());
        } catch (const std::bad_alloc&) {
            failure =
                said(Message("Document", "There is not enough memory to go to %1. Close other programs and try again.")
                         .with(name));
        } catch (const std::exception& error) {
            failure = said(messageOf(error));
        }
        const auto tell = [this, destination, failure, travel] {
            if (travel != m_travels)
                return;
            if (failure.isEmpty())
                arrive(std::move(*destination));
            else
                giveUp(failure);
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    });
}

void Document::arrive(HistoryDestination destination)
{
    if (destination.found)
        m_history.keep(m_target, std::move(destination.found));
    const std::uint32_t startIndex = m_history.tree().record(m_target).start;
    m_history.setModel(startIndex, destination.content);
    if (m_history.tree().current() != m_target) {
        endNavigation();
        return;
    }
    m_shown = m_target;
    const MomentPointer moment = destination.moment;
    if (destination.simulation) {
        const std::uint64_t hash = destination.simulation->stateHash();
        start(std::move(*destination.simulation), destination.content, std::move(destination.frame),
              scriptAt(startIndex, *moment, hash));
        m_start = startIndex;
        follow(*moment);
        emit changed(Change::Model);
        emit changed(Change::Selection);
        endNavigation();
        return;
    }
    goInSimulation(moment);
}

/// Of the start that is shown.
void Document::goInSimulation(MomentPointer moment)
{
    m_navigation = NavigationState::arriving; // until a frame shows it
    ++m_arrivals;
    ++m_edits;
    m_toolRequests.forget();
    follow(*moment);
    m_simulation->goTo(std::move(moment));
    emit changed(Change::Selection);
    emit changed(Change::Fixtures);
}

Timeline Document::timeline() const
{
    const bool isOfModel = !m_history.isEmpty() && m_history.tree().record(m_history.tree().current()).start == m_start;
    return isOfModel ? timelineOf(m_history.tree(), m_playback, m_gesture.isAny || !m_history.isSettled()) : Timeline();
}

void Document::branchAt(Entry entry, std::uint64_t step, std::uint32_t run)
{
    if (m_tasks == nullptr || m_history.isEmpty() || later([this, entry, step, run] { branchAt(entry, step, run); }))
        return;
    if (m_isPlaying || m_gesture.isAny || !m_history.isSettled()) {
        standStill();
        whenSettled([this, entry, step, run] { branchAt(entry, step, run); });
        return;
    }
    if (canBranchAt(entry))
        setOutForBranch(entry, step, run);
}

bool Document::canBranchAt(Entry entry) const
{
    const History& tree = m_history.tree();
    if (entry == 0 || entry >= tree.records().size())
        return false;
    const HistoryRecord& record = tree.record(entry);
    return record.start == m_start && record.start == tree.record(record.parent).start;
}

void Document::setOutForBranch(Entry entry, std::uint64_t step, std::uint32_t run)
{
    const HistoryRecord& record = m_history.tree().record(entry);
    m_target = record.parent;
    m_history.goTo(m_target);
    m_navigation = NavigationState::looking;
    ++m_travels;
    m_longTitle = said(Message("Document", "Branching from %1").with(record.label()));
    const auto work = [navigation = navigationTo(record.parent), commands = record.commands, step,
                       run](TaskControl& control) { return navigation.branch(commands, run, step, control); };
    const auto finish = [this, entry, travel = m_travels](Branch branch) {
        if (travel == m_travels)
            arriveAtBranch(entry, std::move(branch));
    };
    if (!m_tasks->run<Branch>(m_longTitle, work, finish))
        giveUp(said(Message("Document", "%1 is still going on: wait for it, or cancel it with Esc, then branch again.")
                        .with(m_tasks->title().toStdString())));
}

void Document::arriveAtBranch(Entry from, Branch branch)
{
    if (m_history.tree().current() != m_target) {
        endNavigation();
        return;
    }
    m_shown = m_target;
    const MomentPointer moment = branch.gesture.moment;
    const std::uint32_t resets = resetsIn(branch.gesture.commands);
    m_history.expect(Message("Document", "Branch at %1").with(timePhrase(moment->steps.time)))(
        std::move(branch.gesture));
    goInSimulation(moment);
    if (resets > 0 || moment->steps.count > m_history.tree().record(m_target).step)
        m_playback.repeat(from, moment->steps.count, resets);
}

/// What the window keeps besides the simulation becomes what it is at a moment.
void Document::follow(const Moment& moment)
{
    m_playback.dropUnderWay();
    m_fixtures.follow(*m_content, moment.fixtures);
    m_toolCount.clear();
    m_toolToSelect.clear();
    m_gesture = {.begin = moment.steps.time};
    const bool isGone = // with the filling that it was of
        (m_selection.kind == Selection::Kind::Region && m_selected->region().isEmpty()) ||
        (m_selection.kind == Selection::Kind::Body && m_selection.id >= m_content->bodies.size());
    const bool isLost = isGone ||
                        (m_selection.kind == Selection::Kind::Fixture && m_fixtures.find(m_selection.id) == nullptr) ||
                        (m_selection.kind == Selection::Kind::Tool &&
                         (m_selection.id >= moment.tools.size() || !moment.tools[m_selection.id]));
    if (isLost)
        m_selection = m_content->bodies.empty() ? Selection{} : Selection{Selection::Kind::Body, 0};
}

/// Stays where the simulation is. What was posted meanwhile, in sight of that, happens there.
void Document::giveUp(const QString& sentence)
{
    ++m_travels;
    m_requests.clear();
    m_history.goTo(m_shown);
    endNavigation();
    if (!sentence.isEmpty())
        emit notice(sentence);
}

void Document::endNavigation()
{
    m_navigation = NavigationState::none;
    if (m_history.tree().current() != m_shown) { // it was thought better of
        setOut();
        return;
    }
    followAppearance();
    emit changed(Change::Moment);
    const auto actions = std::exchange(m_afterwards, {});
    for (const auto& action : actions)
        action();
}

/// Another document, or another start: nobody waits for the navigation any more.
void Document::forgetGoing()
{
    m_playback.dropUnderWay();
    ++m_travels;
    m_navigation = NavigationState::none;
    m_isTakenBack = false;
    m_requests.clear();
    m_afterwards.clear();
}

/// @return whether the action has to wait for the end of a navigation
bool Document::later(std::function<void()> action)
{
    if (!isGoing())
        return false;
    m_afterwards.push_back(std::move(action));
    return true;
}

/// The same for what names faces or objects: it is dropped where the navigation ends at another filling.
bool Document::laterHere(std::function<void()> action)
{
    return later([this, content = m_content, action = std::move(action)] {
        if (content == m_content)
            action();
    });
}

} // namespace knead
