#include "core/skin/skin_stress.h"

#include "core/task/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 512;
constexpr double heldShare = 0.5; // of a point's objects that are loaded: from there on nothing is taken off
constexpr double hot = 0.8;       // of the largest stress: points that count for the error where stress is largest

/// exp(2 H) of a symmetric H.
Mat3 squaredStretch(const Mat3& strain)
{
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(strain);
    const Vec3 squares = (2 * solver.eigenvalues()).array().exp();
    return solver.eigenvectors() * squares.asDiagonal() * solver.eigenvectors().transpose();
}

/// What is known at the objects that carry points, at one moment.
struct Carriers {
    std::vector<Vec3> displacement;
    std::vector<std::uint8_t> hasBroken;         ///< empty: none
    std::vector<std::uint8_t> isLoaded;          ///< empty: none
    std::vector<ObjectStrains::Elastic> elastic; ///< empty: nothing has flowed
    std::vector<double> plasticStrain;           ///< with elastic
    std::vector<ObjectStrain> strains;           ///< only where they are needed
};

/// What one point needs of them.
struct Place {
    double trust = 0; ///< in F
    double free = 1;  ///< how far nothing presses
    ObjectIndex nearest = 0;
    Mat3 gradient = Mat3::Identity();
    ObjectStrains::Elastic elastic{Mat3::Zero(), Mat3::Zero()}; ///< of the objects, each with its share
    double plasticStrain = 0;
};

/// One moment of a body, seen from its skin.
class SkinMoment {
public:
    /// What of a moment is looked at.
    struct Options {
        bool withBroken = true;
        bool withObjects = false; ///< strains of all that carry points, not only of those that need them
    };

    SkinMoment(const SkinGradients& gradients, const ObjectStrains& body, std::span<const ObjectIndex> loaded,
               const Options& options)
        : m_gradients(gradients)
        , m_body(body)
    {
        const std::vector<ObjectIndex>& objects = gradients.carriers();
        mark(m_carriers.isLoaded, loaded);
        if (options.withBroken)
            findBroken();
        const std::vector<std::uint8_t> isWanted =
            options.withObjects ? std::vector<std::uint8_t>(objects.size(), 1) : untrusted();
        if (!isWanted.empty())
            m_carriers.strains.resize(objects.size());
        if (body.hasFlowed()) {
            m_carriers.elastic.resize(objects.size());
            m_carriers.plasticStrain.resize(objects.size());
        }
        m_carriers.displacement.resize(objects.size());
        forEachBlock(objects.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                m_carriers.displacement[i] = body.displacements()[objects[i]];
                if (!isWanted.empty() && isWanted[i] != 0)
                    m_carriers.strains[i] = body.of(objects[i]);
                if (!m_carriers.elastic.empty()) {
                    m_carriers.elastic[i] = body.elastic(objects[i]);
                    m_carriers.plasticStrain[i] = body.plasticStrain(objects[i]);
                }
            }
        });
    }

    Place at(std::size_t point) const
    {
        Place place{.trust = isBeside(point) ? 0 : m_gradients.trust(point), .nearest = nearestTo(point)};
        place.gradient += m_gradients.sumOfProducts(point, m_carriers.displacement);
        if (!m_carriers.elastic.empty())
            addElastic(point, place);
        if (!m_carriers.isLoaded.empty())
            place.free = freeShare(point);
        return place;
    }

    /// Of the objects around a point, by the size of their share: a mean over what is below the skin.
    Mat3 averaged(std::size_t point) const
    {
        Mat3 sum = Mat3::Zero();
        double all = 0;
        for (const auto& [carrier, value, slope] : m_gradients.influences(point)) {
            const double share = std::abs(static_cast<double>(value));
            sum += share * m_carriers.strains[carrier].stress;
            all += share;
        }
        return sum / all;
    }

    /// Of the objects, each with its share in the skin.
    Mat3 carried(std::size_t point, Mat3 ObjectStrain::*tensor) const
    {
        Mat3 sum = Mat3::Zero();
        for (const auto& [carrier, value, slope] : m_gradients.influences(point))
            sum += static_cast<double>(value) * (m_carriers.strains[carrier].*tensor);
        return sum;
    }

    bool hasFlowed() const { return m_body.hasFlowed(); }

    Material material(const Place& place) const
    {
        return bearingMaterial(m_body.materials().of(place.nearest), m_body.materials());
    }

