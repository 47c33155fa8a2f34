#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <QToolButton>

class QWidget;

namespace knead {

/// Lets the keyboard reach the buttons of a strip: Tab leads to the strip as to one thing, arrows from button to button,
/// and Enter presses. Space goes on meaning the simulation. Belongs to the strip.
class StripKeys final : public QObject {
    Q_OBJECT
public:
    /// Buttons that are added later are reached as well.
    explicit StripKeys(QWidget& strip);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take(QToolButton& button);
    void chooseStop();
    void makeStop(QToolButton& button);
    void move(const QToolButton& from, int by);
    QList<QToolButton*> buttons() const;

    QWidget& m_strip;
    QPointer<QToolButton> m_stop; ///< at which Tab stops
};

} // namespace knead
