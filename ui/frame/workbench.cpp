#include "ui/frame/workbench.h"

#include "ui/frame/notices.h"
#include "ui/language/said.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace knead {

bool Workbench::isBusy() const
{
    if (tasks.isRunning())
        notices.problem(said(Message("Workbench", "%1 is still going on: wait for it, or cancel it with Esc.")
                                 .with(tasks.title().toStdString())));
    return tasks.isRunning();
}

QString Workbench::nameForFile(const QString& rest) const
{
    return QFileInfo(QString::fromStdString(document.content().model->file)).completeBaseName() + rest;
}

} // namespace knead
