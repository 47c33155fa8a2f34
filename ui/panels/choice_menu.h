#pragma once

class QComboBox;
class QMenu;
class QString;
class QWidget;

namespace knead {

/// A menu with the entries of a choice of a panel, so that menus, palette and keys reach them too. What is chosen in one of both
/// shows in the other.
/// @param choice with all its entries; its name begins the names of the actions, and its property "whyDisabled" is
/// theirs
/// @param window that owns the menu and its actions
QMenu* menuOf(QComboBox* choice, const QString& title, QWidget* window);

} // namespace knead
