#pragma once

#include "support/window_on_test.h"

#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QTimer>

namespace knead {

/// Types a path into the next dialog that asks for a file, and presses Enter, with real key events. Made before the dialog is
/// asked for, since the dialog may have a loop of its own; looks after itself. Whatever else comes up, and a dialog that does
/// not take the name in time, fails the test in words and is closed: nothing waits for ever.
class FileDialogAnswer final : public QObject {
public:
    FileDialogAnswer(QString path, QObject* parent)
        : QObject(parent)
        , m_path(std::move(path))
    {
        m_sinceBegin.start();
        again();
    }

private:
    static constexpr int interval = 20;      // [ms]
    static constexpr int mostTries = 5;      // to type the name
    static constexpr int enterAgain = 5'000; // [ms]

    /// Asked for before anything is done: what is done may be in a loop of its own until the dialog is gone.
    void again()
    {
        QTimer::singleShot(interval, this, [this] {
            if (m_isDone)
                return;
            again();
            look();
        });
    }

    void look()
    {
        QWidget* asked = QApplication::activeModalWidget();
        if (const auto* box = qobject_cast<QMessageBox*>(asked))
            giveUp("Instead of a file it was asked: " + box->text());
        else if (auto* dialog = qobject_cast<QFileDialog*>(asked))
            answer(*dialog);
        else if (m_isEntered)
            end();
        else if (m_sinceBegin.hasExpired(patience))
            giveUp("No dialog asked for " + m_path);
    }

    void answer(QFileDialog& dialog)
    {
        if (m_sinceBegin.hasExpired(patience)) {
            giveUp("The dialog did not take " + m_path);
            return;
        }
        auto* edit = dialog.findChild<QLineEdit*>("fileNameEdit");
        if (edit == nullptr || !dialog.isActiveWindow()) {
            dialog.activateWindow(); // there may be no window manager that does it
            return;
        }
        edit->setCompleter(nullptr); // its list would take Enter
        if (!edit->hasFocus()) {
            edit->setFocus();
            return;
        }
        if (edit->text() != m_path) {
            if (++m_tries > mostTries) {
                giveUp("Typed was " + m_path + ", and there is " + edit->text());
                return;
            }
            QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(edit, m_path);
            return; // looked at once more, when all is settled
        }
        if (m_isEntered && !m_sinceEnter.hasExpired(enterAgain))
            return;
        m_isEntered = true;
        m_sinceEnter.start();
        QTest::keyClick(edit, Qt::Key_Return);
    }

    void giveUp(const QString& why)
    {
        QTest::qFail(qPrintable(why), __FILE__, __LINE__);
        end();
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QDialog*>(widget); dialog != nullptr && dialog->isVisible())
                dialog->reject();
    }

    void end()
    {
        m_isDone = true;
        deleteLater();
    }

    QString m_path;
    QElapsedTimer m_sinceBegin;
    QElapsedTimer m_sinceEnter;
    int m_tries = 0;
    bool m_isEntered = false;
    bool m_isDone = false;
};

} // namespace knead
