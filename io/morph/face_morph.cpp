#include "io/morph/face_morph.h"

#include "core/message/message.h"
#include "io/morph/canonical_face.h"
#include "io/morph/millimetre_map.h"
#include "io/morph/parameter_curves.h"
#include "io/morph/rigid_piece.h"
#include "io/morph/spline_geometry.h"
#include "io/morph/trim_mask.h"
#include "io/morph/trimmed_face.h"

#include <Eigen/Eigenvalues>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace knead {

namespace {

constexpr int borderSamplesPerEdge = 16;
constexpr double leastLooks = 6; // into a face, per direction
constexpr double mostLooks = 60;
constexpr double reach = 0.6; // beyond a face, in features: so near to the material its map is good, and smooth

class FaceMorpher {
public:
    FaceMorpher(const TopoDS_Face& face, const SmoothMap& map, const MorphOptions& options)
        : m_face(face)
        , m_map(map)
        , m_options(options)
        , m_border(m_face.borderSamples(borderSamplesPerEdge))
        , m_perFeature((m_face.lengths() / map.featureSize()).cwiseMax(1e-9))
        , m_feature((m_face.high() - m_face.low()).cwiseQuotient(m_perFeature))
        , m_mask(m_face, reach * m_feature)
    {
        for (Eigen::Index axis = 0; axis < 2; ++axis)
            m_looks[axis] = std::floor(std::clamp(2 * m_perFeature[axis] + 1, leastLooks, mostLooks));
    }

    MorphedFace run()
    {
        MorphedFace result;
        if (staysRigid(result) || staysPlane(result) || (m_options.findsForms && takesForm(result)))
            return result;
        fit(result);
        addCurves(result, false);
        return result;
    }

private:
    std::vector<Vec3> pointsAt(std::span<const Vec2> parameters) const
    {
        std::vector<Vec3> points;
        points.reserve(parameters.size());
        for (const Vec2& at : parameters)
            points.push_back(m_face.at(at));
        return points;
    }

    /// Border and inside, often enough to see what the map does.
    std::vector<Vec3> samples() const
    {
        std::vector<Vec2> parameters = m_border;
        const std::vector<Vec2> inside = samplesInside();
        parameters.insert(parameters.end(), inside.begin(), inside.end());
        return pointsAt(parameters);
    }

    std::vector<Vec2> samplesInside() const
    {
        std::vector<Vec2> parameters;
        for (double i = 0; i <= m_looks[0]; ++i)
            for (double j = 0; j <= m_looks[1]; ++j) {
                const Vec2 share(i / m_looks[0], j / m_looks[1]);
                const Vec2 at = m_face.low() + share.cwiseProduct(m_face.high() - m_face.low());
                if (m_mask.isNear(at))
                    parameters.push_back(at);
            }
        return parameters;
    }

    bool staysRigid(MorphedFace& result) const
    {
        if (!m_border.empty() && !rigidMotionOf(m_map, pointsAt(m_border), m_options.rigidTolerance()))
            return false; // seen early, without looking inside
        const auto motion = rigidMotionOf(m_map, samples(), m_options.rigidTolerance());
        if (!motion)
            return false;
        result.kind = motion->Form() == gp_Identity ? MorphedFaceKind::kept : MorphedFaceKind::moved;
        result.surface = moved(m_face.surface().Surface(), *motion * m_face.location());
        addCurves(result, true);
        return true;
    }

