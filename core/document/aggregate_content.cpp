#include "core/document/aggregate_content.h"

#include "core/aggregate/aggregate_check.h"
#include "core/message/message.h"
#include "core/skin/former_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace knead {

namespace {

void numbers(ByteWriter& bytes, const std::vector<double>& values, std::size_t count)
{
    bytes.numbers(LaneVector<double>(values.begin(), values.end()), count);
}

void numbers(ByteReader& bytes, std::vector<double>& values, std::size_t count)
{
    LaneVector<double> read;
    bytes.numbers(read, count);
    if (!std::ranges::all_of(read, [](double number) { return std::isfinite(number); }))
        throw Problem(Message("History", "a number of an object is none"));
    values.assign(read.begin(), read.end());
}

template <typename Stream>
void lattice(Stream& bytes, Of<Stream, Lattice>& lattice)
{
    bytes(lattice.origin);
    bytes(lattice.spacing);
    for (Eigen::Index row = 0; row < 3; ++row)
        for (Eigen::Index column = 0; column < 3; ++column)
            bytes(lattice.axes(row, column));
    bytes.list(lattice.nodes, [&](auto& node) {
        for (auto& coordinate : node)
            bytes(coordinate);
    });
}

template <typename Stream>
void skin(Stream& bytes, Of<Stream, std::vector<SkinPoint>>& points)
{
    bytes.list(points, [&](auto& point) {
        bytes(point.place);
        bytes(point.area);
    });
}

template <typename Stream>
void broken(Stream& bytes, Of<Stream, std::vector<BrokenConnection>>& connections)
{
    bytes.list(connections, [&](auto& connection) {
        bytes(connection.direction);
        bytes(connection.lower);
        bytes(connection.cutAt);
    });
}

/// All that is not per object.
template <typename Stream>
void measures(Stream& bytes, Of<Stream, Aggregate>& aggregate)
{
    bytes(aggregate.meshVolume);
    bytes(aggregate.filledVolume);
    bytes(aggregate.cells);
    bytes(aggregate.repair.removedTriangles);
    bytes(aggregate.repair.flippedTriangles);
    bytes(aggregate.repair.decidedCells);
    bytes(aggregate.repair.doubtfulShare);
}

} // namespace

void writeRefilled(ByteWriter& bytes, const Aggregate& aggregate)
{
    const std::size_t count = aggregate.size();
    lattice(bytes, aggregate.lattice);
    measures(bytes, aggregate);
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
        numbers(bytes, aggregate.weight[d], count);
    numbers(bytes, aggregate.volume, count);
    numbers(bytes, aggregate.depth, count);
    bytes.plainList(aggregate.face);
    skin(bytes, aggregate.skin);
    const Aggregate& carriedBy = *aggregate.former->carriers();
    bytes(carriedBy.former != nullptr);
    if (carriedBy.former)
        writeRefilled(bytes, carriedBy);
    const VectorArray carriers(aggregate.former->displacements());
    bytes.numbers(carriers, carriers.size());
    broken(bytes, aggregate.former->broken());
}

namespace {

std::shared_ptr<const Aggregate> readStage(ByteReader& bytes, const std::shared_ptr<const Aggregate>& first,
                                           std::uint32_t version, int stage)
{
    auto aggregate = std::make_shared<Aggregate>();
    lattice(bytes, aggregate->lattice);
    if (!isSound(aggregate->lattice) || aggregate->size() == 0)
        throw Problem(Message("History", "a filling has no lattice"));
    findSegments(aggregate->lattice);
    measures(bytes, *aggregate);
    const std::size_t count = aggregate->size();
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
        numbers(bytes, aggregate->weight[d], count);
        if (!areSoundWeights(aggregate->weight[d], aggregate->lattice, d) || aggregate->weight[d].size() != count)
            throw Problem(Message("History", "a connection of a filling leads nowhere"));
    }
    numbers(bytes, aggregate->volume, count);
    numbers(bytes, aggregate->depth, count);
    bytes.plainList(aggregate->face);
    skin(bytes, aggregate->skin);
    const auto isMaterial = [](double volume) { return volume > 0; };
    if (aggregate->volume.size() != count || aggregate->depth.size() != count || aggregate->face.size() != count ||
        !std::ranges::all_of(aggregate->volume, isMaterial) || !areSoundPoints(aggregate->skin, aggregate->lattice))
        throw Problem(Message("History", "a filling is not as it can be"));
    bool isLater = false;
    if (version >= 9)
        bytes(isLater);
    if (isLater && stage == FormerShape::mostStages)
        throw Problem(Message("History", "a former shape has too many before it"));
    const std::shared_ptr<const Aggregate> carriedBy = isLater ? readStage(bytes, first, version, stage + 1) : first;
    VectorArray carriers;
    bytes.numbers(carriers, carriedBy->size());
    std::vector<Vec3> displacements(carriedBy->size());
    if (carriers.size() != carriedBy->size())
        throw Problem(Message("History", "a former shape has no carriers"));
    for (std::size_t i = 0; i < displacements.size(); ++i) {
        displacements[i] = carriers.at(i);
        if (!displacements[i].allFinite())
            throw Problem(Message("History", "a former shape is none"));
    }
    std::vector<BrokenConnection> parted;
    if (version >= 10)
        broken(bytes, parted);
    if (!areSoundBroken(parted, *carriedBy) || (isLater && !parted.empty()))
        throw Problem(Message("History", "a former shape was parted where it could not be"));
    aggregate->former = std::make_shared<const FormerShape>(carriedBy, std::move(displacements), std::move(parted));
    return aggregate;
}

} // namespace

std::shared_ptr<const Aggregate> readRefilled(ByteReader& bytes, const std::shared_ptr<const Aggregate>& first,
                                              std::uint32_t version)
{
    return readStage(bytes, first, version, 1);
}

} // namespace knead
