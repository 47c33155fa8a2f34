#pragma once

#include "ui/viewport/side_view.h"
#include "ui/viewport/view_cells.h"

#include <QTimer>

#include <array>
#include <memory>

namespace knead {

class ViewName;

/// One, two or four views of a document. The active one is always the ViewportWidget, with all that mouse and keys do in it; the
/// others are side views. When another view becomes the active one, the ViewportWidget takes its place and camera.
///
/// Side views draw one after the other between events, so that mouse and keys never wait for all of them. Window thread.
class ViewGrid final : public QWidget {
    Q_OBJECT
public:
    explicit ViewGrid(Document& document, QWidget* parent = nullptr);
    ~ViewGrid() override;

    ViewportWidget& active() { return *m_view; }
    ViewSlot activeSlot() const { return m_active; }
    SideView* sideView(ViewSlot slot)
    {
        return m_sides[indexOf(slot)];
    } ///< null: it is the active one, or is not shown
    ViewName& name(ViewSlot slot) { return *m_names[indexOf(slot)]; }
    Camera camera(ViewSlot slot) const;
    QRect cell(ViewSlot slot) const; ///< where a view that is shown lies

    ViewArrangement arrangement() const { return m_cells.arrangement; }
    /// The active view stays the active one; where there is one only, it is that.
    void arrange(ViewArrangement arrangement);
    /// The active view alone for a while, or all of the arrangement again.
    void setAlone(bool alone);
    bool isAlone() const { return m_isAlone; }
    bool areSeveral() const { return arrangement() != ViewArrangement::one; }
    void activate(ViewSlot slot);
    void activateNext(); ///< in reading order

    /// Linked views have the same middle and the same scale: what is panned or zoomed in one is in all. Turning stays its own.
    void setLinked(bool linked);
    bool areLinked() const { return m_areLinked; }

    /// @param samples of a pixel: 1 draws jagged edges
    void setSamples(int samples);

    /// As it was when the program ended; from then on changes are remembered.
    void restore();

signals:
    void changed();   ///< arrangement, alone, linked
    void activated(); ///< another view is the active one
    void sideAdded(knead::SideView& side);

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    static constexpr std::size_t indexOf(ViewSlot slot) { return static_cast<std::size_t>(slot); }

    bool isSingle() const { return !areSeveral() || m_isAlone; }
    enum class Cameras { keepWhole, keep }; ///< those that show all of the part go on to do so
    void layOut(Cameras cameras = Cameras::keepWhole);
    void showNames();
    void makeSides();
    SideView* newSide(ViewSlot slot);
    void contentChanged();
    void fitNew();
    QSize sizeOf(ViewSlot slot) const; ///< of the widget, as it is
    QSize sizeToBe(ViewSlot slot) const;
    Camera cameraToBe(ViewSlot slot) const;
    Camera fitted(ViewSlot slot, const Camera& camera, const QSize& size) const;
    std::vector<ViewSlot> fittedOnes() const;
    void fit(const std::vector<ViewSlot>& wholes);
    void setCamera(ViewSlot slot, const Camera& camera);
    void linkTo(ViewSlot slot);
    void drawStale();
    void remember() const;

    Document& m_document;
    ViewportWidget* m_view;
    ViewCells m_cells;
    ViewSlot m_active = ViewSlot::free;
    bool m_isAlone = false;
    bool m_areLinked = false;
    bool m_isLinking = false; ///< cameras that follow lead nowhere
    bool m_remembers = false;
    int m_samples = 4;
    std::array<SideView*, viewSlots> m_sides{};
    std::array<ViewName*, viewSlots> m_names{};
    std::array<Camera, viewSlots> m_cameras; ///< of views that are not shown
    std::array<bool, viewSlots> m_areFitted{};
    std::shared_ptr<const Model> m_opened; ///< see Document::opened()
    Box m_box;                             ///< of the content that was fitted to [m]
    ViewCells::Lines m_dragged;
    QTimer m_turn; ///< of side views to draw
    std::size_t m_lastDrawn = 0;
};

} // namespace knead
