#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QAction;
class QComboBox;
class QTimer;

namespace knead {

class ForcePlot;

/// The forces on tools and fixtures along the timeline, live while time runs.
class ForcePanel final : public QWidget {
    Q_OBJECT
public:
    /// @param exportTable asks for a file; its button stands beside the plot
    ForcePanel(Document& document, QAction* exportTable, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void documentChanged(Document::Change what);
    void bringUpToDate();

    Document& m_document;
    ForcePlot* m_plot;
    QComboBox* m_component;
    QTimer* m_soon;
};

} // namespace knead
