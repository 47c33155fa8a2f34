#pragma once

#include <QDialog>
#include <QKeyEvent>

namespace knead {

/// A dialog beside which the window goes on. Esc closes it, whatever it means to the window behind.
class ModelessDialog : public QDialog {
public:
    using QDialog::QDialog;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            event->accept(); // a key of this dialog, not a shortcut of the window
            return true;
        }
        return QDialog::event(event);
    }
};

} // namespace knead
