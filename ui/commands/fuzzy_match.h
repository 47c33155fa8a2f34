#pragma once

#include <QList>
#include <QString>

#include <optional>

namespace knead {

struct FuzzyMatch {
    int score = 0;         ///< the higher the better
    QList<qsizetype> hits; ///< letters of the text that were meant
};

/// How well a text fits what a person typed to find it: its letters in their order, whatever lies between. Beginnings of words and
/// letters side by side count more; accents, case and spaces do not matter.
/// @return none when a letter is missing; an empty pattern fits everything
std::optional<FuzzyMatch> fuzzyMatch(const QString& pattern, const QString& text);

/// The same where a word of the text begins with all of the pattern: for words that are not shown, of which none should fit
/// by chance.
/// @return none also for an empty pattern
std::optional<FuzzyMatch> wordMatch(const QString& pattern, const QString& text);

} // namespace knead
