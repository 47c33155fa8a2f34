#include "io/morph/edge_morph.h"

#include "io/morph/canonical_curve.h"
#include "io/morph/millimetre_map.h"
#include "io/morph/rigid_piece.h"
#include "io/morph/spline_geometry.h"

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>

#include <vector>

namespace knead {

namespace {

constexpr int leastSamples = 24;
constexpr int mostSamples = 400;

double lengthOf(const GeomAdaptor_Curve& curve, double first, double last)
{
    constexpr int pieces = 16;
    double length = 0;
    for (int i = 0; i < pieces; ++i)
        length += curve.Value(first + (last - first) * i / pieces)
                      .Distance(curve.Value(first + (last - first) * (i + 1) / pieces));
    return length;
}

/// With the curve that it is by its form, if it is one.
bool takesForm(const std::vector<Vec3>& points, const SmoothMap& map, const MorphOptions& options, MorphedEdge& edge)
{
    std::vector<Vec3> places(points.size());
    map.evaluate(points, places);
    const auto form = canonicalCurve(places, options.rigidTolerance());
    if (!form)
        return false;
    edge.curve = form->curve;
    edge.first = form->first;
    edge.last = form->last;
    edge.error = form->error;
    return true;
}

} // namespace

MorphedEdge morphEdge(const TopoDS_Edge& edge, const SmoothMap& map, const MorphOptions& options)
{
    MorphedEdge result;
    BRep_Tool::Range(edge, result.first, result.last);
    Handle(Geom_Curve) source;
    if (!BRep_Tool::Degenerated(edge))
        source = BRep_Tool::Curve(edge, result.first, result.last);
    result.sourceFirst = result.first;
    result.sourceLast = result.last;
    if (source.IsNull())
        return result;
    const GeomAdaptor_Curve curve(source, result.first, result.last);
    const double length = lengthOf(curve, result.first, result.last);
    const double perFeature = length / map.featureSize();
    const int samples = static_cast<int>(
        std::clamp(2 * perFeature, static_cast<double>(leastSamples), static_cast<double>(mostSamples)));
    std::vector<Vec3> points;
    for (int i = 0; i <= samples; ++i)
        points.push_back(toVec3(curve.Value(result.first + (result.last - result.first) * i / samples).XYZ()));
    if (const auto motion = rigidMotionOf(map, points, options.rigidTolerance())) {
        result.curve = moved(source, *motion);
        result.isExact = true;
        return result;
    }
    if (options.findsForms && takesForm(points, map, options, result))
        return result;
    const CurveTarget target = [&](std::span<const double> parameters, std::span<Vec3> places) {
        std::vector<Vec3> at;
        at.reserve(parameters.size());
        for (const double parameter : parameters)
            at.push_back(toVec3(curve.Value(parameter).XYZ()));
        map.evaluate(at, places);
    };
    const SplineFitOptions fitting{.degree = options.degree, .tolerance = options.edgeTolerance(), .mostSpans = 640};
    const auto fit = fitCurve(target, knotsOf(curve, result.first, result.last, options.degree),
                              (result.last - result.first) / std::max(perFeature, 1e-9), fitting);
    result.curve = toGeometry(fit.spline);
    result.error = fit.error;
    result.converged = fit.converged;
    return result;
}

} // namespace knead
