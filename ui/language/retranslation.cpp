#include "ui/language/retranslation.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
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

/// Of what shows a text: has it show that in the language of now.
template <class Setting>
void again(const QString& shown, const Setting& set)
{
    if (const QString now = saidAnew(shown); now != shown)
        set(now);
}

void sayProperties(QObject& object)
{
    for (const char* name : {"windowTitle", "title", "text", "toolTip", "statusTip", "whatsThis", "placeholderText",
                             "prefix", "suffix", "specialValueText", "accessibleName", "whyDisabled"})
        again(object.property(name).toString(), [&](const QString& now) { object.setProperty(name, now); });
}

/// A tip to which keys were added; who added them does so again.
void sayTip(QAction& action)
{
    again(action.property(tipWithoutKeys).toString(), [&](const QString& now) { action.setToolTip(now); });
}

void sayChoices(QComboBox& box)
{
    const QSignalBlocker blocker(box); // what is chosen stays chosen
    for (int i = 0; i < box.count(); ++i)
        for (const int role : {int{Qt::DisplayRole}, int{Qt::ToolTipRole}})
            again(box.itemData(i, role).toString(), [&](const QString& now) { box.setItemData(i, now, role); });
}

void sayTabs(QTabWidget& tabs)
{
    for (int i = 0; i < tabs.count(); ++i) {
        again(tabs.tabText(i), [&](const QString& now) { tabs.setTabText(i, now); });
        again(tabs.tabToolTip(i), [&](const QString& now) { tabs.setTabToolTip(i, now); });
    }
}

void sayLine(QTreeWidgetItem& item)
{
    for (int i = 0; i < item.columnCount(); ++i) {
        again(item.text(i), [&](const QString& now) { item.setText(i, now); });
        again(item.toolTip(i), [&](const QString& now) { item.setToolTip(i, now); });
    }
}

void sayLines(QTreeWidget& tree)
{
    const QSignalBlocker blocker(tree); // nothing was edited
    sayLine(*tree.headerItem());
    for (QTreeWidgetItemIterator one(&tree); *one != nullptr; ++one)
        sayLine(**one);
}

void sayHeading(QTableWidgetItem* heading)
{
    if (heading != nullptr)
        again(heading->text(), [&](const QString& now) { heading->setText(now); });
}

void sayHeadings(const QTableWidget& table)
{
    for (int i = 0; i < table.columnCount(); ++i)
        sayHeading(table.horizontalHeaderItem(i));
    for (int i = 0; i < table.rowCount(); ++i)
        sayHeading(table.verticalHeaderItem(i));
}

void retranslate(QObject& object)
{
    auto* action = qobject_cast<QAction*>(&object);
    if (object.isWidgetType() || action != nullptr)
        sayProperties(object);
    if (action != nullptr)
        sayTip(*action);
    else if (auto* box = qobject_cast<QComboBox*>(&object))
        sayChoices(*box);
    else if (auto* tabs = qobject_cast<QTabWidget*>(&object))
        sayTabs(*tabs);
    else if (auto* tree = qobject_cast<QTreeWidget*>(&object))
        sayLines(*tree);
    else if (const auto* table = qobject_cast<QTableWidget*>(&object))
        sayHeadings(*table);
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
