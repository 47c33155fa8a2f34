#include "ui/language/retranslation.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
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

/// Phrases by the memory that their letters are in.
using Holders = QHash<const QChar*, const Phrase*>;

/// One object's texts.
class Retranslator {
public:
    Retranslator(const Holders& phrases, QObject& object)
        : m_phrases(phrases)
        , m_object(object)
    {
    }

    void texts()
    {
        for (const char* name : {"windowTitle", "title", "text", "toolTip", "statusTip", "whatsThis", "placeholderText",
                                 "prefix", "suffix", "specialValueText", "accessibleName", "whyDisabled"}) {
            if (QByteArrayView(name) == "text" && qobject_cast<QLineEdit*>(&m_object) != nullptr)
                continue; // a person's
            property(name);
        }
    }

    /// A tip to which keys were added; who added them does so again.
    void tip(QAction& action)
    {
        const QString shown = action.property(tipWithoutKeys).toString();
        if (const QString now = said(shown); now != shown)
            action.setToolTip(now);
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
        item(*tree.headerItem());
        for (QTreeWidgetItemIterator one(&tree); *one != nullptr; ++one)
            item(**one);
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
        const Phrase* phrase = shown.isEmpty() ? nullptr : m_phrases.value(shown.constData());
        return phrase == nullptr
                   ? shown
                   : QCoreApplication::translate(phrase->context, phrase->source,
                                                 phrase->comment.isEmpty() ? nullptr : phrase->comment.data(),
                                                 phrase->count);
    }

    void item(QTreeWidgetItem& item)
    {
        for (int i = 0; i < item.columnCount(); ++i) {
            item.setText(i, said(item.text(i)));
            item.setToolTip(i, said(item.toolTip(i)));
        }
    }

    void property(const char* name)
    {
        const QString shown = m_object.property(name).toString();
        const QString now = said(shown);
        if (now != shown)
            m_object.setProperty(name, now);
    }

    const Holders& m_phrases;
    QObject& m_object;
};

void retranslate(const Holders& phrases, QObject& object)
{
    Retranslator one(phrases, object);
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

std::size_t qHash(const Phrase& phrase, std::size_t seed)
{
    return qHashMulti(seed, phrase.context, phrase.source, phrase.comment, phrase.count);
}

void retranslate(const SaidPhrases& before)
{
    Holders phrases;
    for (auto said = before.constBegin(); said != before.constEnd(); ++said)
        phrases[said->constData()] = &said.key();
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (window->parent() != nullptr)
            continue; // comes with that
        retranslate(phrases, *window);
        QList<QPointer<QObject>> objects; // a new text may do away with some
        for (QObject* object : window->findChildren<QObject*>())
            objects << object;
        for (const QPointer<QObject>& object : objects)
            if (object != nullptr)
                retranslate(phrases, *object);
    }
}

} // namespace knead
