#pragma once

#include <QPointer>
#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QMainWindow;
class QPushButton;

namespace knead {

struct Workbench;

/// A minute's tour of the window: darkens it but for the place that is spoken of, with a card beside that. Enter and the arrow
/// keys go on and back, Esc or a button ends it.
class Tour final : public QWidget {
    Q_OBJECT
public:
    struct Step {
        QString title;
        QString text;
        std::function<QWidget*()> place; ///< that is spoken of; null: the middle of the window
    };

    Tour(QMainWindow& window, std::vector<Step> steps);

    void begin();
    int step() const { return m_step; } ///< from 0
    /// What is left bright, in the window's coordinates.
    QRect spot() const;

signals:
    void ended();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeCard();
    void go(int step);
    void arrange();

    QMainWindow& m_window;
    std::vector<Step> m_steps;
    int m_step = 0;
    QPointer<QWidget> m_place;
    QPointer<QWidget> m_focusBefore;
    QWidget* m_card;
    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_count;
    QPushButton* m_back;
    QPushButton* m_next;
};

/// The steps through Knead's main window, in the language spoken now.
std::vector<Tour::Step> windowTour(const Workbench& bench, QWidget& toolBar);

} // namespace knead
