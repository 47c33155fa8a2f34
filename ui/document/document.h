#pragma once

#include "core/session/deformed_start.h"
#include "core/session/face_fixtures.h"
#include "core/session/frame.h"
#include "core/session/part_appearance.h"
#include "core/session/physical_deforming.h"
#include "core/session/playback_cache.h"
#include "core/session/prepared_project.h"
#include "core/session/timeline.h"
#include "core/session/tool_requests.h"
#include "core/simulation/simulation_thread.h"
#include "ui/document/document_history.h"
#include "ui/document/model_notes.h"

#include <QElapsedTimer>
#include <QObject>

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QTimer;

namespace knead {

class SelectionModel;
class TaskRunner;
struct ToolKindLook;
struct Region;

/// What panels and view point at together.
struct Selection {
    enum class Kind { None, Body, Tool, Fixture, Region };
    Kind kind = Kind::None;
    std::uint32_t id = 0; ///< BodyId, ToolId or FaceFixture::key; of a region, which SelectionModel has: 0
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// The open part with its simulation and its history: what every panel and the view show. Window thread only.
///
/// Whatever is posted is recorded. What a person did in one go, a gesture, is one entry of the history: each edit while
/// paused; from play to pause; from beginGesture() to endGesture(), as when a tool is dragged. Nothing has to be done for undo
/// but to post commands.
///
/// Saving: whenSettled([=] { write(project()); }), with history().revision() to know what is unsaved. Opening: prepareProject()
/// on a task thread, then open().
class Document final : public QObject {
    Q_OBJECT
public:
    enum class Change {
        Model,
        Filling, ///< of bodies while they are worked on: other objects, the same surfaces; a frame follows at once
        Frame,
        Selection,
        Fixtures,
        History, ///< entries, their names, what undo and redo would do
        Moment   ///< another moment of the history is shown, or the navigation there was given up
    };
    using Entry = History::Entry;

    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// Runs what takes long, with progress. @param tasks outlives the document
    void setTasks(TaskRunner* tasks);

    bool isEmpty() const { return m_content->isEmpty(); }
    const FilledModel& content() const { return *m_content; }
    /// The model that was opened, also after it was deformed: another one begins another document. None: null.
    const std::shared_ptr<const Model>& opened() const { return m_opened; }
    /// The newest frame; null before anything was opened, and without bodies and tools after it was closed.
    const FramePointer& frame() const { return m_frame; }
    const Selection& selection() const { return m_selection; }
    const FaceFixtures& fixtures() const { return m_fixtures; }

    /// Shows another content with its simulation, paused at its start: a new document, with a history of its own.
    void open(PreparedModel prepared);
    /// Shows the same model filled anew: the next entry of the history.
    void refill(PreparedModel prepared, const Message& name = {});
    /// Shows what a deformation has made of the parts, or others beside them: the next entry of the history.
    void deform(PreparedDeformation done, const Message& name);
    /// While Change::Model tells of that: where it took the surfaces that were shown. Null else.
    const CarriedSurfaces* carried() const { return m_carried; }
    /// Counts documents: another number, another document.
    std::uint64_t opening() const { return m_opening; }
    /// Shows a project at its current entry.
    /// @throws Problem when its entries do not form a tree; nothing has changed
    void open(PreparedProject prepared);

    /// Nothing is open any more; what was done is gone.
    void close();

    /// All that a project file keeps but marks, view and the panels of others. What is under way is not in it: call it from
    /// whenSettled().
    Project project() const;
    std::map<std::string, std::string> panels() const; ///< what of Project::panels is the document's
    /// Ends what is under way, and does something as soon as it is in the history: at once, or some ms later. Another document
    /// in between does away with it.
    void whenSettled(std::function<void()> action);

    void play();
    void pause();
    void togglePlay();
    bool isPlaying() const { return m_isPlaying; } ///< as asked for; a frame that shows it may be on its way
    void stepOnce();
    void reset();
    /// Puts the part where there is balance now, without inertia, with progress and to be cancelled: one entry of the history.
    /// Says in a sentence what came of it; nothing has changed when it was cancelled or there is no balance.
    void findBalance();
    /// Wanted ratio of simulated to wall time, 0.01 .. 10; 1 at first. Of the window, not of the history.
    void setSpeed(double ratio);
    double speed() const { return m_speed; }
    void keepUp(bool on); ///< see SimulationThread::keepUp()
    /// @param name for the history; empty: what the command says itself
    void post(Command command, const Message& name = {});

    // ---- The history: undo, redo, and gestures, which are its entries (document_gestures.cpp, document_going.cpp) ----

    DocumentHistory& history() { return m_history; }
    const DocumentHistory& history() const { return m_history; }

