#pragma once

#include <QObject>

class QAction;
class QActionGroup;

namespace knead {

/// What the left mouse button does in a view instead of selecting, each switched by an action: fixing faces, pulling, measuring,
/// placing probes. At most one is on: switching one on leaves the other first. Window thread only.
class Modes final : public QObject {
    Q_OBJECT
public:
    explicit Modes(QObject* parent = nullptr);

    /// @param mode a checkable action
    void add(QAction* mode);
    QAction* current() const; ///< null: the button selects
    /// Leaves the one that is on. @return whether there was one
    bool leave();

signals:
    void changed();

private:
    QActionGroup* m_group;
};

} // namespace knead
