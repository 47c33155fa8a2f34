#pragma once

#include "core/session/timeline.h"
#include "core/task/ordered_worker.h"
#include "ui/document/document.h"

#include <QWidget>

#include <optional>

class QAction;
class QComboBox;
class QElapsedTimer;
class QLabel;
class QMenu;
class QTimer;
class QToolButton;

namespace knead {

class TimelineAxis;

/// What was simulated, to be looked at again: drag along it, play it at any rate, go to an entry, or branch from any moment.
/// Looking back changes nothing but the view; a double click on an entry goes to it. What its buttons do are its
/// actions().
class TimelinePanel final : public QWidget {
    Q_OBJECT
public:
    explicit TimelinePanel(Document& document, QWidget* parent = nullptr);
    ~TimelinePanel() override;

    bool isLookingBack() const { return m_looking.has_value(); }
    const TimelineAxis& axis() const { return *m_axis; }

    /// Puts a button for an action at the end: to record.
    void addButton(QAction* action);

    /// The choice of how fast it is played as a menu. @param window that owns it
    QMenu* newRateMenu(QWidget* window) const;

    /// Back to the present.
    void stopLooking();

signals:
    /// The view shall show a frame of the past; null: the present again.
    void looked(knead::FramePointer frame, const QString& caption);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void makeButtons();
    int stateWidth() const;
    QToolButton* makeButton(const char* name, const char* picture, const QString& text, const QString& tip);
    void documentChanged(Document::Change what);
    void bringUpToDate();
    void lookAt(double at);
    void draw();
    void drawn(const PlaybackFramePointer& frame, std::uint64_t look, const FramePointer& picture,
               const QString& caption);
    PlaybackFramePointer frameFor(double at) const;
    bool isPresent(double at) const;
    void release(double at);
    void goThere(double at);
    void stepBy(int pictures);
    void togglePlay();
    void playOn();
    void branchHere();
    void showState();

    Document& m_document;
    TimelineAxis* m_axis;
    QToolButton* m_toStart = nullptr;
    QToolButton* m_back = nullptr;
    QToolButton* m_play = nullptr;
    QToolButton* m_on = nullptr;
    QToolButton* m_toEnd = nullptr;
    QComboBox* m_rate = nullptr;
    QLabel* m_state = nullptr;
    QToolButton* m_branch = nullptr;
    QToolButton* m_return = nullptr;
    QTimer* m_soon;   ///< many changes are shown at once
    QTimer* m_player; ///< while the film is played
    std::unique_ptr<QElapsedTimer> m_clock;
    std::optional<double> m_looking; ///< [s] of the timeline
    PlaybackFramePointer m_seen;     ///< what the view shows, or will
    std::uint64_t m_look = 0;        ///< goes up when one returns; pictures from before are dropped
    bool m_isDrawing = false;
    OrderedWorker m_drawing; // last: it ends first
};

} // namespace knead
