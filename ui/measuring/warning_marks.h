#pragma once

#include "ui/measuring/marks_overlay.h"

#include <QObject>
#include <QPointer>

#include <vector>

namespace knead {

class SideView;
class ViewGrid;
class ViewportWidget;
class WarningWatch;

/// Shows in all views what a person should look at: a point with a few words at each place, in front of everything. Nothing is
/// shown of what is fine, of hidden parts, of the past, or when it is switched off. Window thread.
class WarningMarks final : public QObject {
    Q_OBJECT
public:
    /// @param watch outlives the marks
    WarningMarks(const WarningWatch& watch, ViewGrid& views);

    MarksOverlay& overlay() { return *m_overlay; } ///< of the active view

private:
    void addView(SideView& side);
    void showMarks();

    const WarningWatch& m_watch;
    ViewportWidget& m_view;
    MarksOverlay* m_overlay;
    std::vector<QPointer<MarksOverlay>> m_sides; ///< of the views beside the active one
};

} // namespace knead
