#pragma once

#include "ui/frame/workbench.h"
#include "ui/measuring/marks_overlay.h"
#include "ui/measuring/measurement_list.h"
#include "ui/measuring/pick_tool.h"

#include <QList>
#include <QObject>
#include <QPointer>

class QAction;
class QMenu;
class QTimer;

namespace knead {

class MeasurePanel;
class Modes;
class SideView;

/// Measuring in a document: what one clicks, what is listed and what the view shows of it belong together here.
/// Nothing of it changes the document. Window thread only.
class Measuring final : public QObject {
    Q_OBJECT
public:
    Measuring(const Workbench& bench, Modes& modes);
    ~Measuring() override;

    MeasurementList& list() { return *m_list; }
    PickTool& tool() { return *m_tool; }
    MeasurePanel& panel() { return *m_panel; } ///< belongs to whoever puts it into a layout
    MarksOverlay& overlay() { return *m_overlay; }
    QAction* action(MeasureKind kind) const;
    void fillMenu(QMenu* menu) const;

    /// An action with which something else is picked, a mode as well. It goes with those that measure.
    void addPickAction(QAction* action, std::vector<PickWhat> picks, PickTool::Done done);

    /// Another view of the scene: what is being picked is shown there, too. @param side is deleted whenever it wants
    void addView(SideView& side);

    /// Marks of others, painted with those of what was measured.
    void setOtherMarks(std::vector<OverlayMark> marks);

    /// What was measured as a table in HTML; empty: nothing.
    QString html() const;

signals:
    void refused(const QString& sentence);
    void promptChanged();

private:
    void makeActions(QWidget& window);
    void soon();
    void refresh();
    void showMarks();
    bool isSeen(const Measurement& measurement) const;
    OverlayMark markInTheMaking() const;

    Document& m_document;
    ViewportWidget& m_view;
    Availability& m_availability;
    Modes& m_modes;
    MeasurementList* m_list;
    PickTool* m_tool;
    MarksOverlay* m_overlay;
    MeasurePanel* m_panel;
    QList<QAction*> m_actions;    ///< in the order of MeasureKind
    QAction* m_picking = nullptr; ///< that the tool works for, or did last
    QTimer* m_soon;               ///< many changes are shown at once
    FramePointer m_frame;
    std::vector<OverlayMark> m_others;
    std::vector<QPointer<MarksOverlay>> m_sides; ///< of the views beside the active one
};

} // namespace knead
