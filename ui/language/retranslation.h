#pragma once

namespace knead {

class Phrasebook;

/// Says what all windows show in the language spoken now: labels, buttons, menus, actions, titles, tips, choices, headings of
/// lists. What a person typed is left alone. Window thread.
/// @param before what was said in the language before
void retranslate(const Phrasebook& before);

} // namespace knead