private:
    /// Broken connections.
    bool isBeside(std::size_t point) const
    {
        const std::span<const SkinGradients::Influence> around = m_gradients.influences(point);
        return !m_carriers.hasBroken.empty() && std::ranges::any_of(around, [&](const auto& influence) {
            return m_carriers.hasBroken[influence.carrier] != 0;
        });
    }

    /// The object that has the largest share, where objects differ.
    ObjectIndex nearestTo(std::size_t point) const
    {
        if (m_body.materials().isUniform())
            return 0;
        const std::span<const SkinGradients::Influence> around = m_gradients.influences(point);
        const auto nearest = std::ranges::max_element(
            around, [](const auto& a, const auto& b) { return std::abs(a.value) < std::abs(b.value); });
        return m_gradients.carriers()[nearest->carrier];
    }

    void addElastic(std::size_t point, Place& place) const
    {
        for (const auto& [carrier, value, slope] : m_gradients.influences(point)) {
            place.elastic.gradient += static_cast<double>(value) * m_carriers.elastic[carrier].gradient;
            place.elastic.strain += static_cast<double>(value) * m_carriers.elastic[carrier].strain;
            place.plasticStrain += static_cast<double>(value) * m_carriers.plasticStrain[carrier];
        }
        place.plasticStrain = std::max(0.0, place.plasticStrain);
    }

    double freeShare(std::size_t point) const
    {
        double all = 0;
        double loaded = 0;
        for (const auto& [carrier, value, slope] : m_gradients.influences(point)) {
            all += std::abs(static_cast<double>(value));
            loaded += m_carriers.isLoaded[carrier] != 0 ? std::abs(static_cast<double>(value)) : 0;
        }
        return std::max(0.0, 1 - loaded / (heldShare * all));
    }

    void mark(std::vector<std::uint8_t>& marks, std::span<const ObjectIndex> which) const
    {
        if (which.empty())
            return;
        std::vector<ObjectIndex> sorted(which.begin(), which.end());
        std::ranges::sort(sorted);
        const std::vector<ObjectIndex>& objects = m_gradients.carriers();
        marks.resize(objects.size());
        std::transform(objects.begin(), objects.end(), marks.begin(),
                       [&](ObjectIndex object) { return std::ranges::binary_search(sorted, object) ? 1 : 0; });
    }

    void findBroken()
    {
        if (!m_body.hasBroken())
            return;
        const std::vector<ObjectIndex>& objects = m_gradients.carriers();
        m_carriers.hasBroken.resize(objects.size());
        std::transform(objects.begin(), objects.end(), m_carriers.hasBroken.begin(),
                       [&](ObjectIndex object) { return m_body.hasBroken(object) ? 1 : 0; });
    }

    /// Carriers of points where F is not known; empty: none.
    std::vector<std::uint8_t> untrusted() const
    {
        std::vector<std::uint8_t> marks;
        for (std::size_t point = 0; point < m_gradients.size(); ++point) {
            if (m_gradients.trust(point) >= 1 && !isBeside(point))
                continue;
            marks.resize(m_gradients.carriers().size());
            for (const SkinGradients::Influence& influence : m_gradients.influences(point))
                marks[influence.carrier] = 1;
        }
        return marks;
    }

    const SkinGradients& m_gradients;
    const ObjectStrains& m_body;
    Carriers m_carriers;
};

/// C at a place: of the elastic strain of its objects, changed by how much farther F is there than theirs, in so far as that is
/// elastic. Where much has flowed nearly all of it is flow, of which the objects know no more than their own.
Mat3 relaxedMetric(const Place& place, const Material& material)
{
    const double yieldStrain = flowStress(material, place.plasticStrain) / material.youngsModulus;
    const double share = place.plasticStrain > 0 ? 1 / (1 + place.plasticStrain / yieldStrain) : 1;
    const Mat3 farther = place.gradient * place.elastic.gradient.inverse() - Mat3::Identity();
    const Mat3 step = Mat3::Identity() + share * farther;
    const Mat3 elastic = step * squaredStretch(place.elastic.strain) * step.transpose();
    return place.gradient.transpose() * elastic.inverse() * place.gradient;
}

/// What stays of a stress at a place when what is not real is taken off.
Mat3 cleared(const Mat3& stress, const Place& place, const FreeSurface& surface, const Material& material)
{
    const Mat3 free = withoutTraction(stress, moved(surface, place.gradient), material.poissonRatio, place.free);
    return limitedStress(free, flowStress(material, place.plasticStrain));
}

/// How wrong a stress may be, as a share of it, since the skin goes inwards; not more than all of it.
double hollowShare(const FreeSurface& surface, double spacing)
{
    return std::min(1.0, SkinStress::errorPerHollow * spacing * surface.hollow);
}

