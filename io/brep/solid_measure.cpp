#include "io/brep/solid_measure.h"

#include "core/geometry/mass_properties.h"
#include "io/brep/face_triangulation.h"
#include "io/brep/slit_closing.h"
#include "io/brep/tessellation.h"

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double squareMillimeter = 1e-6;
constexpr double cubicMillimeter = 1e-9;
constexpr double goodVolume = 8e-4;        // relative; some room below the promised thousandth
constexpr double adaptiveTolerance = 1e-5; // relative, of the adaptive integration
constexpr double gaping = 1e-2;            // of the volume; no integration is better than what gaps leave open
constexpr double farOff = 0.02;            // relative; more than chords cut off
constexpr int mostRefinements = 4;
constexpr double plainAngle = 0.5; // [rad], of the modeler by itself

double adaptiveVolume(const TopoDS_Shape& solid)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, adaptiveTolerance);
    return cubicMillimeter * properties.Mass();
}

/// What the volume is uncertain by when the faces of a solid meet at its edges no better than their tolerances say: strips
/// of that width count or not, each at up to half the diagonal from the middle [m^3].
double volumeOfGaps(const TopoDS_Shape& solid, double diagonal)
{
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid, TopAbs_EDGE, edges);
    double area = 0; // [mm^2]
    for (int i = 1; i <= edges.Extent(); ++i) {
        GProp_GProps length;
        BRepGProp::LinearProperties(edges(i), length);
        area += length.Mass() * BRep_Tool::Tolerance(TopoDS::Edge(edges(i)));
    }
    return squareMillimeter * area * diagonal / 6;
}

class Refinement {
public:
    Refinement(const TopoDS_Shape& solid, double volume, double diagonal, const Tessellation& start)
        : m_solid(solid)
        , m_diagonal(diagonal)
        , m_tessellation(start)
        , m_volume(volume)
        , m_mesh(closeSlits(tessellate(solid, start)))
        , m_meshVolume(massProperties(m_mesh).volume)
        , m_isWatertight(isWatertight(m_mesh))
    {
    }

    SolidMeasure run(bool mayRefine)
    {
        if (!m_isWatertight)
            closeOtherwise();
        if (m_isWatertight && disagreement() > farOff && redrawFacesOfWrongArea(m_solid, m_tessellation))
            takeRedrawn();
        const bool isDone = !mayRefine || !m_isWatertight || isGood() || settleWithSameTriangles();
        for (int i = 0; !isDone && i < mostRefinements && !isGood(); ++i)
            if (!refine())
                break;
        return {m_volume, std::move(m_mesh), disagreement(), m_isWatertight};
    }

private:
    double disagreement() const { return disagreementOf(m_meshVolume); }
    double disagreementOf(double volume) const { return m_volume == 0 ? 1 : std::abs(volume / m_volume - 1); }

    bool isGood() const { return m_isWatertight && disagreement() <= goodVolume; }

    /// The same triangles with their vertices off the curved faces hold what finer and finer triangles would come to.
    /// @return false when that is another volume
    bool settleWithSameTriangles()
    {
        TriangleMesh mesh = closeSlits(collectTriangles(m_solid, m_tessellation, VertexPlace::volumeTrue));
        const double meshVolume = massProperties(mesh).volume;
        if (disagreementOf(meshVolume) > goodVolume) {
            const double ofGaps = volumeOfGaps(m_solid, m_diagonal);
            if (ofGaps > gaping * std::abs(m_volume) && std::abs(meshVolume - m_volume) <= ofGaps)
                return true;
            chooseVolumeNear(meshVolume);
        }
        if (isGood())
            return true;
        if (disagreementOf(meshVolume) > goodVolume)
            return false;
        m_mesh = std::move(mesh);
        m_meshVolume = meshVolume;
        return true;
    }

    void takeRedrawn()
    {
        TriangleMesh mesh = closeSlits(collectTriangles(m_solid, m_tessellation, VertexPlace::onFaces));
        const double meshVolume = massProperties(mesh).volume;
        if (!isWatertight(mesh) || disagreementOf(meshVolume) >= disagreement())
            return;
        m_mesh = std::move(mesh);
        m_meshVolume = meshVolume;
    }

    /// Triangles that do not close may do so when edges are divided in other places. What stays open is not made finer: more
    /// triangles do not bring those that are missing.
    void closeOtherwise()
    {
        const Tessellation other{m_tessellation.deflection,
                                 m_tessellation.angle < plainAngle ? plainAngle : plainAngle / 2};
        BRepTools::Clean(m_solid); // else finer triangles than asked for stay
        TriangleMesh mesh = closeSlits(tessellate(m_solid, other));
        if (!isWatertight(mesh))
            return;
        m_isWatertight = true;
        m_meshVolume = massProperties(mesh).volume;
        m_mesh = std::move(mesh);
        m_tessellation = other;
    }

    /// The error of the volume is proportional to the deflection, and to the square of the angle.
    /// @return false when a finer mesh is no better: then the faces themselves do not say what the volume is
    bool refine()
    {
        const double share = std::clamp(0.7 * goodVolume / disagreement(), 0.25, 0.7);
        const Tessellation finer{share * m_tessellation.deflection, std::sqrt(share) * m_tessellation.angle};
        TriangleMesh mesh = closeSlits(tessellate(m_solid, finer));
        const double meshVolume = massProperties(mesh).volume;
        const double limit = meshVolume + (meshVolume - m_meshVolume) * share / (1 - share);
        chooseVolumeNear(limit);

        const double before = disagreement();
        if (!isWatertight(mesh) || disagreementOf(meshVolume) > before)
            return false;
        m_mesh = std::move(mesh);
        m_meshVolume = meshVolume;
        m_tessellation = finer;
        return disagreement() < 0.9 * before;
    }

    void chooseVolumeNear(double limit)
    {
        if (m_triedAdaptive || std::abs(limit / m_volume - 1) <= goodVolume)
            return;
        m_triedAdaptive = true;
        const double other = adaptiveVolume(m_solid);
        if (std::abs(other - limit) < std::abs(m_volume - limit))
            m_volume = other;
    }

    const TopoDS_Shape& m_solid;
    double m_diagonal; // [m]
    Tessellation m_tessellation;
    double m_volume;
    TriangleMesh m_mesh;
    double m_meshVolume;
    bool m_isWatertight;
    bool m_triedAdaptive = false;
};

} // namespace

SolidMeasure measureSolid(const TopoDS_Shape& solid, double volume, double diagonal, const ImportOptions& options)
{
    return Refinement(solid, volume, diagonal, tessellationFor(diagonal, options)).run(options.linearDeflection == 0);
}

} // namespace knead
