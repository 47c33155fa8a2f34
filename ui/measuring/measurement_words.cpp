#include "ui/measuring/measurement_words.h"

#include "ui/units.h"

#include <QCoreApplication>

namespace knead {

namespace {

struct MeasurementWords {
    Q_DECLARE_TR_FUNCTIONS(Measurement)
};

} // namespace

const std::vector<MeasureLook>& measureLooks()
{
    using enum PickWhat;
    static const std::vector<MeasureLook> all{
        {MeasureKind::point,
         "measurePoint",
         QT_TRANSLATE_NOOP("Measurement", "Point"),
         QT_TRANSLATE_NOOP("Measurement", "Coordinates of a place, and how far it has moved"),
         "measure-point",
         {place}},
        {MeasureKind::distance,
         "measureDistance",
         QT_TRANSLATE_NOOP("Measurement", "Distance"),
         QT_TRANSLATE_NOOP("Measurement", "Distance between two places"),
         "measure-distance",
         {place, place}},
        {MeasureKind::distanceToFace,
         "measureDistanceToFace",
         QT_TRANSLATE_NOOP("Measurement", "Distance to face"),
         QT_TRANSLATE_NOOP("Measurement", "Distance of a place from the nearest point of a face"),
         "measure-to-face",
         {place, face}},
        {MeasureKind::angle,
         "measureAngle",
         QT_TRANSLATE_NOOP("Measurement", "Angle"),
         QT_TRANSLATE_NOOP("Measurement", "Angle at the second of three places"),
         "measure-angle",
         {place, place, place}},
        {MeasureKind::angleOfFaces,
         "measureAngleOfFaces",
         QT_TRANSLATE_NOOP("Measurement", "Angle of faces"),
         QT_TRANSLATE_NOOP("Measurement", "Angle between the normals of two faces"),
         "measure-face-angle",
         {face, face}},
        {MeasureKind::radius,
         "measureRadius",
         QT_TRANSLATE_NOOP("Measurement", "Radius"),
         QT_TRANSLATE_NOOP("Measurement", "Radius of the circle through three places"),
         "measure-radius",
         {place, place, place}},
        {MeasureKind::radiusOfFace,
         "measureRadiusOfFace",
         QT_TRANSLATE_NOOP("Measurement", "Radius of face"),
         QT_TRANSLATE_NOOP("Measurement", "Radius of a hole, a cylinder or a ball"),
         "measure-face-radius",
         {face}},
        {MeasureKind::box,
         "measureBox",
         QT_TRANSLATE_NOOP("Measurement", "Bounding box"),
         QT_TRANSLATE_NOOP("Measurement", "Sizes of a part along the axes"),
         "measure-box",
         {body}},
        {MeasureKind::mass,
         "measureMass",
         QT_TRANSLATE_NOOP("Measurement", "Volume and mass"),
         QT_TRANSLATE_NOOP("Measurement", "Volume, mass and center of mass of a part"),
         "measure-mass",
         {body}},
    };
    return all;
}

const MeasureLook& lookOf(MeasureKind kind)
{
    return measureLooks()[static_cast<std::size_t>(kind)];
}

QString nameOf(const Measurement& measurement)
{
    return QStringLiteral("%1 %2").arg(MeasurementWords::tr(lookOf(measurement.kind).text)).arg(measurement.number);
}

QString textOf(const Measurement& measurement, const Measured& measured)
{
    const std::vector<Reading>& readings = measured.readings;
    if (readings.empty())
        return {};
    const auto shown = [&](std::size_t i) { return formatQuantity(readings[i].now, readings[i].quantity); };
    switch (measurement.kind) {
    case MeasureKind::point:
        return QStringLiteral("(%1, %2, %3)").arg(shown(1), shown(2), shown(3));
    case MeasureKind::radius:
    case MeasureKind::radiusOfFace:
        return QStringLiteral("R %1").arg(shown(0));
    case MeasureKind::box:
        return QStringLiteral("%1 × %2 × %3").arg(shown(0), shown(1), shown(2));
    case MeasureKind::mass:
        return QStringLiteral("%1, %2").arg(shown(0), shown(1));
    default:
        return shown(0);
    }
}

QString remarkOn(const Measured& measured)
{
    const auto deviation = [&] { return formatReading(measured.deviation, Quantity::Length); };
    switch (measured.doubt) {
    case Doubt::none:
        break;
    case Doubt::notFlat:
        return MeasurementWords::tr("The face is not flat: it is up to %1 away from its mean plane.").arg(deviation());
    case Doubt::notRound:
        return MeasurementWords::tr("The face is not quite round: it is up to %1 away from this radius.")
            .arg(deviation());
    case Doubt::onALine:
        return MeasurementWords::tr("The three places lie on a line: pick others, further around.");
    case Doubt::flat:
        return MeasurementWords::tr(
            "The face is flat and has no radius: click a round one, or measure with three places.");
    }
    return {};
}

} // namespace knead
