#pragma once

#include "ui/measuring/skin_place.h"
#include "ui/units.h"

#include <QString>

#include <vector>

namespace knead {

/// What a person can measure.
enum class MeasureKind {
    point,          ///< where a place is and how far it has moved
    distance,       ///< between two places
    distanceToFace, ///< of a place from the nearest point of a face
    angle,          ///< at the second of three places
    angleOfFaces,   ///< between the mean normals of two faces
    radius,         ///< of the circle through three places
    radiusOfFace,   ///< of the cylinder or ball that a face is part of
    box,            ///< sizes along the axes
    mass            ///< volume, mass and center of mass
};

/// What a click must meet.
enum class PickWhat { place, face, body };

/// What a person has to be told of a way of measuring.
struct MeasureLook {
    MeasureKind kind;
    const char* name; ///< of its action
    const char* text; ///< in menus and lists
    const char* tip;
    const char* icon;
    std::vector<PickWhat> picks; ///< that it takes, in order
};
const std::vector<MeasureLook>& measureLooks(); ///< in the order of MeasureKind
const MeasureLook& lookOf(MeasureKind kind);

/// Something measured: it goes along with the skin.
struct Measurement {
    MeasureKind kind = MeasureKind::point;
    std::vector<SkinPlace> places; ///< as many as it takes picks; a face is the one that the place lies on
    int number = 0;                ///< among those of its kind, from 1
};

/// One number of a measurement.
struct Reading {
    QString name;
    Quantity quantity = Quantity::Length;
    double rest = 0; ///< SI
    double now = 0;  ///< SI
};

/// Lines and numbers that belong into the view.
struct Mark {
    std::vector<std::vector<Vec3>> lines; ///< [m]
    std::vector<Vec3> points;             ///< [m]
    Vec3 label = Vec3::Zero();            ///< where the text belongs [m]
    QString text;
};

/// What a measurement says at a moment.
struct Measured {
    std::vector<Reading> readings; ///< none when there is nothing to measure
    Mark mark;
    QString
        remark; ///< a sentence about how far the numbers can be trusted, or why there are none; empty: nothing to say
};

/// @param shown what is drawn, perhaps of the past
/// @param present for what frames of the past do not know: materials
Measured measured(const Measurement& measurement, const FilledModel& content, const Frame& shown,
                  const Snapshot& present);

/// "Distance 2"
QString nameOf(const Measurement& measurement);

} // namespace knead
