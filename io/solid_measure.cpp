#include "io/solid_measure.h"

#include "core/geometry/mass_properties.h"
#include "io/shape_measure.h"
#include "io/slit_closing.h"
#include "io/tessellation.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double cubicMillimeter = 1e-9;
constexpr double goodVolume = 8e-4;        // relative; some room below the promised thousandth
constexpr double adaptiveTolerance = 1e-5; // relative, of the adaptive integration
constexpr int mostRefinements = 4;

double adaptiveVolume(const TopoDS_Shape& solid)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, adaptiveTolerance);
    return cubicMillimeter * properties.Mass();
}

class Refinement {
public:
    Refinement(const TopoDS_Shape& solid, const Tessellation& start)
        : m_solid(solid)
        , m_tessellation(start)
        , m_volume(cubicMillimeter * volumeOf(solid))
        , m_mesh(closeSlits(tessellate(solid, start)))
        , m_meshVolume(massProperties(m_mesh).volume)
    {
    }

    SolidMeasure run(bool mayRefine)
    {
        for (int i = 0; mayRefine && i < mostRefinements && !isGood(); ++i)
            if (!refine())
                break;
        return {m_volume, std::move(m_mesh), disagreement()};
    }

private:
    double disagreement() const { return m_volume == 0 ? 1 : std::abs(m_meshVolume / m_volume - 1); }

    bool isGood() const { return isWatertight(m_mesh) && disagreement() <= goodVolume; }

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
        const bool isOpen = !isWatertight(m_mesh);
        if (isWatertight(mesh) || isOpen) {
            m_mesh = std::move(mesh);
            m_meshVolume = meshVolume;
            m_tessellation = finer;
        }
        return isOpen || disagreement() < 0.9 * before;
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
    Tessellation m_tessellation;
    double m_volume;
    TriangleMesh m_mesh;
    double m_meshVolume;
    bool m_triedAdaptive = false;
};

} // namespace

SolidMeasure measureSolid(const TopoDS_Shape& solid, double diagonal, const ImportOptions& options)
{
    return Refinement(solid, tessellationFor(diagonal, options)).run(options.linearDeflection == 0);
}

} // namespace knead
