#include "core/mechanics/connection_parameters.h"

#include "core/mechanics/connection_flow.h"
#include "core/mechanics/connection_fracture.h"
#include "core/mechanics/rubber_connections.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

// Fewer objects than this stay in one block: they take less time than handing part of them to another thread.
constexpr std::size_t smallestSplit = 4096;
// More, in at least so many blocks, so that threads end together.
constexpr std::size_t fewestBlocks = 8;
constexpr std::size_t smallestBlock = 2048;
constexpr std::size_t largestBlock = 65536;

// Stiffness of a contact in units of mu V / a^2. 6 keeps a tool from sinking visibly into soft material
// (overlap / a about 0.4 p / E) and adds a half to the stiffness of a surface object, a tenth to the number of steps.
constexpr double contactShare = 6;

// Surroundings whose connections lie this near to a plane say nothing about volume.
constexpr double flattestShape = 0.01;

constexpr std::size_t wholeVectors(std::size_t count)
{
    return (count + laneCount - 1) / laneCount * laneCount;
}

bool anyTensorial(const ConnectionData& data)
{
    return data.materials->largest([](const Material& material) { return material.isTensorial() ? 1 : 0; }) > 0;
}

double bulkModulusOf(const Material& material)
{
    return material.lameLambda() + 2.0 / 3 * material.shearModulus();
}

double yieldStressOf(const Material& material)
{
    return material.yields() ? material.yieldStress : std::numeric_limits<double>::infinity();
}

/// What heals is not tired by being kneaded to and fro.
double shearDamageOf(const Material& material)
{
    return material.heals() ? 0 : 0.5;
}

void findDampingTimes(ConnectionData& data)
{
    const bool differ = data.laws.leastDampingTime() < data.laws.largestDampingTime();
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        LaneVector<double>& times = data.dampingTime[d];
        times.assign(differ ? data.stiffness[d].size() : 0, 0);
        if (differ)
            forEachStretch(data.aggregate->lattice, d, 0, times.size(),
                           [&](std::size_t i, std::size_t j, std::size_t n) {
                               data.laws.fill(&ConnectionLaw::dampingTime, i, j, n, &times[i]);
                           });
    }
}

void findStiffness(ConnectionData& data)
{
    const double a = data.aggregate->lattice.spacing;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::vector<double>& weight = data.aggregate->weight[d];
        LaneVector<double>& stiffness = data.stiffness[d];
        stiffness.assign(weight.size(), 0);
        forEachStretch(data.aggregate->lattice, d, 0, weight.size(), [&](std::size_t i, std::size_t j, std::size_t n) {
            data.laws.fill(&ConnectionLaw::stiffness, i, j, n, &stiffness[i]);
            for (std::size_t s = i; s < i + n; ++s)
                stiffness[s] *= a * weight[s];
        });
    }
    findDampingTimes(data);
    for (const ConnectionId& broken : data.changes.broken)
        data.stiffness[broken.direction][broken.lower] = 0;
    data.count = data.aggregate->connectionCount() - data.changes.broken.size();
}

