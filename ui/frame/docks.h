#pragma once

#include <QString>

#include <map>
#include <string_view>
#include <utility>
#include <vector>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace knead {

/// Panels around the view. Where each stands, beside which, and whether it is shown at first, says one table in docks.cpp; all can be
/// moved, floated and closed. Window thread only.
class Docks {
public:
    explicit Docks(QMainWindow& window);

    /// @param name in the table, and of the dock as an object
    QDockWidget& add(std::string_view name, const QString& title, QWidget* panel);

    /// Puts all where they stand, in the order of the table, whatever the order in which they were added.
    void arrange();
    /// Hides what comes with what one does for the first time. Once all of the window was laid out.
    void hideLaterOnes();
    /// As wide and high as they come.
    void size();

    /// @pre it was added
    QDockWidget& of(std::string_view name) const;
    /// Shows it, in front of those that share its place.
    void show(std::string_view name) const;
    /// In front of those that share its place, unless it was closed.
    void bringForward(std::string_view name) const;
    /// @param least height that it gets when it is lower [pixels]
    void showAtLeast(std::string_view name, int least) const;

private:
    QMainWindow& m_window;
    std::map<std::string_view, QDockWidget*> m_docks; ///< by their names in the table
};

} // namespace knead
