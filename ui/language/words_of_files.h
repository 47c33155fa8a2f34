#pragma once

#include <QString>

#include <string>

namespace knead {

/// A sentence about what a file holds, or what was done about it, in the language of the window. Those who read files say it in
/// English, for the command line as well; a sentence that is not known here stays as it is. Numbers, names and units stay.
/// Window thread.
QString inWords(const std::string& sentence);

/// All sentences that are known, with %1, %2 ... for what is put into them; in English, in order.
QStringList sentencesOfFiles();

} // namespace knead
