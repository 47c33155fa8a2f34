#pragma once

#include "core/model/file_formats.h"

#include <QStringList>

namespace knead {

/// "STEP (*.step *.stp)": a format as a dialog for files to write has it.
QString filterOf(const FileFormat& format);

/// The same of all formats that are read, for a dialog for files to read.
QStringList filtersToRead();

/// "*.step *.stp ...": all that filtersToRead() hold.
QString patternsToRead();

} // namespace knead
