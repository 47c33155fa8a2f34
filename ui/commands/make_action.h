#pragma once

class QAction;
class QWidget;

namespace knead {

/// What a new action is called and looks like. Texts are as in the code: makeAction() says them in the language spoken.
struct ActionLook {
    const char* name; ///< its object name; the settings keep its keys under it
    const char* text;
    const char* icon = nullptr; ///< null: none
    const char* keys = "";      ///< "Ctrl+Shift+Z; Ctrl+Y"
    const char* tip = nullptr;  ///< without the keys, which Shortcuts adds; null: its text
};

/// Makes an action that works wherever the keyboard is in a window, which owns it.
/// @param context of its texts in the translations
QAction* makeAction(QWidget& window, const ActionLook& look, const char* context = "Actions");

/// The same, to be switched on and off.
QAction* makeSwitch(QWidget& window, const ActionLook& look, bool isOn = false, const char* context = "Actions");

} // namespace knead
