#pragma once

#include "core/task/task_control.h"
#include "ui/measuring/body_mass.h"

#include <QByteArray>
#include <QDateTime>
#include <QImage>
#include <QString>

#include <memory>
#include <string>
#include <vector>

namespace knead {

/// How far a body is from its original shape.
struct BodyComparison {
    std::string name;
    double largestDistance = 0;     ///< of its skin from the original surface [m]
    double meanDistance = 0;        ///< the same, by area [m]
    double largestDisplacement = 0; ///< of a vertex of its skin, from rest [m]
    Vec3 farthest = Vec3::Zero();   ///< where its skin is farthest from the original surface [m]
    BodyMass rest;
    BodyMass now;
};

/// Of all bodies at a moment.
struct Comparison {
    double time = 0; ///< simulated [s]
    std::vector<BodyComparison> bodies;
};

/// Searches for the nearest point of the original surface from every vertex of the skin; each counts for the area around it.
/// Any thread; a tenth of a second for 100,000 triangles.
/// @throws Cancelled
Comparison compareWithOriginal(const FilledModel& content, const Frame& shown, const Snapshot& present,
                               TaskControl& control);

/// A report of a comparison, with what was measured beside it.
struct ComparisonReport {
    QString part; ///< file name of what is compared
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
