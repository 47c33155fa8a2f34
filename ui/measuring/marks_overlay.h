#pragma once

#include "core/session/measurement.h"

#include <QColor>
#include <QString>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QPainter;

namespace knead {

class ViewportBridge;

/// A mark in the view, and how it is painted.
struct OverlayMark {
    Mark mark;
    QString text = {};     ///< at its label
    bool isStrong = false; ///< selected, or being made
    QColor color = {};     ///< invalid: that of the theme
};

/// Lines and numbers painted over the view, sharp at any scale. They are always in front: what is measured may lie inside.
/// Lets all mouse events through.
class MarksOverlay final : public QWidget {
    Q_OBJECT
public:
    /// Where a place is seen in the view; nothing: behind the eye.
    using SeenAt = std::function<std::optional<QPointF>(const Vec3& place)>;
    MarksOverlay(ViewportBridge& view, SeenAt seenAt);

    void show(std::vector<OverlayMark> marks);
    const std::vector<OverlayMark>& marks() const { return m_marks; }
    /// A sentence at the top; empty: none.
    void setPrompt(const QString& prompt);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void paintMark(QPainter& painter, const OverlayMark& mark) const;
    void paintText(QPainter& painter, const OverlayMark& mark, std::vector<QRectF>& taken) const;
    void paintPrompt(QPainter& painter) const;
    QColor colorOf(const OverlayMark& mark) const;

    ViewportBridge& m_view;
    SeenAt m_seenAt;
    std::vector<OverlayMark> m_marks;
    QString m_prompt;
};

} // namespace knead
