#include "core/session/measurement.h"

#include "core/geometry/shape_fit.h"
#include "core/session/body_mass.h"

#include <array>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr int arcPieces = 32;
constexpr double leastLength = 5e-9; // of what the skin carries, in single precision; below it is rounding [m]

/// A measurement with the bodies where they are, or where they were at rest.
struct Setting {
    const Measurement& measurement; ///< of these bodies
    const FilledModel& content;
    const FilledBodies& bodies;
    const Frame* frame; ///< of these bodies; null: at rest

    const FilledBody& body(std::size_t pick) const { return *bodies[measurement.places[pick].body]; }
    const std::vector<Vec3>& places(std::size_t pick) const
    {
        return frame == nullptr ? body(pick).mesh.vertices : frame->bodies[measurement.places[pick].body]->places;
    }
    Vec3 place(std::size_t pick) const { return placeOf(measurement.places[pick], body(pick), places(pick)); }
    std::vector<std::uint32_t> face(std::size_t pick) const
    {
        return trianglesOfFace(measurement.places[pick], body(pick));
    }
};

std::vector<Vec3> arc(const Vec3& center, const Vec3& from, const Vec3& axis, double angle)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= arcPieces; ++i)
        line.emplace_back(center + Eigen::AngleAxisd(angle * i / arcPieces, axis) * from);
    return line;
}

/// What is measured of a scene, and the mark of it.
struct Figure {
    std::vector<double> values; ///< SI, one per reading
    Mark mark;
    Doubt doubt = Doubt::none;
    double deviation = 0; ///< [m]
};

Figure pointFigure(const Setting& setting)
{
    const Vec3 place = setting.place(0);
    const Vec3 rest = placeOf(setting.measurement.places[0], setting.body(0), setting.body(0).mesh.vertices);
    return {{(place - rest).norm(), place.x(), place.y(), place.z()},
            {.lines = {{rest, place}}, .points = {place}, .label = place},
            {}};
}

Figure distanceFigure(const Setting& setting)
{
    const Vec3 a = setting.place(0);
    const Vec3 b = setting.place(1);
    const Vec3 step = (b - a).cwiseAbs();
    return {{(b - a).norm(), step.x(), step.y(), step.z()},
            {.lines = {{a, b}}, .points = {a, b}, .label = (a + b) / 2},
            {}};
}

Figure distanceToFaceFigure(const Setting& setting)
{
    const Vec3 place = setting.place(0);
    const TriangleMesh& mesh = setting.body(1).mesh;
    Vec3 nearest = setting.place(1);
    for (const std::uint32_t t : setting.face(1)) {
        const std::array<Vec3, 3> corners = cornersOf(setting.places(1), mesh.triangles[t]);
        const Vec3 shares = nearestShares(corners, place);
        const Vec3 candidate = shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
        if ((candidate - place).squaredNorm() < (nearest - place).squaredNorm())
            nearest = candidate;
    }
    return {{(nearest - place).norm()},
            {.lines = {{place, nearest}}, .points = {place, nearest}, .label = (place + nearest) / 2},
            {}};
}

Figure angleFigure(const Setting& setting)
{
    const Vec3 apex = setting.place(1);
    const Vec3 a = setting.place(0) - apex;
    const Vec3 b = setting.place(2) - apex;
    const double value = angleBetween(a, b);
    Figure figure{{value}, {.lines = {{apex + a, apex, apex + b}}, .points = {apex + a, apex, apex + b}}, {}};
    figure.mark.label = apex;
    if (const Vec3 axis = a.cross(b); !axis.isZero()) {
        const double reach = 0.4 * std::min(a.norm(), b.norm());
        const std::vector<Vec3> line = arc(apex, reach * a.normalized(), axis.normalized(), value);
        figure.mark.label = line[arcPieces / 2];
        figure.mark.lines.push_back(line);
    }
    return figure;
}