    enum class Ends { now, soon };
    /// What is posted from now on belongs together, until endGesture(). Two hands at a time do one gesture: it ends when both
    /// have ended it.
    /// @param key of gestures that are one when they follow each other within a second; empty: never
    void beginGesture(const QString& key = {});
    /// @param ends soon: within a second, unless another gesture with the same key goes on with it
    void endGesture(Ends ends = Ends::now);
    /// Ends the gesture as if it had not begun: no entry, nothing to redo. While time runs, or another hand is in it, what was
    /// done stays, and it ends as with endGesture().
    void takeBackGesture();
    /// Ends whatever is under way, be it playing (and goes on playing) or not: nothing is lost by what comes next.
    void finishGesture();
    bool isInGesture() const { return m_gesture.isHeld; }
    /// Something was done that is not in the history yet.
    bool isAnythingUnderWay() const { return m_gesture.isAny; }

    void undo();
    void redo();
    void goToEntry(Entry entry);
    std::optional<QString> undoName() const; ///< of what would be undone; nothing to undo: none
    std::optional<QString> redoName() const;
    /// Something is done that is no entry of the history yet.
    bool isUnderWay() const { return m_gesture.isAny; }

    /// What was seen while time ran.
    const PlaybackCache& film() const { return m_playback; }
    void setFilmMemory(std::size_t most) { m_playback.setMemory(most); } ///< [bytes]
    /// What of it belongs to the content that is shown; empty on the way from one filling to another.
    Timeline timeline() const;
    /// Repeats what leads to a step within an entry, with progress, and goes on from there: another branch. What is under way
    /// becomes an entry first.
    /// @param entry that the step leads to, not one that begins a start
    /// @param run in which the step is reached: after so many resets within the entry
    void branchAt(Entry entry, std::uint64_t step, std::uint32_t run = 0);
    /// Lets grips deform bodies in the background, with progress and to be cancelled: one entry of the history with what was seen
    /// meanwhile, after which they hold on, or one has let go. Says in a sentence why not; nothing has changed then.
    /// @param which per body; empty: all @param title of the task @param name of the entry
    void deformByPhysics(const PhysicalDeformation& deformation, const std::vector<bool>& which, const QString& title,
                         const Message& name);

    /// Between asking for another entry and seeing it. What is posted in the meantime happens there, or here when the navigation
    /// is given up.
    bool isGoing() const { return m_navigation != NavigationState::none || !m_requests.empty(); }

    /// Nothing is under way: the history has all that was done, and the frame shows it.
    bool isSettled() const;

    /// Looks at the gesture under way, see SimulationThread::lookAtGesture().
    void lookAtGesture(std::function<void(std::vector<RecordedCommand> commands, std::uint64_t step)> told);

    /// Follows the gesture under way, see SimulationThread::followGesture().
    /// @param told in this thread, after all gestures that ended before are entries of the history; not for another document
    void followGesture(RecordingMark known, std::function<void(const RecordingNews&)> told);

    /// Whether frames tell what presses on each object, see Simulation::showPressing().
    void showPressing(bool on);

    /// Frames come no faster than this: drawing must leave time for computing [s].
    void setDisplayInterval(double seconds);

    void select(const Selection& selection);
    /// Down to faces and objects.
    SelectionModel& selected() const { return *m_selected; }

    // ---- What is done to a region (document_regions.cpp). Each is one entry of the history, and runs as soon as it can. ----

    /// Holds faces, or the objects of anything else, in place: a fixture per body. Selects the last one.
    void fixRegion(const Region& region);
    /// Gives the objects of a region a material of their own; whole parts take it for theirs.
    /// @param name of the material, for the history
    void setMaterialOf(const Region& region, const Material& material, const Message& name);
    void renormalizeRegion(const Region& region);
    void setKindOf(const Region& region, BodyKind kind); ///< of the bodies that it is of
    /// What a selection set names, in the content of now. Says why where it cannot be told any more.
    Region regionOf(const SelectionSet& set);
    /// Keeps a region under a name, in place of the one that had it. @return whether it could
    bool keepSet(const QString& name, const Region& region);

    // ---- What a person calls and groups (document_appearance.cpp) ----

    const PartAppearance& appearance() const { return m_appearance; }
    QString nameOfPart(std::size_t part) const; ///< by index into Model::parts
    QString nameOfBody(BodyId body) const;      ///< the same; told apart where the file has it twice
    /// @param name empty: as in its file
    void renamePart(std::size_t part, const QString& name);
    void renameTool(ToolId tool, const QString& name);
    void renameFixture(std::uint32_t key, const QString& name);
    void colorPart(std::size_t part, const std::optional<Color>& color);
    ModelNotes& notes() { return *m_notes; }
    const ModelNotes& notes() const { return *m_notes; }
    /// By the keys of ModelNotes.
    bool isLocked(const Selection& selection) const;
    void setLocked(const Selection& selection, bool on);

