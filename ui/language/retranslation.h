#pragma once

#include <QString>

#include <functional>

namespace knead {

/// A property of actions whose tool tip has keys added to it: what it says but for the keys.
inline constexpr const char* tipWithoutKeys = "tipWithoutKeys";

/// Notes how a text is said in whatever language is spoken, for as long as somebody has it. Copies of a QString share their
/// letters in memory: a label that was given the text holds this very string, and by that it is known what it shows, whatever
/// else reads alike. Any thread.
/// @return the text
QString noted(const QString& text, std::function<QString()> say);

/// A text as it is said in the language spoken now; one that was not noted stays as it is. Any thread.
QString saidAnew(const QString& text);

/// Says what all windows show in the language spoken now: labels, buttons, menus, actions, titles, tips, choices, headings and
/// lines of lists, as far as it was noted. What a person typed never was. Window thread.
void retranslate();

} // namespace knead