Figure angleOfFacesFigure(const Setting& setting)
{
    std::array<PlaneFit, 2> fits;
    Figure figure;
    const double size = setting.content.box.sizes().maxCoeff();
    for (std::size_t pick = 0; pick < 2; ++pick) {
        fits[pick] = fitPlane(setting.body(pick).mesh, setting.face(pick), setting.places(pick));
        const double length = 0.12 * size;
        figure.mark.lines.push_back({fits[pick].center, fits[pick].center + length * fits[pick].normal});
        figure.mark.points.push_back(fits[pick].center);
        constexpr double flat = 1e-3;                                            // in sizes of the part
        if (figure.doubt == Doubt::none && fits[pick].deviation > flat * size) { // it has a mean normal all the same
            figure.doubt = Doubt::notFlat;
            figure.deviation = fits[pick].deviation;
        }
    }
    figure.mark.lines.push_back({fits[0].center, fits[1].center});
    figure.mark.label = (fits[0].center + fits[1].center) / 2;
    figure.values = {angleBetween(fits[0].normal, fits[1].normal)};
    return figure;
}

Figure radiusFigure(const Setting& setting)
{
    Figure figure{
        {0}, {.points = {setting.place(0), setting.place(1), setting.place(2)}, .label = setting.place(1)}, {}};
    const auto circle = circleThrough(setting.place(0), setting.place(1), setting.place(2));
    if (!circle) {
        figure.values.clear();
        figure.doubt = Doubt::onALine;
        return figure;
    }
    figure.values = {circle->radius};
    figure.mark.lines = {arc(circle->center, setting.place(0) - circle->center, circle->normal, 2 * std::numbers::pi),
                         {circle->center, setting.place(1)}};
    figure.mark.points.push_back(circle->center);
    return figure;
}

Figure radiusOfFaceFigure(const Setting& setting)
{
    const FilledBody& body = setting.body(0);
    const Vec3 clicked = setting.place(0);
    Figure figure{{}, {.points = {clicked}, .label = clicked}, {}};
    const auto fit = fitRound(body.mesh, setting.face(0), setting.places(0), trueVertices(setting.content, body));
    if (!fit) {
        figure.doubt = Doubt::flat;
        return figure;
    }
    figure.values = {fit->radius, 2 * fit->radius};
    const bool isBall = fit->form == RoundFit::Form::ball;
    const Vec3 axis = isBall ? (clicked - fit->center).unitOrthogonal() : fit->axis;
    const Vec3 center = isBall ? fit->center : Vec3(fit->center + axis * (clicked - fit->center).dot(axis));
    const Vec3 out = clicked - center;
    figure.mark.lines = {arc(center, fit->radius * out.normalized(), axis, 2 * std::numbers::pi), {center, clicked}};
    figure.mark.points.push_back(center);
    constexpr double round = 5e-3; // share of the radius
    if (fit->deviation > round * fit->radius) {
        figure.doubt = Doubt::notRound;
        figure.deviation = fit->deviation;
    }
    return figure;
}

Figure boxFigure(const Setting& setting)
{
    const Box box = boxOfPlaces(setting.places(0));
    Figure figure{{box.sizes().x(), box.sizes().y(), box.sizes().z()}, {}, {}};
    const auto corner = [&](int i) { return box.corner(static_cast<Box::CornerType>(i)); };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if ((i & axis) == 0)
                figure.mark.lines.push_back({corner(i), corner(i | axis)});
    figure.mark.label = box.max();
    return figure;
}

std::vector<Reading> readingsOf(MeasureKind kind)
{
    const auto length = [](Message name) { return Reading{.name = std::move(name), .quantity = Quantity::Length}; };
    switch (kind) {
    case MeasureKind::point:
        return {length(Message("Measurement", "Moved")), length(Message("Measurement", "X")),
                length(Message("Measurement", "Y")), length(Message("Measurement", "Z"))};
    case MeasureKind::distance:
        return {length(Message("Measurement", "Distance")), length(Message("Measurement", "along X")),
                length(Message("Measurement", "along Y")), length(Message("Measurement", "along Z"))};
    case MeasureKind::distanceToFace:
        return {length(Message("Measurement", "Distance"))};
    case MeasureKind::angle:
    case MeasureKind::angleOfFaces:
        return {{.name = Message("Measurement", "Angle"), .quantity = Quantity::Angle}};
    case MeasureKind::radius:
        return {length(Message("Measurement", "Radius"))};
    case MeasureKind::radiusOfFace:
        return {length(Message("Measurement", "Radius")), length(Message("Measurement", "Diameter"))};
    case MeasureKind::box:
        return {length(Message("Measurement", "Size X")), length(Message("Measurement", "Size Y")),
                length(Message("Measurement", "Size Z"))};
    case MeasureKind::mass:
        return {{.name = Message("Measurement", "Volume"), .quantity = Quantity::Volume},
                {.name = Message("Measurement", "Mass"), .quantity = Quantity::Mass},
                length(Message("Measurement", "Center of mass X")),
                length(Message("Measurement", "Center of mass Y")),
                length(Message("Measurement", "Center of mass Z"))};
    }
    return {};
}

