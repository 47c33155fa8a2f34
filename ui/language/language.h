#pragma once

#include <QString>

#include <span>

namespace knead {

/// A language that the window speaks.
struct Language {
    const char* code; ///< "de"
    const char* name; ///< in itself: "Deutsch"
};

/// English first.
std::span<const Language> languages();

/// The code of a language of ours for what the settings say.
/// @param wanted a code; empty or unknown: that of the system when it is one of ours, else English
QString languageFor(const QString& wanted);

/// Has the whole program speak a language. What is shown changes at once, in windows, menus, dialogs and panels, none of which
/// has to know: what tr() and said() gave is noted, and said anew; see retranslation.h. What was put together by other means, and
/// texts inside of item models and pictures, are for those who make them, at QEvent::LanguageChange. What a person named stays.
/// Window thread; also before the first window.
/// @param code of languages()
void speak(const QString& code);

QString spokenLanguage(); ///< its code

} // namespace knead
