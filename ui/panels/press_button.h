#pragma once

#include <QToolButton>

class QAction;

namespace knead {

/// Lies over the view of a newly opened part and offers to press it. It is gone as soon as a person does anything to the part.
class PressButton final : public QToolButton {
    Q_OBJECT
public:
    /// @param action that it does; it is there as long as that can be done
    PressButton(QAction* action, QWidget* view);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void follow();
    void place();
};

} // namespace knead