    /// A plane that the map takes to a plane: its edges say all the rest.
    bool staysPlane(MorphedFace& result) const
    {
        if (m_face.surface().GetType() != GeomAbs_Plane)
            return false;
        const std::vector<Vec3> points = samples();
        std::vector<Vec3> places(points.size());
        m_map.evaluate(points, places);
        const Vec3 middle =
            std::accumulate(places.begin(), places.end(), Vec3(Vec3::Zero())) / static_cast<double>(places.size());
        Mat3 spread = Mat3::Zero();
        for (const Vec3& place : places)
            spread += (place - middle) * (place - middle).transpose();
        const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
        Vec3 normal = axes.eigenvectors().col(0);
        for (const Vec3& place : places)
            if (!(std::abs((place - middle).dot(normal)) <= m_options.rigidTolerance()))
                return false;
        // Turned as the map turns the face, at a place on its border.
        const Vec2 at = m_border.empty() ? m_face.low() : m_border.front();
        const Vec2 step = 1e-3 * (m_face.high() - m_face.low());
        const std::array<Vec3, 3> corner{m_face.at(at), m_face.at({at[0] + step[0], at[1]}),
                                         m_face.at({at[0], at[1] + step[1]})};
        std::array<Vec3, 3> image;
        m_map.evaluate(corner, image);
        if ((image[1] - image[0]).cross(image[2] - image[0]).dot(normal) < 0)
            normal = -normal;
        const Vec3 side = axes.eigenvectors().col(2);
        result.kind = MorphedFaceKind::planar;
        result.surface = new Geom_Plane(
            gp_Ax3(toPoint(middle), gp_Dir(normal.x(), normal.y(), normal.z()), gp_Dir(side.x(), side.y(), side.z())));
        return true;
    }

    /// A cylinder, cone, sphere or torus, in its own parameters.
    bool takesForm(MorphedFace& result) const
    {
        const auto found = canonicalSurface(
            {
                .places = [&](std::span<const Vec2> parameters,
                              std::span<Vec3> places) { m_map.evaluate(pointsAt(parameters), places); },
                .low = m_face.low(),
                .high = m_face.high(),
                .isClosed = {isClosed(0), isClosed(1)},
                .inside = samplesInside(),
                .border = m_border,
            },
            m_options.rigidTolerance());
        if (!found)
            return false;
        result.kind = MorphedFaceKind::reshaped;
        result.surface = found->surface;
        result.isMirrored = found->parameters.mirrors();
        result.error = found->error;
        for (const FaceEdge& edge : m_face.edges()) {
            MorphedFace::EdgeCurves& curves = result.edges.emplace_back(edge.edge);
            curves.first = edge.first;
            curves.last = edge.last;
            std::size_t side = 0;
            for (const Handle(Geom2d_Curve) & curve : edge.shifted())
                curves.curves[side++] = carriedCurve(curve, edge.first, edge.last, found->parameters,
                                                     fittingOf(curve, edge.first, edge.last));
            if (result.isMirrored && side == 2) // what was forward in the face is reversed there
                std::swap(curves.curves[0], curves.curves[1]);
        }
        return true;
    }

    void fit(MorphedFace& result) const
    {
        const Vec2 low = m_face.low();
        const Vec2 high = m_face.high();
        const GeomAdaptor_Surface part(m_face.surface().Surface(), low[0], high[0], low[1], high[1]);
        const SurfaceToFit wanted{
            .target = [&](std::span<const Vec2> parameters,
                          std::span<Vec3> places) { m_map.evaluate(pointsAt(parameters), places); },
            .rest =
                [&](std::span<const Vec2> parameters, std::span<Vec3> places) {
                    std::transform(parameters.begin(), parameters.end(), places.begin(),
                                   [&](const Vec2& at) { return m_face.at(at); });
                },
            .u = knotsOf(part, SurfaceDirection::u, low[0], high[0], m_options.degree),
            .v = knotsOf(part, SurfaceDirection::v, low[1], high[1], m_options.degree),
            .feature = m_feature,
            .counts = [&](const Vec2& at) { return m_mask.isNear(at); },
            .isKnown = [&](const Vec2& at) { return m_mask.isInReach(at); },
            .checks = m_border,
            .isClosed = {isClosed(0), isClosed(1)},
        };
        const auto fitted = fitSurface(
            wanted,
            {.degree = m_options.degree, .tolerance = m_options.faceTolerance(), .slopeTolerance = m_options.slope});
        result.kind = MorphedFaceKind::fitted;
        result.surface = toGeometry(fitted.spline);
        result.error = fitted.error;
        result.worst = fitted.worst;
        result.converged = fitted.converged;
        result.poles = static_cast<int>(fitted.spline.poles.size());
    }

