#pragma once

#include <QString>
#include <QStringList>

namespace knead {

/// What else people call a command: "revert" for undo, in the language spoken now and in English. The palette finds it by
/// these, too.
/// @param action its object name
QStringList synonymsOf(const QString& action);

/// The object names of all actions that have synonyms.
QStringList actionsWithSynonyms();

} // namespace knead
