#include "ui/panels/model_panel.h"

#include "ui/panels/model_tree.h"
#include "ui/theme.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QVBoxLayout>

namespace knead {

ModelPanel::ModelPanel(ModelTree* tree, QWidget* parent)
    : QWidget(parent)
    , m_search(new QLineEdit(this))
    , m_tree(tree)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(6, 6, 6, 4);
    m_search->setObjectName("modelSearch");
    m_search->setPlaceholderText(tr("Search (Ctrl+F)"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);
    row->addWidget(m_search);
    column->addLayout(row);
    column->addWidget(tree, 1);
    connect(m_search, &QLineEdit::textChanged, tree, &ModelTree::filter);
}

void ModelPanel::beginSearch()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

/// Esc empties the field, Down goes to what was found.
bool ModelPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_search || (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride))
        return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isEscape = key->key() == Qt::Key_Escape && !m_search->text().isEmpty();
    if (event->type() == QEvent::ShortcutOverride) {
        if (isEscape)
            event->accept(); // it is not for the window
        return isEscape;
    }
    if (isEscape)
        m_search->clear();
    else if (key->key() == Qt::Key_Down)
        m_tree->setFocus(Qt::OtherFocusReason);
    return isEscape || key->key() == Qt::Key_Down;
}

} // namespace knead
