#include "ui/commands/availability.h"

#include "ui/document/document.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QStatusBar>

#include <utility>

namespace knead {

namespace {

constexpr const char* whyNotProperty = "whyDisabled";

std::optional<QString> ask(const Availability::WhyNot& whyNot)
{
    return whyNot ? whyNot() : std::nullopt;
}

} // namespace

Availability::Availability(const Document& document, QMainWindow& window)
    : m_document(document)
    , m_window(window)
{
}

void Availability::add(const QList<QAction*>& actions, WhyNot whyNot)
{
    m_entries.push_back({actions, std::move(whyNot)});
}

void Availability::needPart(const QList<QAction*>& actions, WhyNot besides)
{
    add(actions, [this, besides = std::move(besides)] {
        return m_document.isEmpty() ? std::optional(QCoreApplication::translate("Availability", "Open a part first."))
                                    : ask(besides);
    });
}

void Availability::needBodies(const QList<QAction*>& actions, WhyNot besides)
{
    needPart(actions, [this, besides = std::move(besides)]() -> std::optional<QString> {
        if (m_document.content().bodies.empty())
            return QCoreApplication::translate("Availability",
                                               "Nothing in this part is closed, so nothing can be simulated.");
        const std::optional<QString> unseen = ask(m_whyUnseen);
        return unseen ? unseen : ask(besides);
    });
}

void Availability::update() const
{
    for (const Entry& entry : m_entries) {
        const std::optional<QString> whyNot = entry.whyNot();
        for (QAction* action : entry.actions)
            show(*action, whyNot);
    }
}

/// The status bar goes on saying what holds while the mouse stays there.
void Availability::show(QAction& action, const std::optional<QString>& whyNot) const
{
    action.setEnabled(!whyNot);
    const QString before = action.statusTip();
    const QString now = whyNot.value_or(QString());
    if (now == before)
        return;
    setWhyNot(action, now);
    action.setStatusTip(now);
    if (!before.isEmpty() && m_window.statusBar()->currentMessage() == before)
        m_window.statusBar()->showMessage(now);
}

QString Availability::whyNot(const QAction& action)
{
    return action.property(whyNotProperty).toString();
}

void Availability::setWhyNot(QAction& action, const QString& sentence)
{
    action.setProperty(whyNotProperty, sentence);
}

} // namespace knead
