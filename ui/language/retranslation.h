#pragma once

#include <QByteArray>
#include <QHash>
#include <QString>

namespace knead {

/// A text of the source code, as tr() asks for it.
struct Phrase {
    QByteArray context; ///< mostly the class that says it
    QByteArray source;
    QByteArray comment;
    int count = -1; ///< that decides between singular and plural; -1: none
    friend bool operator==(const Phrase&, const Phrase&) = default;
};

std::size_t qHash(const Phrase& phrase, std::size_t seed = 0);

/// What tr() gave in one language: of each phrase one string, however often it was asked for. Copies of a QString share its
/// letters in memory, so that a label that was given a phrase holds this very string. By that it is known whose phrase it shows,
/// whatever else reads alike.
using SaidPhrases = QHash<Phrase, QString>;

/// A property of actions whose tool tip has keys added to it: what it says but for the keys.
inline constexpr const char* tipWithoutKeys = "tipWithoutKeys";

/// Says what all windows show in the language spoken now: labels, buttons, menus, actions, titles, tips, choices, headings of
/// lists. What was put together of phrases, numbers and names is for those who did so, at QEvent::LanguageChange; what a person
/// typed is left alone. Window thread.
/// @param before what was said in the language before
void retranslate(const SaidPhrases& before);

} // namespace knead