Figure figureOf(const Setting& setting)
{
    switch (setting.measurement.kind) {
    case MeasureKind::point:
        return pointFigure(setting);
    case MeasureKind::distance:
        return distanceFigure(setting);
    case MeasureKind::distanceToFace:
        return distanceToFaceFigure(setting);
    case MeasureKind::angle:
        return angleFigure(setting);
    case MeasureKind::angleOfFaces:
        return angleOfFacesFigure(setting);
    case MeasureKind::radius:
        return radiusFigure(setting);
    case MeasureKind::radiusOfFace:
        return radiusOfFaceFigure(setting);
    case MeasureKind::box:
        return boxFigure(setting);
    case MeasureKind::mass:
        break;
    }
    return {};
}

/// Volume and mass need the material, and what changed since rest.
Measured massOf(const Measurement& measurement, const FilledModel& content, const Frame& shown, const Snapshot& present)
{
    const BodyId id = measurement.places[0].body;
    const BodyMass rest = massAtRest(content, id, present);
    const BodyMass now = massNow(content, id, shown, present);
    Measured result{.readings = readingsOf(MeasureKind::mass), .mark = {.points = {now.center}, .label = now.center}};
    const auto numbers = [](const BodyMass& mass) {
        return std::array{mass.volume, mass.mass, mass.center.x(), mass.center.y(), mass.center.z()};
    };
    for (std::size_t i = 0; i < result.readings.size(); ++i) {
        result.readings[i].rest = numbers(rest)[i];
        result.readings[i].now = numbers(now)[i];
    }
    constexpr double arm = 0.04; // in sizes of the part
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 reach = arm * content.box.sizes().maxCoeff() * Vec3::Unit(axis);
        result.mark.lines.push_back({now.center - reach, now.center + reach});
    }
    return result;
}

/// The same places on the bodies that a frame shows, which are others where they have come apart before or since. None: a place is
/// not there.
std::optional<Measurement> onShown(Measurement measurement, const FilledModel& content, const Frame& shown)
{
    for (SkinPlace& place : measurement.places) {
        if (haveSameSurface(*content.bodies[place.body], *shown.filled[place.body]))
            continue;
        const std::optional<SkinPlace> there = carriedOver(place, content.bodies, shown.filled);
        if (!there)
            return std::nullopt;
        place = *there;
    }
    return measurement;
}

} // namespace

Measured measured(const Measurement& measurement, const FilledModel& content, const Frame& shown,
                  const Snapshot& present)
{
    Measured result;
    if (measurement.kind == MeasureKind::mass) {
        result = massOf(measurement, content, shown, present);
    } else if (const std::optional<Measurement> there = onShown(measurement, content, shown)) {
        const Figure rest = figureOf({measurement, content, content.bodies, nullptr});
        Figure now = figureOf({*there, content, shown.filled, &shown});
        result.mark = std::move(now.mark);
        result.doubt = now.doubt;
        result.deviation = now.deviation;
        if (!rest.values.empty() && !now.values.empty()) {
            result.readings = readingsOf(measurement.kind);
            for (std::size_t i = 0; i < result.readings.size(); ++i) {
                result.readings[i].rest = rest.values[i];
                result.readings[i].now = now.values[i];
            }
        }
    }
    for (Reading& reading : result.readings)
        if (reading.quantity == Quantity::Length)
            for (double* value : {&reading.rest, &reading.now})
                *value = std::abs(*value) < leastLength ? 0 : *value;
    return result;
}

} // namespace knead
