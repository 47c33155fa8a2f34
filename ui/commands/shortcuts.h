#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>

#include <map>

class QAction;
class QMainWindow;

namespace knead {

/// The keys of a window's actions: as they come, and as the person wants them, which the settings keep under the action's name.
/// Their tool tips say the keys. Window thread.
class Shortcuts final : public QObject {
    Q_OBJECT
public:
    /// Takes what all actions of the window have now for usual, and gives them what the settings say.
    explicit Shortcuts(QMainWindow& window);

    QList<QKeySequence> usual(const QAction* action) const;
    /// Whether a person can give it other keys: it has a name under which they are kept.
    bool knows(const QAction* action) const { return m_usual.contains(action); }

    void set(QAction* action, const QList<QKeySequence>& keys);
    void reset(QAction* action) { set(action, usual(action)); }
    void resetAll();

    /// Who has the key already; null: nobody. What both may have is no conflict: keys of an action itself.
    QAction* holder(const QKeySequence& key, const QAction* except) const;
    /// What a key does that is no action's: "drives the selected tool"; empty: nothing.
    static QString takenFor(const QKeySequence& key);

signals:
    void changed(QAction* action);

private:
    void follow(QAction* action);
    static void showKeys(QAction* action);

    QMainWindow& m_window;
    std::map<const QAction*, QList<QKeySequence>> m_usual;
};

} // namespace knead
