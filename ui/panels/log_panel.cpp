#include "ui/panels/log_panel.h"

#include <QTime>

namespace knead {

LogPanel::LogPanel(QWidget* parent)
    : QPlainTextEdit(parent)
{
    setObjectName("log");
    setAccessibleName(tr("Log"));
    setReadOnly(true);
    setMaximumBlockCount(5000);
    setUndoRedoEnabled(false);
}

void LogPanel::add(const QString& sentence, Kind kind)
{
    const QString marked = kind == Kind::Warning ? tr("Warning: %1").arg(sentence)
                           : kind == Kind::Error ? tr("Error: %1").arg(sentence)
                                                 : sentence;
    const QString text = QTime::currentTime().toString("HH:mm:ss  ") + marked;
    const QString weight = kind == Kind::Info ? QStringLiteral("normal") : QStringLiteral("bold");
    appendHtml(QStringLiteral("<span style=\"font-weight:%1; white-space:pre-wrap\">%2</span>")
                   .arg(weight, text.toHtmlEscaped()));
}

} // namespace knead
