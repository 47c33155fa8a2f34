#pragma once

#include "core/message/message.h"
#include "core/model/quantity.h"
#include "core/session/skin_place.h"

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

/// Something measured: it goes along with the skin.
struct Measurement {
    MeasureKind kind = MeasureKind::point;
    std::vector<SkinPlace> places; ///< as many as it takes picks; a face is the one that the place lies on
    int number = 0;                ///< among those of its kind, from 1
};

/// One number of a measurement.
struct Reading {
    Message name; ///< "Distance"
    Quantity quantity = Quantity::Length;
    double rest = 0; ///< SI
    double now = 0;  ///< SI
};

/// Lines that belong into the view, and where the numbers go.
struct Mark {
    std::vector<std::vector<Vec3>> lines; ///< [m]
    std::vector<Vec3> points;             ///< [m]
    Vec3 label = Vec3::Zero();            ///< where the text belongs [m]
};

/// How far numbers can be trusted, or why there are none.
enum class Doubt {
    none,
    notFlat,  ///< the face is that far from its mean plane
    notRound, ///< the face is that far from the radius
    onALine,  ///< three places have no circle
    flat      ///< the face has no radius
};

/// What a measurement says at a moment.
struct Measured {
    std::vector<Reading> readings; ///< none when there is nothing to measure
    Mark mark;
    Doubt doubt = Doubt::none;
    double deviation = 0; ///< from the plane or round that was measured [m]
};

/// @param shown what is drawn, perhaps of the past
/// @param present for what frames of the past do not know: materials
Measured measured(const Measurement& measurement, const FilledModel& content, const Frame& shown,
                  const Snapshot& present);

} // namespace knead
