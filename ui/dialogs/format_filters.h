#pragma once

#include "ui/services.h"

#include <QStringList>

#include <vector>

namespace knead {

/// "STEP (*.step *.stp)": a format as dialogs for files have it.
QString filterOf(const Services::Format& format);
QStringList filtersOf(const std::vector<Services::Format>& formats);

} // namespace knead
