#pragma once

#include "ui/frame/workbench.h"
#include "ui/panels/place_rows.h"

#include <QObject>

class QMenu;

namespace knead {

class Measuring;
class Modes;

/// Distances, angles and radii: their panel, and the table of them as a file. Window thread only.
class MeasuringFeature final : public QObject {
    Q_OBJECT
public:
    MeasuringFeature(const Workbench& bench, Modes& modes);

    Measuring& measuring() { return *m_measuring; }
    QMenu* menu() const { return m_menu; } ///< for the menu bar and a button

    /// Writes what was measured as a table in the background.
    void write(const QString& path);

signals:
    void placeWanted(const knead::ReportPlace& place); ///< of a row

private:
    void forgetRefusals();
    void askForFile();

    Workbench m_bench;
    Measuring* m_measuring;
    QMenu* m_menu;
};

} // namespace knead
