#pragma once

#include "core/session/comparison.h"

#include <QByteArray>
#include <QDateTime>
#include <QImage>
#include <QString>

namespace knead {

/// A report of a comparison, with what was measured beside it.
struct ComparisonReport {
    QString part;          ///< file name of what is compared
    QString original = {}; ///< of another file that it is compared with; empty: with itself at rest
    QDateTime when;
    Comparison comparison;
    QImage picture;       ///< of the view; may be null
    QString measurements; ///< a table in HTML; empty: nothing was measured
};

/// The report as a page that needs no other files.
QString htmlOf(const ComparisonReport& report);

/// The report as PDF or as HTML, by the ending of `name`. Any thread.
QByteArray bytesOf(const ComparisonReport& report, const QString& name);

} // namespace knead
