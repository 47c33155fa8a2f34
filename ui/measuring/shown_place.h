#pragma once

#include "core/session/frame.h"
#include "ui/measuring/marks_overlay.h"
#include "ui/panels/place_rows.h"

#include <QObject>

namespace knead {

class Document;
class ViewportWidget;

/// Brings a person to what a row of a report is about: the view flies there, to the side from which it is seen, and outlines it in
/// front of everything. A part is selected as well. The outline goes with the next press in the view, when what is shown
/// becomes another shape, and when another one is opened. Window thread.
class ShownPlace final : public QObject {
    Q_OBJECT
public:
    ShownPlace(Document& document, ViewportWidget& view);

    /// Nothing happens where there is no such part any more.
    void show(const ReportPlace& place);
    MarksOverlay& overlay() { return *m_overlay; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void selectPart(std::size_t part);
    void hide();

    Document& m_document;
    ViewportWidget& m_view;
    MarksOverlay* m_overlay;
    FramePointer m_frame; ///< in which the place is outlined
};

/// Where a place is in a frame of a content [m]; empty: nowhere.
Box boxOf(const ReportPlace& place, const FilledModel& content, const Frame& frame);

/// What the view is to show around a place, so that one sees where it is: at least a fifth of all that there is, each way [m].
Box withSurroundings(const Box& place, const Box& all);

} // namespace knead
