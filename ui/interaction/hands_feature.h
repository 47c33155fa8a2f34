#pragma once

#include "ui/frame/workbench.h"

#include <QObject>

class QMenu;

namespace knead {

class Hands;
class Modes;

/// Tools and material by hand, the forces that come of it, and the folds: their panels, and the table of forces as a file. Window
/// thread only.
class HandsFeature final : public QObject {
    Q_OBJECT
public:
    HandsFeature(const Workbench& bench, Modes& modes);

    Hands& hands() { return *m_hands; }

    /// Writes the forces over time as a table in the background.
    void exportForces(const QString& path);

private:
    void askForForces();

    Workbench m_bench;
    Hands* m_hands;
};

} // namespace knead
