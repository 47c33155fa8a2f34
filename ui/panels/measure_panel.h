#pragma once

#include "ui/measuring/measurement_list.h"
#include "ui/panels/place_rows.h"

#include <QWidget>

class QAction;
class QLabel;
class QTreeWidget;
class QToolButton;

namespace knead {

/// What was measured, in numbers: now, at rest and the change. Its rows follow the skin while time runs.
class MeasurePanel final : public QWidget {
    Q_OBJECT
public:
    /// @param actions with which one measures, for buttons
    MeasurePanel(MeasurementList& list, const QList<QAction*>& actions, QWidget* parent = nullptr);

    /// @param results one per measurement
    void show(const std::vector<Measured>& results);
    /// Indices of the measurements whose rows are selected.
    std::vector<std::size_t> selected() const;
    const std::vector<Measured>& results() const { return m_results; }

signals:
    void selectionChanged();
    void csvWanted();
    void comparisonWanted();
    void placeWanted(const knead::ReportPlace& place); ///< of a row

private:
    void makeButtons(const QList<QAction*>& actions);
    QToolButton* makeButton(const char* name, const char* picture, const QString& text, const QString& tip);
    void makeTree();
    void makeRows();
    void showNames();
    void showNumbers();
    void copy();
    void removeSelected();
    void showState();

    MeasurementList& m_list;
    std::vector<Measured> m_results;
    std::vector<std::size_t> m_shape; ///< numbers of readings that the rows were made for
    QTreeWidget* m_tree;
    PlaceRows* m_places = nullptr;
    QLabel* m_hint;
    QToolButton* m_copy = nullptr;
    QToolButton* m_csv = nullptr;
    QToolButton* m_delete = nullptr;
};

} // namespace knead