    // ---- What is done to tools and bodies (document_tools.cpp, document_bodies.cpp, document_press.cpp) ----

    /// Removes the selected tool or fixture.
    void removeSelected();

    /// Adds a tool above the bodies and selects it once it is there.
    void addTool(const ToolKindLook& look);
    void addTool(ToolKind kind);
    /// Whether the part is as it was opened, and something can press it.
    bool canPressIt() const;
    /// Holds the part, adds the block of firstPress(), takes a floor away that would be in its way: one entry of the history; then
    /// plays.
    void pressIt();
    /// The selected body, or every one, takes its present shape for its own. Rigid bodies have nothing to lose by it.
    void renormalize();
    /// The selected body, or every one that yields, is filled anew in the shape that it has.
    void refillNow();
    /// Cuts the selected body, or all that deform, along a plane. @param normal not 0
    void cutAlong(const Vec3& point, const Vec3& normal);
    const ToolState* tool(ToolId tool) const;

    // ---- Numbers of a tool, typed one by one: each adds to what was asked before, seen already or not (document_tools.cpp) ----

    /// A tool as panels show it: with edits that are on their way to the simulation. None: there is no such tool.
    std::optional<ToolState> toolWithEdits(ToolId tool) const;
    /// Where a move by hand begins: where the tool was put last, if that is not seen yet, else where it is seen.
    /// @pre there is such a tool
    Pose poseToMoveFrom(ToolId tool) const;
    /// Puts a tool elsewhere. @param move is told where the move begins
    void moveTool(ToolId tool, std::function<Pose(const Pose&)> move);
    /// While paused the tool is put there; while time runs it goes there.
    void bringTool(ToolId tool, const Pose& pose);
    /// The same along an axis. @param axis 0, 1, 2: x, y, z
    void placeTool(ToolId tool, int axis, double coordinate);
    /// @param change of kind, size, friction and limits; the size is fitted to the kind afterwards
    void reshapeTool(ToolId tool, std::function<void(ToolState&)> change);

    /// Another number after every edit, and wherever undo, redo and another start led.
    std::uint64_t edits() const { return m_edits; }
    /// The frame shows what came of all of them.
    bool showsEdits() const { return hasSeen(m_editRequest) && !isGoing(); }
    /// So much was asked of the simulation until now; and whether the frame shows what came of it.
    std::uint64_t requests() const { return m_simulation ? m_simulation->requests() : 0; }
    bool hasSeen(std::uint64_t request) const { return m_frame->snapshot->requests >= request; }

    /// Longest side of the bodies at rest [m].
    double size() const;

    /// Fixes a face of a body, or frees it again.
    void toggleFace(BodyId body, std::uint32_t face);

    /// Parts as they are now, for a file.
    /// @param keep one per part of the model: which of them
    ExportJob exportJob(const std::vector<bool>& keep) const;

signals:
    void changed(knead::Document::Change what);
    void notice(const QString& sentence);      ///< something the person should know, for the log
    void balanced(const QString& sentence);    ///< found, and how well
    void notBalanced(const QString& sentence); ///< why not
    void appearanceChanged();                  ///< what parts are called, and their colors
    void stopping();                           ///< time is about to stand still: who drives a tool lets go of it
    void recipeEnded(const QString& sentence); ///< at its end, or where it cannot go on

private:
    struct Gesture {
        bool isAny = false;    ///< anything was done
        bool isEdited = false; ///< a command was posted since it began
        bool isHeld = false;   ///< between beginGesture() and endGesture()
        int hands = 0;         ///< that hold it
        Message name;
        QString key;
        double begin = 0; ///< simulated [s]
    };
    enum class NavigationState { none, looking, arriving };
    using Request = std::function<std::optional<Entry>(const History&)>;

    void start(Simulation simulation, std::shared_ptr<const FilledModel> content, FramePointer frame,
               std::unique_ptr<ScriptedEvents> script = nullptr);
    void showInstead(PreparedModel prepared, const Message& name, std::vector<RecipeDeformation> said);
    void keepFilm();
    void followFillings();
    void showStart();
    void retire();
    void poll();
    void accept(const FramePointer& frame, std::uint64_t generation);
    Box boxOfBodies() const; ///< as they are shown [m]
    Vec3 placeAbove(const Vec3& toolSize) const;
    Quaternion rotationOfNewTool(const Manipulator& tool) const;
    int numberOfNewTool(const ToolKindLook& look);
    void selectNewTool();
    void dropLostSelection();
    bool areFixturesKnown() const;
    bool whenFixturesAreKnown(std::function<void()> action);
    void followScript();
    void followFixtures(const Snapshot& now);
    void noticeRecipeEnd();
    void beginFixtures(const PreparedModel& prepared);
    void postAll(std::vector<Command> commands, const Message& name);
    void followAppearance();
    void followAppearance(const std::vector<RecordedCommand>& commands);
    void postLook(std::size_t part, const std::string& name, const std::optional<Color>& color, const Message& entry);
    std::optional<Selection> targetOf(const Command& command) const;
    bool refuseLocked(const Selection& target);
    bool refuseName(const QString& name, bool isTaken);
    std::string lockKeyOf(const Selection& selection) const;
    void noticeEmptyFixtures();

