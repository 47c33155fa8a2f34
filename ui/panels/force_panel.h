#pragma once

#include "ui/document/document.h"
#include "ui/document/force_record.h"

#include <QWidget>

class QAction;
class QComboBox;
class QTimer;

namespace knead {

class PlotView;

/// The forces on tools and fixtures along the timeline, live while time runs: a line for each tool, dashed for fixtures.
class ForcePanel final : public QWidget {
    Q_OBJECT
public:
    /// @param exportTable asks for a file; its button stands beside the plot
    /// @param withStrokes is on when fingers and grips of brushes are plotted, too; its box stands there as well
    ForcePanel(Document& document, QAction* exportTable, QAction* withStrokes, QWidget* parent = nullptr);

    const ForceRecord& record() const { return m_record; }

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void documentChanged(Document::Change what);
    void bringUpToDate();
    void plot(ForceRecord record);

    Document& m_document;
    QAction* m_withStrokes;
    PlotView* m_plot;
    ForceRecord m_record; ///< that is plotted
    QComboBox* m_component;
    QTimer* m_soon;
};

} // namespace knead
