#include "io/project/aggregate_bytes.h"

#include "core/aggregate/aggregate_check.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

using Json = nlohmann::json;

Json numbers(const Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

Vec3 vectorIn(const Json& json)
{
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

bool areFinite(const std::vector<double>& numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

Json measuresOf(const Aggregate& aggregate, std::size_t directions)
{
    return {{"directions", directions},
            {"meshVolume", aggregate.meshVolume},
            {"filledVolume", aggregate.filledVolume},
            {"cells", aggregate.cells},
            {"removedTriangles", aggregate.repair.removedTriangles},
            {"flippedTriangles", aggregate.repair.flippedTriangles},
            {"decidedCells", aggregate.repair.decidedCells},
            {"doubtfulShare", aggregate.repair.doubtfulShare},
            {"hasSkin", !aggregate.skin.empty()}};
}

void setMeasures(const Json& json, Aggregate& aggregate)
{
    aggregate.meshVolume = json.at("meshVolume").get<double>();
    aggregate.filledVolume = json.at("filledVolume").get<double>();
    aggregate.cells = json.at("cells").get<std::size_t>();
    aggregate.repair.removedTriangles = json.at("removedTriangles").get<std::size_t>();
    aggregate.repair.flippedTriangles = json.at("flippedTriangles").get<std::size_t>();
    aggregate.repair.decidedCells = json.at("decidedCells").get<std::size_t>();
    aggregate.repair.doubtfulShare = json.at("doubtfulShare").get<double>();
}

std::vector<double> nextNumbers(BlockReader& blocks, std::size_t count)
{
    std::vector<double> numbers = blocks.nextArray<double>();
    if (numbers.size() != count)
        blocks.fail("not every object has all of its numbers");
    if (!areFinite(numbers))
        blocks.fail("a number is not finite");
    return numbers;
}

/// Four numbers per point.
std::vector<SkinPoint> nextSkin(BlockReader& blocks, const Lattice& lattice)
{
    const std::vector<double> numbers = blocks.nextArray<double>();
    if (numbers.size() % 4 != 0 || !areFinite(numbers))
        blocks.fail("a point of its skin is none");
    std::vector<SkinPoint> skin;
    for (std::size_t i = 0; i < numbers.size(); i += 4)
        skin.push_back({{numbers[i], numbers[i + 1], numbers[i + 2]}, numbers[i + 3]});
    if (!areSoundPoints(skin, lattice))
        blocks.fail("a point of its skin is none");
    return skin;
}

void addSkin(const std::vector<SkinPoint>& skin, BlockWriter& blocks)
{
    std::vector<double> numbers;
    for (const SkinPoint& point : skin)
        numbers.insert(numbers.end(), {point.place.x(), point.place.y(), point.place.z(), point.area});
    blocks.add(numbers);
}

Aggregate nextAggregate(BlockReader& blocks)
{
    Aggregate aggregate;
    const Json measures = Json::parse(blocks.next());
    setMeasures(measures, aggregate);
    const auto directions = measures.at("directions").get<std::size_t>();
    if (directions > Lattice::directionCount)
        blocks.fail("there are too many directions");
    aggregate.lattice = nextLattice(blocks);
    if (!isSound(aggregate.lattice))
        blocks.fail("its lattice is none");
    const std::size_t count = aggregate.size();
    aggregate.volume = nextNumbers(blocks, count);
    aggregate.depth = nextNumbers(blocks, count);
    aggregate.face = blocks.nextArray<std::uint32_t>();
    if (aggregate.face.size() != count)
        blocks.fail("not every object has all of its numbers");
    findSegments(aggregate.lattice, directions);
    for (std::size_t d = 0; d < directions; ++d) {
        aggregate.weight[d] = nextNumbers(blocks, count);
        if (!areSoundWeights(aggregate.weight[d], aggregate.lattice, d))
            blocks.fail("a connection leads nowhere");
    }
    if (measures.value("hasSkin", false))
        aggregate.skin = nextSkin(blocks, aggregate.lattice);
    return aggregate;
}

} // namespace

void addLattice(const Lattice& lattice, BlockWriter& blocks)
{
    const Json json{
        {"origin", numbers(lattice.origin)},
        {"spacing", lattice.spacing},
        {"axes", {numbers(lattice.axes.col(0)), numbers(lattice.axes.col(1)), numbers(lattice.axes.col(2))}}};
    blocks.add(std::string_view(json.dump()));
    blocks.add(lattice.nodes);
}

Lattice nextLattice(BlockReader& blocks)
{
    const Json json = Json::parse(blocks.next());
    Lattice lattice;
    lattice.origin = vectorIn(json.at("origin"));
    lattice.spacing = json.at("spacing").get<double>();
    for (int axis = 0; axis < 3; ++axis)
        lattice.axes.col(axis) = vectorIn(json.at("axes").at(static_cast<std::size_t>(axis)));
    lattice.nodes = blocks.nextArray<Lattice::Node>();
    return lattice;
}

std::string aggregateToBytes(const Aggregate& aggregate)
{
    const auto isUsed = [](const std::vector<double>& weights) { return !weights.empty(); };
    const auto last = std::find_if(aggregate.weight.rbegin(), aggregate.weight.rend(), isUsed);
    const auto directions = static_cast<std::size_t>(aggregate.weight.rend() - last);
    BlockWriter blocks;
    blocks.add(std::string_view(measuresOf(aggregate, directions).dump()));
    addLattice(aggregate.lattice, blocks);
    blocks.add(aggregate.volume);
    blocks.add(aggregate.depth);
    blocks.add(aggregate.face);
    for (std::size_t d = 0; d < directions; ++d)
        blocks.add(aggregate.weight[d]);
    if (!aggregate.skin.empty())
        addSkin(aggregate.skin, blocks);
    return std::move(blocks).bytes();
}

Aggregate aggregateFromBytes(std::string_view bytes)
{
    BlockReader blocks(bytes, "aggregate");
    try {
        return nextAggregate(blocks);
    } catch (const Json::exception& error) {
        blocks.fail(error.what());
    }
}

} // namespace knead
