#pragma once

#include "core/session/timeline.h"

#include <QWidget>

#include <functional>
#include <optional>

namespace knead {

/// Simulated time from left to right: entries as ticks, key moments as stars, what was filmed as a band, small ticks below it where
/// bodies were filled anew, and where one is. A
/// click or a drag looks there; what that means is up to the panel.
class TimelineAxis final : public QWidget {
    Q_OBJECT
public:
    explicit TimelineAxis(std::function<QString(History::Entry)> nameOf, QWidget* parent = nullptr);

    void show(Timeline timeline);
    /// Where a person looks; none: at the present.
    void lookAt(std::optional<double> at);
    /// Whether time was simulated of which nothing can be looked at: projects keep entries, and no film.
    bool lacksFilm() const { return m_timeline.end > 0 && m_timeline.pictures.empty(); }
    std::optional<double> lookedAt() const { return m_looking; }
    const Timeline& timeline() const { return m_timeline; }

    QPoint placeOf(double at) const; ///< in this widget; for tests too
    QSize sizeHint() const override;

signals:
    void grabbed();          ///< the button went down
    void dragged(double at); ///< [s]
    void released(double at);
    void doubleClicked(double at);
    void stepped(int pictures); ///< by the keyboard

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    double atPlace(double x) const;
    double shownLength() const;
    double reach() const; ///< how near to a tick counts as on it [s]
    void paintRuler(QPainter& painter) const;
    void paintFilm(QPainter& painter) const;
    void paintFillings(QPainter& painter) const;
    void paintTicks(QPainter& painter) const;
    void paintHeads(QPainter& painter) const;
    QString textAt(double at) const;
    QString spokenPlace() const;
    static bool isOwnKey(const QKeyEvent& event);

    std::function<QString(History::Entry)> m_nameOf;
    Timeline m_timeline;
    std::optional<double> m_looking;
};

} // namespace knead