void findTensorNumbers(ConnectionData& data)
{
    data.tensors = anyTensorial(data) ? std::make_unique<TensorBody>() : nullptr;
    if (!data.tensors)
        return;
    const std::size_t count = data.aggregate->size();
    TensorBody& body = *data.tensors;
    body.volume.assign(data.borneVolume.begin(), data.borneVolume.end()); // see findLiveShape(data)
    body.energy.assign(count, 0);
    findRubber(data);
    if (data.materials->isUniform())
        return;
    for (auto* numbers :
         {&body.shear, &body.bulk, &body.yieldStress, &body.hardening, &body.flowTime, &body.shearDamage})
        numbers->assign(count, 0);
    std::vector<double> shape(count, 0);     // sum of w |o|^2 over all connections that were made
    std::vector<double> stiffness(count, 0); // sum of k |o|^2
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const double squared = latticeVector(d).squaredNorm();
        forEachPair(data.aggregate->lattice, d, 0, count, [&](ObjectIndex i, ObjectIndex j) {
            const double share = squared * data.aggregate->weight[d][i];
            const double k = squared * data.aggregate->lattice.spacing * data.aggregate->weight[d][i] *
                             data.laws.between(i, j).stiffness;
            for (const ObjectIndex end : {i, j}) {
                stiffness[end] += k;
                shape[end] += share;
            }
        });
    }
    for (ObjectIndex i = 0; i < count; ++i) {
        const Material& material = data.materials->of(i);
        // Beside softer material, connections are as stiff as springs in series, and so is the object.
        const double own = material.shearModulus() * data.aggregate->lattice.spacing * shape[i];
        const double share = own > 0 ? std::min(1.0, stiffness[i] / own) : 1;
        body.shear[i] = share * material.shearModulus();
        body.bulk[i] = share * bulkModulusOf(material);
        body.yieldStress[i] = yieldStressOf(material);
        body.hardening[i] = material.hardening;
        body.flowTime[i] = material.relaxationTime;
        body.shearDamage[i] = shearDamageOf(material);
    }
}

void findInverseShapes(ConnectionData& data)
{
    const std::size_t count = data.aggregate->size();
    data.tensors.reset();
    const auto bulkModulus = [](const Material& material) {
        const double modulus = material.lameLambda() - material.shearModulus();
        return std::abs(modulus) < 1e-9 * material.shearModulus() ? 0 : modulus;
    };
    data.hasBulk = data.materials->largest([&](const Material& m) { return std::abs(bulkModulus(m)); }) > 0;
    for (auto& component : data.inverseShape)
        component.resize(count);
    for (VectorArray& column : data.stress)
        column.resize(data.hasBulk || anyTensorial(data) ? count : 0);
    data.bulk.resize(count);
    data.flat.clear();
    data.theta.assign(count, 0);
    std::vector<Mat3> shape(count, Mat3::Zero());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Mat3 dyad = latticeVector(d) * latticeVector(d).transpose();
        forEachPair(data.aggregate->lattice, d, 0, count, [&](ObjectIndex i, ObjectIndex j) {
            shape[i] += data.stiffness[d][i] * dyad;
            shape[j] += data.stiffness[d][i] * dyad;
        });
    }
    for (ObjectIndex i = 0; i < count; ++i) {
        data.bulk[i] = bulkModulus(data.materials->of(i)) * data.borneVolume[i];
        setInverseShape(data, i, shape[i]);
    }
    findTensorNumbers(data);
    data.brokenAround.clear();
    for (const ConnectionId& broken : data.changes.broken)
        markBroken(data, broken);
    for (ObjectIndex i = 0; i < data.brokenAround.size(); ++i)
        if (data.brokenAround[i] != 0)
            findLiveShape(data, i);
}

} // namespace

ConnectionData::ConnectionData(std::shared_ptr<const Aggregate> of, const MaterialMap& materialsOfIt)
    : aggregate(std::move(of))
    , materials(&materialsOfIt)
    , laws(materialsOfIt, aggregate->lattice.spacing)
    , borneVolume(aggregate->borneVolume())
{
    std::size_t largestOffset = 0;
    for (const auto& segments : aggregate->lattice.segments)
        for (const Lattice::Segment& segment : segments)
            largestOffset = std::max(largestOffset, static_cast<std::size_t>(segment.offset));
    // A margin must not reach beyond the next block. With blocks of four times its reach, adding it up costs little.
    const std::size_t reach = wholeVectors(largestOffset + laneCount);
    const std::size_t objects = aggregate->size();
    blockSize = objects <= smallestSplit
                    ? smallestSplit
                    : std::max({smallestBlock, reach,
                                std::min({wholeVectors(objects / fewestBlocks + 1), 4 * reach, largestBlock})});
    for (std::size_t end = blockSize; end < aggregate->size(); end += blockSize) {
        const std::size_t overlap = 2 * laneCount;
        margins.push_back({end - overlap, VectorArray(overlap + reach), VectorArray(overlap + reach)});
    }
    runs = findRuns(aggregate->lattice, RunNeighbors::ahead);
    stressRuns = findRuns(aggregate->lattice, RunNeighbors::all);
    const std::vector<std::uint32_t> behind = neighborsBehind(aggregate->lattice);
    hasBehind.assign(behind.begin(), behind.end());
    changes.restDilatation.assign(aggregate->size(), 0);
    updateMaterials(*this);
}

