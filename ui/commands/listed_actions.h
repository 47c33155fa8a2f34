#pragma once

#include <QAction>
#include <QPointer>
#include <QString>

#include <vector>

class QMainWindow;

namespace knead {

/// An action as a person finds it.
struct ListedAction {
    QPointer<QAction> action; ///< null once it is gone, as those of files of late
    QString text;             ///< without marks for keys and dots: "Export"
    QString menu;             ///< that it is in: "File › Open recent"; empty: in none
};

/// A property of actions that open a file, and are called as that is.
inline constexpr const char* opensFile = "opensFile";

/// "E&xport..." becomes "Export".
QString plainText(const QString& actionText);

/// Every action of a window with a text: those of the menu bar in its order, then those that are in no menu. Menus that are
/// shown when they are opened are filled first.
std::vector<ListedAction> listedActions(const QMainWindow& window);

} // namespace knead
