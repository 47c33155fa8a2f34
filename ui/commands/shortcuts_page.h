#pragma once

#include <QKeySequence>
#include <QWidget>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QMainWindow;
class QPushButton;
class QTreeWidget;

namespace knead {

class Shortcuts;

/// All actions by their menus with their keys, to be given others. A key that another action has is named with that action, and
/// taken from it only when the person says so.
class ShortcutsPage final : public QWidget {
    Q_OBJECT
public:
    ShortcutsPage(QMainWindow& window, Shortcuts& shortcuts, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void makeList();
    void makeEditor();
    void fill();
    void filter(const QString& wanted);
    void showKeys(const QAction* action);
    QAction* current() const;
    void choose();
    void typed();
    void take();
    void give(const QKeySequence& key);

    QMainWindow& m_window;
    Shortcuts& m_shortcuts;
    QLineEdit* m_search;
    QTreeWidget* m_list;
    QKeySequenceEdit* m_key;
    QLabel* m_conflict;
    QPushButton* m_take;
    QPushButton* m_clear;
    QPushButton* m_reset;
};

} // namespace knead
