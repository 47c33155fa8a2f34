#pragma once

#include <QList>
#include <QToolBar>

#include <functional>
#include <map>

class QToolButton;

namespace knead {

/// A tool bar whose buttons have texts beside their icons as far as there is room, so that none falls off in a narrow window or
/// a language of long words. Tab leads to its buttons, and Enter presses them.
class FittingToolBar final : public QToolBar {
public:
    using QToolBar::QToolBar;

    /// Those that may have texts. @param actions of the bar; the first ones keep their texts longest
    void setTexts(const QList<QAction*>& actions);
    /// Texts that a button has by turns: it is as wide as the widest of them, so that its neighbors stay where they are.
    /// @param texts in the language that is spoken
    void setTurns(QAction* action, std::function<QStringList()> texts);

protected:
    bool event(QEvent* event) override;
    void actionEvent(QActionEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fit();
    QToolButton* buttonOf(QAction* action) const;
    int roomForText(QAction* action) const;

    QList<QAction*> m_texts;
    std::map<QAction*, std::function<QStringList()>> m_turns;
};

} // namespace knead
