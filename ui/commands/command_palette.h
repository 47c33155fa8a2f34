#pragma once

#include "ui/commands/listed_actions.h"

#include <QFrame>
#include <QPointer>

#include <vector>

class QLineEdit;
class QListWidget;

namespace knead {

/// Finds any action by a few of its letters, or by what else it is called, and does it: a field with a list below, over the
/// top of the window. Arrows choose, Enter does it, Esc or a click elsewhere closes. Actions that are off now are shown grey with
/// the reason, and stay off.
class CommandPalette final : public QFrame {
    Q_OBJECT
public:
    explicit CommandPalette(QMainWindow& window);

    /// Opens over the window with all actions, those done last first.
    void open();

    /// What is listed now, best first.
    std::vector<ListedAction> shown() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void list(const QString& wanted);
    void addRow(const ListedAction& one, const QList<qsizetype>& hits, const QString& synonym);
    void place();
    void step(int rows);
    void doCurrent();
    void leave();

    QMainWindow& m_window;
    QLineEdit* m_field;
    QListWidget* m_list;
    std::vector<ListedAction> m_actions;
    std::vector<ListedAction> m_shown;
    QStringList m_lastDone; ///< names of actions, the latest first
    QPointer<QWidget> m_focusBefore;
};

} // namespace knead
