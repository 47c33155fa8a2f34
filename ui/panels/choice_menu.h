#pragma once

#include <QString>

class QComboBox;
class QMenu;
class QWidget;

namespace knead {

/// A menu with the entries of a choice of a panel, so that menus, palette and keys reach them too. What is chosen in one of both
/// shows in the other.
/// @param choice with all its entries; its name begins the names of the actions
/// @param window that owns the menu and its actions
/// @param whyNot why no choice can be made where it cannot, see Availability
QMenu* menuOf(QComboBox* choice, const QString& title, QWidget* window, const QString& whyNot = {});

} // namespace knead
