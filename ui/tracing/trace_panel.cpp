#include "ui/tracing/trace_panel.h"

#include "ui/language/said.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextCursor>
#include <QToolButton>
#include <QVBoxLayout>

namespace knead {

TracePanel::TracePanel(QWidget* parent)
    : QWidget(parent)
    , m_script(new QPlainTextEdit(this))
    , m_copy(new QToolButton(this))
    , m_save(new QToolButton(this))
{
    setObjectName("tracePanel");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    makeRow();
    m_script->setObjectName("trace");
    m_script->setAccessibleName(tr("Python trace"));
    m_script->setPlaceholderText(tr("Open a part: what you do is then written here as Python."));
    m_script->setReadOnly(true);
    m_script->setUndoRedoEnabled(false);
    m_script->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_script->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    column->addWidget(m_script, 1);
}

void TracePanel::makeRow()
{
    auto* row = new QHBoxLayout;
    m_copy->setObjectName("copyTrace");
    m_copy->setText(tr("Copy"));
    m_copy->setToolTip(tr("Copy the whole script"));
    connect(m_copy, &QToolButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
    m_save->setObjectName("saveTrace");
    m_save->setText(tr("Save as..."));
    m_save->setToolTip(tr("Write the script to a file; run, it comes to the same bits"));
    connect(m_save, &QToolButton::clicked, this, &TracePanel::saveWanted);
    for (QToolButton* button : {m_copy, m_save}) {
        button->setEnabled(false);
        row->addWidget(button);
    }
    row->addStretch(1);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void TracePanel::edit(const TextEdit& edit)
{
    const QScrollBar& bar = *m_script->verticalScrollBar();
    const bool isAtEnd = bar.value() == bar.maximum();
    QTextCursor cursor(m_script->document());
    cursor.setPosition(static_cast<int>(edit.kept));
    cursor.movePosition(QTextCursor::End, QTextCursor::KeepAnchor);
    cursor.insertText(edit.problem.empty() ? edit.text : edit.text + "# " + said(edit.problem).simplified() + '\n');
    if (isAtEnd)
        m_script->verticalScrollBar()->setValue(bar.maximum());
    const bool isAny = !m_script->document()->isEmpty();
    m_copy->setEnabled(isAny);
    m_save->setEnabled(isAny);
}

QString TracePanel::text() const
{
    // As it was written: toPlainText() takes other separators for ends of lines, and other spaces for spaces.
    return m_script->document()->toRawText().replace(QChar::ParagraphSeparator, QChar::LineFeed);
}

} // namespace knead
