#pragma once

#include <QList>
#include <QToolBar>

class QToolButton;

namespace knead {

/// A tool bar whose buttons have texts beside their icons as far as there is room, so that none falls off in a narrow window or
/// a language of long words.
class FittingToolBar final : public QToolBar {
public:
    using QToolBar::QToolBar;

    /// Those that may have texts. @param actions of the bar; the first ones keep their texts longest
    void setTexts(const QList<QAction*>& actions);

protected:
    bool event(QEvent* event) override;

private:
    void fit();
    QToolButton* buttonOf(QAction* action) const;

    QList<QAction*> m_texts;
};

} // namespace knead