void updateMaterials(ConnectionData& data)
{
    data.laws = ConnectionLaws(*data.materials, data.aggregate->lattice.spacing);
    findStiffness(data);
    data.mode.resize(0);
    data.hasTrial = false;
    data.forgetEnergy();
    if (data.laws.anyYields())
        makeLengthsOwn(data);
    findInverseShapes(data);
}

void restoreChanges(ConnectionData& data, ConnectionChanges changes)
{
    data.changes = std::move(changes);
    ++data.lengthVersion;
    if (data.changes.restDilatation.empty())
        data.changes.restDilatation.assign(data.aggregate->size(), 0);
    if (!data.changes.plastic.nominalLength[0].empty() && data.changes.plastic.metric[0].empty())
        findMetric(data);
    updateMaterials(data);
}

void makeLengthsOwn(ConnectionData& data)
{
    const auto ensure = [](LaneVector<double>& numbers, std::size_t size, double value) {
        if (numbers.size() != size)
            numbers.assign(size, value);
    };
    PlasticState& plastic = data.changes.plastic;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        ensure(plastic.nominalLength[d], data.stiffness[d].size(),
               data.aggregate->lattice.direction(static_cast<int>(d)).norm());
    for (std::size_t c = 0; c < 6; ++c)
        ensure(plastic.metric[c], data.aggregate->size(), c < 3 ? 1 : 0);
    ensure(plastic.equivalentStrain, data.aggregate->size(), 0);
    ensure(plastic.damage, data.aggregate->size(), 0);
}

void setInverseShape(ConnectionData& data, ObjectIndex object, const Mat3& shape)
{
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(shape, Eigen::EigenvaluesOnly);
    Mat3 inverse = Mat3::Zero();
    if (solver.eigenvalues()[0] > flattestShape * solver.eigenvalues()[2])
        inverse = shape.inverse();
    else {
        data.bulk[object] = 0;
        data.flat.push_back(object);
    }
    const double components[] = {inverse(0, 0), inverse(1, 1), inverse(2, 2),
                                 inverse(0, 1), inverse(0, 2), inverse(1, 2)};
    for (std::size_t c = 0; c < 6; ++c)
        data.inverseShape[c][object] = components[c];
    if (data.isRubber(object) && components[0] == 0) {
        data.rubber()->isWhole = false;
        data.rubber()->isRubber[object] = 0;
        data.rubber()->springsAreKnown = false;
    }
}

kernels::TensorLawNumbers tensorNumbers(const ConnectionData& data)
{
    const TensorBody& body = *data.tensors;
    const Material& own = data.materials->materials().front();
    return {.volume = body.volume.data(),
            .shear = numberOf(body.shear, own.shearModulus()),
            .bulk = numberOf(body.bulk, bulkModulusOf(own)),
            .tensionShare = numberOf(body.tensionShare, 1),
            .yieldStress = numberOf(body.yieldStress, yieldStressOf(own)),
            .hardening = numberOf(body.hardening, own.hardening),
            .flowTime = numberOf(body.flowTime, own.relaxationTime),
            .shearDamage = numberOf(body.shearDamage, shearDamageOf(own))};
}

double contactStiffness(const ConnectionData& data, ObjectIndex object)
{
    const double a = data.aggregate->lattice.spacing;
    return contactShare * data.materials->of(object).shearModulus() * data.aggregate->volume[object] / (a * a);
}

} // namespace knead
