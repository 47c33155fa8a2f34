#pragma once

#include "ui/document/document.h"

#include <QToolButton>

class QAction;

namespace knead {

/// Lies over the view of a newly opened part and offers to press it. It is gone as soon as a person does anything to the part.
class PressButton final : public QToolButton {
    Q_OBJECT
public:
    /// @param action that it does, and that it enables with itself
    PressButton(Document& document, QAction* action, QWidget* view);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void follow(Document::Change what);
    void place();

    Document& m_document;
};

} // namespace knead
