#pragma once

#include "ui/tracing/trace_text.h"

#include <QWidget>

class QPlainTextEdit;
class QToolButton;

namespace knead {

/// What one does as Python: to be read, copied and saved, not to be typed into. Window thread only.
class TracePanel final : public QWidget {
    Q_OBJECT
public:
    explicit TracePanel(QWidget* parent = nullptr);

    /// The end of the text becomes another one. Whoever looks at the end goes on looking there.
    void edit(const TextEdit& edit);

    QString text() const;

signals:
    void saveWanted();

private:
    void makeRow();

    QPlainTextEdit* m_script;
    QToolButton* m_copy;
    QToolButton* m_save;
};

} // namespace knead