    /// Whether the surface ends along a direction where it begins.
    bool isClosed(Eigen::Index axis) const
    {
        const double size = (m_face.at(m_face.high()) - m_face.at(0.5 * (m_face.low() + m_face.high()))).norm() + 1;
        for (int i = 0; i <= 8; ++i) {
            Vec2 begin = m_face.low() + i / 8.0 * (m_face.high() - m_face.low());
            Vec2 end = begin;
            begin[axis] = m_face.low()[axis];
            end[axis] = m_face.high()[axis];
            if ((m_face.at(begin) - m_face.at(end)).norm() > 1e-7 * size)
                return false;
        }
        return true;
    }

    /// @param isExact the surface is what it was, so curves may stay whatever they are
    void addCurves(MorphedFace& result, bool isExact) const
    {
        if (isExact && m_face.surface().GetType() == GeomAbs_Plane)
            return;
        for (const FaceEdge& edge : m_face.edges()) {
            MorphedFace::EdgeCurves& curves = result.edges.emplace_back();
            curves.edge = edge.edge;
            curves.first = edge.first;
            curves.last = edge.last;
            if (isExact) {
                std::ranges::copy(edge.shifted(), curves.curves.begin());
                continue;
            }
            std::size_t side = 0;
            for (const Handle(Geom2d_Curve) & curve : edge.shifted())
                curves.curves[side++] =
                    isPlain(curve) ? withoutTrim(curve)
                                   : plainCurve(curve, edge.first, edge.last, fittingOf(curve, edge.first, edge.last));
        }
    }

    CurveFitting fittingOf(const Handle(Geom2d_Curve) & curve, double first, double last) const
    {
        const Geom2dAdaptor_Curve adaptor(withoutTrim(curve), first, last);
        return {m_options.degree, std::max(1e-9, 0.01 * m_options.tolerance), metric(adaptor, first, last)};
    }

    /// How far a step along u and v goes in space at most, along a curve [mm].
    Vec2 metric(const Geom2dAdaptor_Curve& curve, double first, double last) const
    {
        Vec2 most = Vec2::Constant(1e-30);
        for (int i = 0; i <= 12; ++i) {
            const gp_Pnt2d at = curve.Value(first + (last - first) * i / 12);
            for (Eigen::Index axis = 0; axis < 2; ++axis) {
                Vec2 there(at.X(), at.Y());
                const Vec3 here = m_face.at(there);
                const double step = 1e-4 * (m_face.high() - m_face.low())[axis];
                there[axis] += step;
                most[axis] = std::max(most[axis], (m_face.at(there) - here).norm() / step);
            }
        }
        return most;
    }

    TrimmedFace m_face;
    const SmoothMap& m_map;
    const MorphOptions& m_options;
    std::vector<Vec2> m_border;
    Vec2 m_perFeature; // size of the face
    Vec2 m_feature;    // in parameters
    TrimMask m_mask;
    Vec2 m_looks = Vec2::Ones();
};

} // namespace

MorphedFace morphFace(const TopoDS_Face& face, const SmoothMap& map, const MorphOptions& options)
{
    const auto failed = [](const Message& why) {
        MorphedFace result;
        result.converged = false;
        result.problem = why;
        return result;
    };
    try {
        return FaceMorpher(face, map, options).run();
    } catch (const Standard_Failure& failure) {
        return failed(Message::verbatim(failure.GetMessageString()));
    } catch (const std::runtime_error& error) {
        return failed(messageOf(error));
    }
}

} // namespace knead
