#pragma once

#include "ui/frame/workbench.h"
#include "ui/help/tour.h"

#include <vector>

class QAction;
class QToolBar;
class QWidget;

namespace knead {

class Hands;

/// What the steps of the tour point at, and by what they know what was done. All outlive the steps.
struct TourSources {
    Workbench bench;
    const Hands& hands;
    const QAction& exporting;
    const QToolBar& toolBar;
    const QToolBar& brushes;
    const QWidget& banner;
};

/// The tour on a block of clay: press it, pull it, export it.
std::vector<Tour::Step> claySteps(const TourSources& sources);

} // namespace knead
