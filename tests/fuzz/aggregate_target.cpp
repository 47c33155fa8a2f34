#include "core/aggregate/fill.h"
#include "core/aggregate/published_fill.h"
#include "fuzz/targets.h"
#include "io/project/aggregate_bytes.h"
#include "support/shapes.h"

namespace knead::fuzz {

namespace {

std::vector<std::string> aggregates()
{
    return {
        aggregateToBytes(fill(shapes::moved(shapes::box({0.01, 0.01, 0.02}), shapes::tilt(0.3)), {.spacing = 0.004})),
        aggregateToBytes(fill(shapes::bracket(0.03, 0.01, 0.01), {.spacing = 0.005})),
        aggregateToBytes(fillAsPublished(shapes::box({0.01, 0.01, 0.02}), 0.005)),
        aggregateToBytes({.lattice = {.spacing = 1}})};
}

bool readAggregate(std::string_view bytes)
{
    return isTaken([&] { requireSameBack(aggregateFromBytes(bytes), aggregateToBytes, aggregateFromBytes); });
}

} // namespace

Target aggregateTarget()
{
    return {aggregates, readAggregate};
}

} // namespace knead::fuzz
