#include "ui/language/retranslation.h"

#include "ui/language/phrasebook.h"
#include "ui/language/tip_properties.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMetaProperty>
#include <QPointer>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QTableWidget>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QWidget>

namespace knead {

namespace {

QString say(const Phrase& phrase, int count)
{
    return QCoreApplication::translate(phrase.context, phrase.source,
                                       phrase.comment.isEmpty() ? nullptr : phrase.comment.data(), count);
}

/// Classes of an object and of all it is in.
QByteArrayList contextsOf(const QObject* object)
{
    QByteArrayList contexts;
    for (; object != nullptr; object = object->parent())
        for (const QMetaObject* kind = object->metaObject(); kind != nullptr; kind = kind->superClass())
            contexts << kind->className();
    return contexts;
}

/// One object's texts.
class Retranslator {
public:
    Retranslator(const Phrasebook& book, QObject& object)
        : m_book(book)
        , m_object(object)
        , m_contexts(contextsOf(&object))
    {
    }

    void texts()
    {
        for (const char* name : {"windowTitle", "title", "text", "toolTip", "statusTip", "whatsThis", "placeholderText",
                                 "prefix", "suffix", "specialValueText", "accessibleName"}) {
            if (QByteArrayView(name) == "text" && qobject_cast<QLineEdit*>(&m_object) != nullptr)
                continue; // a person's
            property(name);
        }
    }

    /// Tips to which keys were added; who added them does so again.
    void tip(QAction& action)
    {
        const QString shown = action.property(tip_properties::withoutKeys).toString();
        if (!shown.isEmpty() && !action.property(tip_properties::isText).toBool())
            action.setToolTip(said(shown));
        const QString why = action.property("whyDisabled").toString();
        if (!why.isEmpty())
            action.setProperty("whyDisabled", said(why));
    }

    void choices(QComboBox& box)
    {
        const QSignalBlocker blocker(box); // what is chosen stays chosen
        for (int i = 0; i < box.count(); ++i) {
            box.setItemText(i, said(box.itemText(i)));
            const QString tip = box.itemData(i, Qt::ToolTipRole).toString();
            if (!tip.isEmpty())
                box.setItemData(i, said(tip), Qt::ToolTipRole);
        }
    }

    void tabs(QTabWidget& tabs)
    {
        for (int i = 0; i < tabs.count(); ++i) {
            tabs.setTabText(i, said(tabs.tabText(i)));
            tabs.setTabToolTip(i, said(tabs.tabToolTip(i)));
        }
    }

    void outline(QTreeWidget& tree)
    {
        const QSignalBlocker blocker(tree); // nothing was edited
        headings(tree);
        items(tree);
    }

    void headings(QTreeWidget& tree)
    {
        QTreeWidgetItem* head = tree.headerItem();
        for (int i = 0; i < tree.columnCount(); ++i) {
            head->setText(i, said(head->text(i)));
            head->setToolTip(i, said(head->toolTip(i)));
        }
    }

    /// What the tree itself says, as "Tools"; what a person may rename is hers.
    void items(QTreeWidget& tree)
    {
        for (QTreeWidgetItemIterator item(&tree); *item != nullptr; ++item)
            for (int i = 0; i < tree.columnCount(); ++i) {
                (*item)->setToolTip(i, said((*item)->toolTip(i)));
                const bool isHers = (*item)->flags().testFlag(Qt::ItemIsEditable);
                if (const auto own = m_book.ownPhrase((*item)->text(i), m_contexts, say); own && !isHers)
                    (*item)->setText(i, *own);
            }
    }

    void headings(QTableWidget& table)
    {
        for (int i = 0; i < table.columnCount(); ++i)
            if (QTableWidgetItem* head = table.horizontalHeaderItem(i))
                head->setText(said(head->text()));
        for (int i = 0; i < table.rowCount(); ++i)
            if (QTableWidgetItem* head = table.verticalHeaderItem(i))
                head->setText(said(head->text()));
    }

private:
    QString said(const QString& shown) const
    {
        return shown.isEmpty() ? shown : m_book.translated(shown, m_contexts, say);
    }

    void property(const char* name)
    {
        const int index = m_object.metaObject()->indexOfProperty(name);
        if (index < 0 || !m_object.metaObject()->property(index).isWritable())
            return;
        const QString shown = m_object.property(name).toString();
        const QString now = said(shown);
        if (now != shown)
            m_object.setProperty(name, now);
    }

    const Phrasebook& m_book;
    QObject& m_object;
    QByteArrayList m_contexts;
};

void retranslate(const Phrasebook& book, QObject& object)
{
    Retranslator one(book, object);
    if (object.isWidgetType() || qobject_cast<QAction*>(&object) != nullptr)
        one.texts();
    if (auto* action = qobject_cast<QAction*>(&object))
        one.tip(*action);
    else if (auto* box = qobject_cast<QComboBox*>(&object))
        one.choices(*box);
    else if (auto* tabs = qobject_cast<QTabWidget*>(&object))
        one.tabs(*tabs);
    else if (auto* tree = qobject_cast<QTreeWidget*>(&object))
        one.outline(*tree);
    else if (auto* table = qobject_cast<QTableWidget*>(&object))
        one.headings(*table);
}

} // namespace

void retranslate(const Phrasebook& before)
{
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (window->parent() != nullptr)
            continue; // comes with that
        retranslate(before, *window);
        QList<QPointer<QObject>> objects; // a new text may do away with some
        for (QObject* object : window->findChildren<QObject*>())
            objects << object;
        for (const QPointer<QObject>& object : objects)
            if (object != nullptr)
                retranslate(before, *object);
    }
}

} // namespace knead
