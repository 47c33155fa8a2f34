#pragma once

#include <QFrame>
#include <QList>
#include <QPointer>
#include <QRect>
#include <QString>

#include <functional>
#include <vector>

class QLabel;
class QMainWindow;
class QPushButton;
class QTimer;

namespace knead {

/// A tour in which things are done, not read: a card says what to do, a ring shows where, and what was done is noticed by itself, by
/// whatever way it was done. The window works as always meanwhile: the ring lets the mouse through, and the card stays beside
/// what is to be clicked. Window thread only.
class Tour final : public QFrame {
    Q_OBJECT
public:
    struct Step {
        std::function<QString()> title; ///< in the language of now
        std::function<QString()> text;
        std::function<QRect()> place;            ///< that is shown, in the window's coordinates; empty: none
        std::function<QList<QRect>()> uncovered; ///< what else the card must not lie over, in the same
        std::function<void()> begin;             ///< whenever the step begins; null: nothing
        std::function<bool()> isDone; ///< asked again and again, until it says so; null: there is nothing to do
    };

    /// @param beside of the window: Tab leads from it to the card
    Tour(QMainWindow& window, std::vector<Step> steps, QWidget& beside);
    ~Tour() override;

    void begin();
    int step() const { return m_step; } ///< from 0
    /// What the ring is around, in the window's coordinates; empty: nothing.
    QRect spot() const;
    /// Looks whether what is to be done was done, and where it lies now. It does so by itself, some times a second.
    void look();

signals:
    void ended();

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    class Ring;

    void makeCard(QWidget& beside);
    void go(int step);
    void say();
    void arrange(bool isNew);
    QPoint cornerBeside(const QRect& place) const;
    qint64 covered(const QRect& card) const;
    const Step& now() const { return m_steps[static_cast<std::size_t>(m_step)]; }

    QMainWindow& m_window;
    std::vector<Step> m_steps;
    int m_step = 0;
    bool m_isDone = false; ///< what the step asks for
    QPointer<QWidget> m_ring;
    QTimer* m_looking;
    QTimer* m_goingOn; ///< a moment after it was done
    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_count;
    QPushButton* m_back;
    QPushButton* m_skip;
    QPushButton* m_end;
};

} // namespace knead
