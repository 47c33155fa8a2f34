#include "ui/commands/listed_actions.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include <set>

namespace knead {

namespace {

class ActionListing {
public:
    void add(const QList<QAction*>& actions, const QString& menu)
    {
        for (QAction* action : actions) {
            if (action->isSeparator() || action->text().isEmpty() || !m_seen.insert(action).second)
                continue;
            const QString text = plainText(action->text());
            if (QMenu* inner = action->menu<QMenu*>())
                addMenu(inner, menu.isEmpty() ? text : QStringLiteral("%1 › %2").arg(menu, text));
            else
                m_list.push_back({action, text, menu});
        }
    }

    std::vector<ListedAction> take() { return std::move(m_list); }

private:
    void addMenu(QMenu* menu, const QString& path)
    {
        if (menu->isEmpty())
            emit menu->aboutToShow();
        add(menu->actions(), path);
    }

    std::vector<ListedAction> m_list;
    std::set<const QAction*> m_seen;
};

} // namespace

QString plainText(const QString& actionText)
{
    static const QRegularExpression mark(QStringLiteral("&(.)"));
    QString text = actionText;
    text.replace(mark, QStringLiteral("\\1"));
    while (text.endsWith('.') || text.endsWith(QChar(0x2026)))
        text.chop(1);
    return text.trimmed();
}

std::vector<ListedAction> listedActions(const QMainWindow& window)
{
    ActionListing listing;
    if (const auto* bar = qobject_cast<QMenuBar*>(window.menuWidget()))
        listing.add(bar->actions(), {});
    listing.add(window.actions(), {});
    return listing.take();
}

} // namespace knead