double errorWhereLargest(const SkinStresses& stresses)
{
    double most = 0;
    for (const float one : stresses.vonMises)
        most = std::max(most, static_cast<double>(one));
    double error = 0;
    double stress = 0;
    for (std::size_t i = 0; i < stresses.vonMises.size(); ++i)
        if (static_cast<double>(stresses.vonMises[i]) >= hot * most) {
            error += static_cast<double>(stresses.error[i]);
            stress += static_cast<double>(stresses.vonMises[i]);
        }
    return stress > 0 ? error / stress : 0;
}

/// Hencky, ln sqrt(F F^T), flow included.
Mat3 strainAt(const SkinMoment& moment, std::uint32_t point)
{
    const Place place = moment.at(point);
    Mat3 strain = Mat3::Zero();
    if (place.trust > 0)
        strain += place.trust * halfLogarithm(place.gradient * place.gradient.transpose());
    if (place.trust < 1)
        strain += (1 - place.trust) * moment.carried(point, &ObjectStrain::strain);
    return strain;
}

/// Cauchy [Pa].
Mat3 stressAt(const SkinMoment& moment, std::uint32_t point, const FreeSurface& surface)
{
    const Place place = moment.at(point);
    const Material material = moment.material(place);
    const double most = flowStress(material, place.plasticStrain);
    Mat3 stress = Mat3::Zero();
    if (place.trust > 0)
        stress += place.trust * cauchyStress(place.gradient,
                                             moment.hasFlowed() ? relaxedMetric(place, material) : Mat3::Identity(),
                                             material, most);
    if (place.trust < 1)
        stress += (1 - place.trust) * moment.carried(point, &ObjectStrain::stress);
    return cleared(stress, place, surface, material);
}

/// Calls visit(point) for each, on all threads.
template <typename Visit>
void forAllPoints(const SkinGradients& gradients, Visit&& visit)
{
    forEachBlock(gradients.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            visit(gradients.order()[i]);
    });
}

} // namespace

SkinStress::SkinStress(const Aggregate& aggregate, const TriangleMesh& mesh, std::span<const ObjectIndex> numbers,
                       TaskControl& control)
    : SkinStress(aggregate, mesh.vertices, freeSurfaces(mesh), numbers, control)
{
}

SkinStress::SkinStress(const Aggregate& aggregate, std::span<const Vec3> points, std::vector<FreeSurface> surfaces,
                       std::span<const ObjectIndex> numbers, TaskControl& control)
    : m_isPiece(!numbers.empty())
    , m_spacing(aggregate.lattice.spacing)
    , m_gradients(aggregate, points, numbers, control)
    , m_surfaces(std::move(surfaces))
{
    assert(m_surfaces.size() == points.size());
}

SkinStresses SkinStress::stresses(const ObjectStrains& body, std::span<const ObjectIndex> loaded, bool wantsError) const
{
    const SkinMoment moment(m_gradients, body, loaded, {.withBroken = !m_isPiece, .withObjects = wantsError});
    SkinStresses result;
    result.vonMises.resize(size());
    result.error.resize(wantsError ? size() : 0);
    forAllPoints(m_gradients, [&](std::uint32_t point) {
        const Mat3 stress = stressAt(moment, point, m_surfaces[point]);
        result.vonMises[point] = static_cast<float>(vonMisesStress(stress));
        if (wantsError)
            result.error[point] =
                static_cast<float>(std::max(errorPerDifference * vonMisesStress(stress - moment.averaged(point)),
                                            hollowShare(m_surfaces[point], m_spacing) * vonMisesStress(stress)));
    });
    if (wantsError)
        result.errorShare = errorWhereLargest(result);
    return result;
}

std::vector<float> SkinStress::strains(const ObjectStrains& body) const
{
    const SkinMoment moment(m_gradients, body, {}, {.withBroken = !m_isPiece});
    std::vector<float> result(size());
    forAllPoints(m_gradients, [&](std::uint32_t point) {
        result[point] = static_cast<float>(equivalentStrain(strainAt(moment, point)));
    });
    return result;
}

SkinTensors SkinStress::tensors(const ObjectStrains& body, std::span<const ObjectIndex> loaded) const
{
    const SkinMoment moment(m_gradients, body, loaded, {.withBroken = !m_isPiece});
    SkinTensors result;
    result.strain.resize(size());
    result.stress.resize(size());
    forAllPoints(m_gradients, [&](std::uint32_t point) {
        result.strain[point] = strainAt(moment, point);
        result.stress[point] = stressAt(moment, point, m_surfaces[point]);
    });
    return result;
}

} // namespace knead
