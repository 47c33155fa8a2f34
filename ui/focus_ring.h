#pragma once

#include <QWidget>

namespace knead {

/// A frame along the edges of a widget that has none of its own, for as long as it has the keyboard because Tab led to it.
/// A click shows none: the eye is there already. Belongs to the widget.
class FocusRing final : public QWidget {
    Q_OBJECT
public:
    explicit FocusRing(QWidget& around);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget& m_around;
};

} // namespace knead
