#include "ui/language/retranslation.h"

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

#include <algorithm>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

/// What was noted.
class Notes {
public:
    void add(const QString& text, std::function<QString()> say)
    {
        const std::lock_guard lock(m_mutex);
        if (m_notes.size() >= m_most) {
            std::erase_if(m_notes, [](const auto& note) { return note.second.text.isDetached(); }); // nobody has them
            m_most = std::max(least, 2 * m_notes.size());
        }
        m_notes[text.constData()] = {text, std::move(say)};
    }

    /// In the language of now. What was not noted stays as it is.
    QString anew(const QString& text) const
    {
        std::unique_lock lock(m_mutex);
        const auto found = text.isEmpty() ? m_notes.end() : m_notes.find(text.constData());
        if (found == m_notes.end())
            return text;
        const std::function<QString()> say = found->second.say;
        lock.unlock(); // it notes things, too
        return say();
    }

private:
    static constexpr std::size_t least = 4096;

    struct Note {
        QString text; ///< which keeps its memory from becoming that of another
        std::function<QString()> say;
    };

    mutable std::mutex m_mutex;
    std::unordered_map<const QChar*, Note> m_notes; ///< by where their letters are
    std::size_t m_most = least;
};

Notes& notes()
{
    static Notes all;
    return all;
}

/// One object's texts.
class Retranslator {
public:
    explicit Retranslator(QObject& object)
        : m_object(object)
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
        if (const QString now = saidAnew(shown); now != shown)
            action.setToolTip(now);
    }

    void choices(QComboBox& box)
    {
        const QSignalBlocker blocker(box); // what is chosen stays chosen
        for (int i = 0; i < box.count(); ++i) {
            box.setItemText(i, saidAnew(box.itemText(i)));
            const QString tip = box.itemData(i, Qt::ToolTipRole).toString();
            if (!tip.isEmpty())
                box.setItemData(i, saidAnew(tip), Qt::ToolTipRole);
        }
    }

    void tabs(QTabWidget& tabs)
    {
        for (int i = 0; i < tabs.count(); ++i) {
            tabs.setTabText(i, saidAnew(tabs.tabText(i)));
            tabs.setTabToolTip(i, saidAnew(tabs.tabToolTip(i)));
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
                head->setText(saidAnew(head->text()));
        for (int i = 0; i < table.rowCount(); ++i)
            if (QTableWidgetItem* head = table.verticalHeaderItem(i))
                head->setText(saidAnew(head->text()));
    }

private:
    void item(QTreeWidgetItem& item)
    {
        for (int i = 0; i < item.columnCount(); ++i) {
            item.setText(i, saidAnew(item.text(i)));
            item.setToolTip(i, saidAnew(item.toolTip(i)));
        }
    }

    void property(const char* name)
    {
        const QString shown = m_object.property(name).toString();
        const QString now = saidAnew(shown);
        if (now != shown)
            m_object.setProperty(name, now);
    }

    QObject& m_object;
};

void retranslate(QObject& object)
{
    Retranslator one(object);
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

QString noted(const QString& text, std::function<QString()> say)
{
    if (!text.isEmpty())
        notes().add(text, std::move(say));
    return text;
}

QString saidAnew(const QString& text)
{
    return notes().anew(text);
}

void retranslate()
{
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (window->parent() != nullptr)
            continue; // comes with that
        retranslate(*window);
        QList<QPointer<QObject>> objects; // a new text may do away with some
        for (QObject* object : window->findChildren<QObject*>())
            objects << object;
        for (const QPointer<QObject>& object : objects)
            if (object != nullptr)
                retranslate(*object);
    }
}

} // namespace knead
