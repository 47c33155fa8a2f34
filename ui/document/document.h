#pragma once

#include "core/simulation/simulation_thread.h"
#include "ui/document/face_fixtures.h"
#include "ui/document/frame.h"

#include <QObject>

#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QTimer;

namespace knead {

/// What panels and view point at together.
struct Selection {
    enum class Kind { None, Body, Tool, Fixture };
    Kind kind = Kind::None;
    std::uint32_t id = 0; ///< BodyId, ToolId or FaceFixture::key
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// The open part with its simulation: what every panel and the view show. Window thread only.
class Document final : public QObject {
    Q_OBJECT
public:
    enum class Change { Content, Frame, Selection, Fixtures };

    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    bool isEmpty() const { return m_content.isEmpty(); }
    const Content& content() const { return m_content; }
    /// The newest frame; null while empty.
    const FramePointer& frame() const { return m_frame; }
    const Selection& selection() const { return m_selection; }
    const FaceFixtures& fixtures() const { return m_fixtures; }

    /// Shows another content with its simulation, paused at its start.
    void open(PreparedContent prepared);
    /// Shows the same model filled anew. Fixtures stay on their faces.
    void refill(PreparedContent prepared);

    void play();
    void pause();
    void togglePlay();
    void stepOnce();
    void reset();
    void post(Command command);

    /// Frames come no faster than this: drawing must leave time for computing [s].
    void setDisplayInterval(double seconds);

    void select(const Selection& selection);
    /// Removes the selected tool or fixture.
    void removeSelected();

    /// Adds a tool above the bodies and selects it once it is there.
    void addTool(ToolKind kind);
    /// The selected body, or every one, takes its present shape for its own. Rigid bodies have nothing to lose by it.
    void renormalize();
    const ToolState* tool(ToolId tool) const;
    /// Longest side of the bodies at rest [m].
    double size() const;

    /// Fixes a face of a body, or frees it again.
    void toggleFace(BodyId body, std::uint32_t face);

    /// Parts as they are now, for a file.
    /// @param keep one per part of the model: which of them
    ExportJob exportJob(const std::vector<bool>& keep) const;

signals:
    void changed(knead::Document::Change what);
    void notice(const QString& sentence); ///< something the person should know, for the log

private:
    void start(PreparedContent prepared);
    void retire();
    void poll();
    void accept(const FramePointer& frame, std::uint64_t generation);
    Vec3 placeAbove(const Vec3& toolSize) const;
    void selectNewTool();
    void dropLostSelection();
    void postFixtures();
    void noticeEmptyFixtures();

    Content m_content;
    FaceFixtures m_fixtures;
    std::map<ToolKind, int> m_toolCount; ///< added so far, for their names
    std::string m_toolToSelect;          ///< posted, not yet in a snapshot
    Selection m_selection;
    std::uint64_t m_generation = 0; ///< of the content; frames of an earlier one are dropped
    SnapshotPointer m_seen;
    FramePointer m_frame;
    QTimer* m_timer;
    std::unique_ptr<SimulationThread> m_simulation;
    std::unique_ptr<FramePreparer> m_preparer;
    std::vector<std::future<void>> m_retiring; ///< earlier simulations on their way out
};

} // namespace knead
