#pragma once

#include <QList>
#include <QString>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QMainWindow;

namespace knead {

class Document;

/// When actions can be done, and why not: who owns an action says it here once, and update() shows it of all of them. Window
/// thread only.
class Availability final {
public:
    /// Why something cannot be done now, in a sentence for the person; nothing: it can be done.
    using WhyNot = std::function<std::optional<QString>()>;

    /// @param window whose status bar says why while the mouse is over what is gray
    Availability(const Document& document, QMainWindow& window);
    Availability(const Availability&) = delete;

    /// @param whyNot asked by each update()
    void add(const QList<QAction*>& actions, WhyNot whyNot);
    /// For what needs an open part. @param besides asked when there is one
    void needPart(const QList<QAction*>& actions, WhyNot besides = {});
    /// For what needs bodies that are simulated, not only surfaces to look at. @param besides asked when there are some
    void needBodies(const QList<QAction*>& actions, WhyNot besides = {});

    /// Where the bodies are not seen, what needs them cannot be done. @param whyNot before any other reason but that there are none
    void whileSeen(WhyNot whyNot) { m_whyUnseen = std::move(whyNot); }

    /// After anything has changed that it depends on but the document, after whose changes the window calls it.
    void update() const;

    /// What update() found, or what else makes an action gray says with setWhyNot(); empty: nobody said.
    static QString whyNot(const QAction& action);
    static void setWhyNot(QAction& action, const QString& sentence);

private:
    struct Entry {
        QList<QAction*> actions;
        WhyNot whyNot;
    };

    void show(QAction& action, const std::optional<QString>& whyNot) const;

    const Document& m_document;
    QMainWindow& m_window;
    std::vector<Entry> m_entries;
    WhyNot m_whyUnseen;
};

} // namespace knead
