#include "ui/panels/log_panel.h"

#include <QTime>

namespace knead {

LogPanel::LogPanel(QWidget* parent)
    : QPlainTextEdit(parent)
{
    setObjectName("log");
    setReadOnly(true);
    setMaximumBlockCount(5000);
    setUndoRedoEnabled(false);
}

void LogPanel::add(const QString& sentence, Kind kind)
{
    static const char* const marks[] = {"", "Warning: ", "Error: "};
    const QString text = QTime::currentTime().toString("HH:mm:ss  ") + marks[static_cast<int>(kind)] + sentence;
    const QString weight = kind == Kind::Info ? QStringLiteral("normal") : QStringLiteral("bold");
    appendHtml(QStringLiteral("<span style=\"font-weight:%1; white-space:pre-wrap\">%2</span>")
                   .arg(weight, text.toHtmlEscaped()));
}

} // namespace knead