    class Balancing;
    void cancelBalancing();
    void tellBalance(const StaticReport& report);

    void openGesture(const QString& key);
    void noteEdit();
    void noteGesture();
    void noticeStop();

    bool later(std::function<void()> action);
    bool laterHere(std::function<void()> action);
    void request(Request request);
    void standStill();
    void takeRequests();
    void tellSettled();
    void setOut();
    HistoryNavigation navigationTo(Entry entry) const;
    void goLong(const HistoryNavigation& navigation);
    void goShort(const HistoryNavigation& navigation);
    void arrive(HistoryDestination destination);
    std::unique_ptr<ScriptedEvents> scriptAt(std::uint32_t start, const Moment& moment, std::uint64_t hash) const;
    bool canBranchAt(Entry entry) const;
    void setOutForBranch(Entry entry, std::uint64_t step, std::uint32_t run);
    void arriveAtBranch(Entry from, Branch branch);
    void setOutToDeform(const PhysicalDeformation& deformation, const std::vector<bool>& which, const QString& title,
                        const Message& name);
    void arriveDeformed(DeformedByPhysics done, const Message& name);
    void goInSimulation(MomentPointer moment);
    void follow(const Moment& moment);
    void giveUp(const QString& sentence);
    void forgetGoing();
    void endNavigation();

    TaskRunner* m_tasks = nullptr;
    std::shared_ptr<const FilledModel> m_content;
    std::uint32_t m_start = 0; ///< of the history's, that the content belongs to
    FaceFixtures m_fixtures;
    PartAppearance m_appearance;
    ModelNotes* m_notes;
    SelectionModel* m_selected;
    DocumentHistory m_history;
    PlaybackCache m_playback;
    Gesture m_gesture;
    QTimer* m_ending; ///< until a gesture that may be gone on with ends
    bool m_isPlaying = false;
    double m_speed = 1;
    bool m_keepsUp = true;
    std::uint64_t m_playRequest = 0; ///< snapshots that count as many requests have heard of it

    NavigationState m_navigation = NavigationState::none;
    Entry m_shown = 0;  ///< where the simulation is, or was when it began to do something else
    Entry m_target = 0; ///< of the navigation
    std::uint64_t m_edits = 0;
    std::uint64_t m_editRequest = 0; ///< the last of them
    std::uint64_t m_travels = 0;     ///< counts them; who comes late is dropped
    QString m_longTitle;             ///< of the task that does a long navigation
    std::uint64_t m_arrivals = 0;    ///< that frames must have seen
    std::vector<Request> m_requests;
    bool m_isTakenBack = false;                      ///< the simulation is no longer where the history is
    std::vector<std::function<void()>> m_afterwards; ///< when the navigation has ended
    std::vector<std::function<void()>> m_whenSettled;

    ToolRequests m_toolRequests;
    std::map<std::string, int> m_toolCount; ///< added so far, for their names
    std::string m_toolToSelect;             ///< posted, not yet in a snapshot
    Selection m_selection;
    QString m_refused; ///< what was locked; said once in a while
    QElapsedTimer m_sinceRefusal;
    bool m_hasScript = false;                       ///< the simulation does more than what is posted
    std::uint64_t m_scriptEnds = 0;                 ///< that were told
    std::uint64_t m_fixtureRequest = 0;             ///< the last one of a fixture
    std::vector<std::function<void()>> m_whenKnown; ///< when a frame has seen that
    std::shared_ptr<Balancing> m_balancing;         ///< the last one
    bool m_showsPressing = false;
    std::uint64_t m_generation = 0; ///< of the content; frames of an earlier one are dropped
    SnapshotPointer m_seen;
    FramePointer m_frame;
    QTimer* m_timer;
    std::unique_ptr<SimulationThread> m_simulation; // gone before the history, which it tells of gestures
    std::unique_ptr<FramePreparer> m_preparer;
    std::vector<std::future<void>> m_retiring; ///< earlier simulations on their way out
    std::uint64_t m_opening = 0;               ///< see opening()
    const CarriedSurfaces* m_carried = nullptr;
    std::shared_ptr<const Model> m_opened; ///< that the document was opened with; later starts may have another
};

} // namespace knead
