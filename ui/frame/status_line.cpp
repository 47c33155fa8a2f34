#include "ui/frame/status_line.h"

#include "ui/panels/status_readings.h"
#include "ui/tasks/task_runner.h"

#include <QLabel>
#include <QStatusBar>

namespace knead {

StatusLine::StatusLine(QStatusBar& bar, TaskRunner& tasks)
    : QObject(&bar)
    , m_bar(bar)
    , m_tasks(tasks)
    , m_hint(new QLabel(&bar))
    , m_readings(new StatusReadings(&bar))
{
    auto* task = new TaskReading(&bar);
    m_readings->hide();
    m_hint->setObjectName("navigationHint");
    m_hint->setProperty("role", "dimmed");
    m_hint->setContentsMargins(8, 0, 0, 0);
    bar.setSizeGripEnabled(false);
    bar.addWidget(m_hint);
    bar.addWidget(task);
    bar.addPermanentWidget(m_readings);
    connectTasks(*task);
    connect(&bar, &QStatusBar::messageChanged, this, &StatusLine::showHintWhenFree);
}

void StatusLine::connectTasks(TaskReading& reading)
{
    connect(&m_tasks, &TaskRunner::started, &reading, &TaskReading::begin);
    connect(&m_tasks, &TaskRunner::progressed, &reading, &TaskReading::progress);
    connect(&m_tasks, &TaskRunner::finished, &reading, &TaskReading::end);
    connect(&reading, &TaskReading::cancelClicked, &m_tasks, &TaskRunner::cancel);
    connect(&m_tasks, &TaskRunner::started, &m_bar, &QStatusBar::clearMessage);
    connect(&m_tasks, &TaskRunner::started, m_hint, &QWidget::hide);
    connect(&m_tasks, &TaskRunner::finished, this, &StatusLine::showHintWhenFree);
}

void StatusLine::showHintWhenFree()
{
    m_hint->setVisible(!m_tasks.isRunning() && m_bar.currentMessage().isEmpty());
}

void StatusLine::showHint(const QString& hint)
{
    m_hint->setText(hint);
}

} // namespace knead
