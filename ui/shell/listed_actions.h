#pragma once

#include <QString>

#include <vector>

class QAction;
class QMainWindow;

namespace knead {

/// An action as a person finds it.
struct ListedAction {
    QAction* action = nullptr;
    QString text; ///< without marks for keys and dots: "Export"
    QString menu; ///< that it is in: "File › Open recent"; empty: in none
};

/// "E&xport..." becomes "Export".
QString plainText(const QString& actionText);

/// Every action of a window with a text: those of the menu bar in its order, then those that are in no menu. Menus that are
/// shown when they are opened are filled first.
std::vector<ListedAction> listedActions(const QMainWindow& window);

} // namespace knead
