#include "core/mechanics/contact_batch.h"

#include "core/mechanics/blade.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

using kernels::effectSize;
using kernels::motionSize;

constexpr std::uint32_t none = 0xffffffffU;

void write(const Vec3& from, double (&to)[3])
{
    std::copy_n(from.data(), 3, to);
}

/// None where the distance is no formula.
std::optional<kernels::SurfaceForm> formOf(const RigidSurface& surface)
{
    using kernels::SurfaceForm;
    if (surface.isFloor)
        return SurfaceForm::floor;
    switch (surface.shape.kind) {
    case ToolKind::ball:
        return SurfaceForm::ball;
    case ToolKind::cylinder:
        return SurfaceForm::cylinder;
    case ToolKind::box:
    case ToolKind::plate:
        return SurfaceForm::box;
    case ToolKind::wedge:
    case ToolKind::part:
        break;
    }
    return std::nullopt;
}

std::optional<kernels::PlacedForm> formOf(const PlacedSurface& surface)
{
    const std::optional<kernels::SurfaceForm> known = formOf(*surface);
    if (!known)
        return std::nullopt;
    kernels::PlacedForm form{};
    form.form = *known;
    write(surface->shape.size / 2, form.half);
    std::copy_n(surface.rotation().data(), 9, form.rotation);
    write(surface->pose.position, form.center);
    return form;
}

Vec3 vectorAt(const double* numbers)
{
    return {numbers[0], numbers[1], numbers[2]};
}

} // namespace

bool ContactBatch::takesLittle(const RigidSurface& surface)
{
    return formOf(surface) && surface.adhesion == 0 && (surface.isFloor || !bladeOf(surface.shape));
}

ContactBatch::Block::Block(std::size_t count)
{
    for (std::array<LaneVector<double>, 3>* vectors : {&place, &velocity, &normal})
        for (LaneVector<double>& column : *vectors)
            column.resize(count);
    distance.resize(count);
    overlap.resize(count);
    effects.resize(count * effectSize);
}

ContactBatch::ContactBatch(std::span<const ContactBody> bodies, std::span<const Point> points,
                           const kernels::Kernels& run)
    : m_points(points.begin(), points.end())
    , m_run(&run)
{
    constexpr std::uint32_t carries = 0;
    std::vector<std::vector<std::uint32_t>> numbers(bodies.size()); // per body and object, into m_objects
    for (const Point& point : m_points) {
        numbers[point.body].resize(bodies[point.body].state->size(), none);
        for (std::uint32_t n = 0; n < point.spread->count; ++n)
            numbers[point.body][point.spread->objects[n]] = carries;
    }
    for (std::uint32_t body = 0; body < numbers.size(); ++body)
        for (ObjectIndex object = 0; object < numbers[body].size(); ++object)
            if (numbers[body][object] != none) {
                numbers[body][object] = static_cast<std::uint32_t>(m_objects.size());
                m_objects.push_back({body, object});
            }
    std::size_t grouped = 0;
    while (grouped < m_points.size())
        grouped = addGroup(grouped, numbers);
    fillColumns();
    std::size_t most = 0;
    for (const Stretch& stretch : m_stretches)
        most = std::max(most, stretch.pointCount);
    m_block = Block((most + laneCount - 1) / laneCount * laneCount);
    m_motions.resize(m_objects.size() * motionSize);
    m_effects.resize(m_objects.size() * effectSize);
}

/// Of the points from `first` on that the same objects carry. None is divided between blocks, and what a single object carries is a
/// group of its own: how sums begin must not depend on what else is listed. @return the first point behind
std::size_t ContactBatch::addGroup(std::size_t first, const std::vector<std::vector<std::uint32_t>>& numbers)
{
    const Point& self = m_points[first];
    const PointSpread& spread = *self.spread;
    std::size_t end = first + 1;
    while (spread.count > 1 && end < m_points.size() && m_points[end].body == self.body &&
           m_points[end].spread->count == spread.count && m_points[end].spread->objects == spread.objects)
        ++end;
    if (m_stretches.empty() || m_stretches.back().pointCount + (end - first) > blockSize)
        m_stretches.push_back({.firstPoint = first, .firstColumn = columnCount(), .firstGroup = m_groups.size()});
    Stretch& stretch = m_stretches.back();
    kernels::PointGroup group{.begin = static_cast<std::uint32_t>(stretch.pointCount),
                              .end = static_cast<std::uint32_t>(stretch.pointCount + (end - first)),
                              .weights = static_cast<std::uint32_t>(m_weights.size()),
                              .count = spread.count,
                              .objects = {}};
    for (std::uint32_t n = 0; n < spread.count; ++n)
        group.objects[n] = numbers[self.body][spread.objects[n]];
    m_groups.push_back(group);
    ++stretch.groupCount;
    stretch.pointCount += end - first;
    for (std::size_t p = first; p < end; ++p) {
        const auto& weights = m_points[p].spread->weights;
        m_weights.insert(m_weights.end(), weights.begin(), weights.begin() + spread.count);
    }
    return end;
}

/// So far.
std::size_t ContactBatch::columnCount() const
{
    if (m_stretches.empty())
        return 0;
    const Stretch& last = m_stretches.back();
    return last.firstColumn + (last.pointCount + laneCount - 1) / laneCount * laneCount;
}

template <typename With>
void ContactBatch::forEachPoint(const With& with) const
{
    for (const Stretch& stretch : m_stretches)
        for (std::size_t p = 0; p < stretch.pointCount; ++p)
            with(m_points[stretch.firstPoint + p], stretch.firstColumn + p);
}

void ContactBatch::fillColumns()
{
    for (LaneVector<double>* column :
         {&m_weightSum, &m_reach, &m_stiffness, &m_damping, &m_friction, &m_inverseStiffening, &m_steepest, &m_mass,
          &m_largestOverlap, &m_kept, &m_keptApart, &m_hold[0], &m_hold[1], &m_hold[2], &m_pressure})
        column->resize(columnCount());
    forEachPoint([this](const Point& point, std::size_t at) {
        m_weightSum[at] = point.spread->weightSum();
        m_reach[at] = point.reach;
        m_stiffness[at] = point.parameters.stiffness;
        m_damping[at] = point.parameters.damping;
        m_friction[at] = point.parameters.friction;
        m_inverseStiffening[at] = 1 / point.parameters.stiffening;
        m_steepest[at] = point.parameters.steepest;
        m_mass[at] = point.parameters.mass;
        m_largestOverlap[at] = point.parameters.largestOverlap;
        for (std::size_t c = 0; c < 3; ++c)
            m_hold[c][at] = point.friction->hold.data()[c];
        m_pressure[at] = point.friction->pressure;
    });
}

void ContactBatch::writeBack() const
{
    forEachPoint([this](const Point& point, std::size_t at) {
        *point.friction = {.hold = {m_hold[0][at], m_hold[1][at], m_hold[2][at]}, .pressure = m_pressure[at]};
    });
}

void ContactBatch::keepPressures(const ContactStep& step)
{
    if (step.duration == m_duration)
        return;
    m_duration = step.duration;
    double delay = -1; // most points have that of the one before
    double kept = 0;
    double keptApart = 0;
    forEachPoint([&](const Point& point, std::size_t at) {
        if (point.parameters.frictionDelay != delay) {
            delay = point.parameters.frictionDelay;
            kept = pressureKept(point.parameters, step);
            keptApart = pressureKeptApart(point.parameters, step);
        }
        m_kept[at] = kept;
        m_keptApart[at] = keptApart;
    });
}

void ContactBatch::readMotions(std::span<const ContactBody> bodies)
{
    for (std::size_t n = 0; n < m_objects.size(); ++n) {
        const ObjectState& state = *bodies[m_objects[n].body].state;
        const Vec3 place = state.position.at(m_objects[n].object);
        const Vec3 velocity = state.velocity.at(m_objects[n].object);
        std::copy_n(place.data(), 3, &m_motions[n * motionSize]);
        std::copy_n(velocity.data(), 3, &m_motions[n * motionSize + 3]);
    }
}

void ContactBatch::pressBlock(const Stretch& stretch, const PlacedSurface& surface,
                              const std::optional<kernels::PlacedForm>& form, const ContactStep& step,
                              ContactReport& report)
{
    const kernels::Kernels& run = *m_run;
    Block& b = m_block;
    const std::size_t begin = stretch.firstColumn;
    const std::size_t count = stretch.pointCount;
    const kernels::CarriedPoints carried{stretch.groupCount, &m_groups[stretch.firstGroup], m_weights.data()};
    kernels::ContactColumns columns{};
    columns.count = count;
    columns.duration = step.duration;
    std::copy_n(surface.rotation().data(), 9, columns.rotation);
    write(surface->pose.position, columns.center);
    write(surface->velocity, columns.surfaceVelocity);
    write(surface->angularVelocity, columns.angularVelocity);
    columns.overlap = b.overlap.data();
    columns.weightSum = &m_weightSum[begin];
    columns.stiffness = &m_stiffness[begin];
    columns.damping = &m_damping[begin];
    columns.friction = &m_friction[begin];
    columns.inverseStiffening = &m_inverseStiffening[begin];
    columns.steepest = &m_steepest[begin];
    columns.mass = &m_mass[begin];
    columns.largestOverlap = &m_largestOverlap[begin];
    columns.kept = &m_kept[begin];
    columns.keptApart = &m_keptApart[begin];
    columns.pressure = &m_pressure[begin];
    for (std::size_t c = 0; c < 3; ++c) {
        columns.place[c] = b.place[c].data();
        columns.velocity[c] = b.velocity[c].data();
        columns.normal[c] = b.normal[c].data();
        columns.hold[c] = &m_hold[c][begin];
    }
    columns.effects = b.effects.data();

    run.gatherPoints(carried, m_motions.data(),
                     {b.place[0].data(), b.place[1].data(), b.place[2].data(), b.velocity[0].data(),
                      b.velocity[1].data(), b.velocity[2].data()});
    if (form)
        run.nearestOfForm(*form, count, columns.place, b.distance.data(),
                          {b.normal[0].data(), b.normal[1].data(), b.normal[2].data()});
    else
        for (std::size_t p = 0; p < count; ++p) {
            const SurfacePoint nearest = surface.nearest({b.place[0][p], b.place[1][p], b.place[2][p]});
            b.distance[p] = nearest.distance;
            for (std::size_t c = 0; c < 3; ++c)
                b.normal[c][p] = nearest.normal.data()[c];
        }
    for (std::size_t p = 0; p < count; ++p)
        b.overlap[p] = m_reach[begin + p] - b.distance[p];
    std::fill(b.overlap.begin() + static_cast<std::ptrdiff_t>(count), b.overlap.end(), -1.0);
    const kernels::ContactTotals totals = run.contactLaw(columns);
    report.count += totals.touching;
    report.steepness = std::max(report.steepness, totals.steepness);
    run.scatterEffects(carried, columns.overlap, columns.effects, m_effects.data());
}

/// A point's velocity, force and torque are the sums of those of the objects that carry it, of the surface's velocity at the place, too.
void ContactBatch::giveToObjects(std::span<const ContactBody> bodies, const RigidSurface& surface, ContactCrowd& crowd,
                                 SurfaceLoad& load, ContactReport& report)
{
    report.frictions.reserve(report.frictions.size() + m_objects.size());
    SurfaceLoad sum;
    double energy = 0;
    double braking = 0;
    for (std::size_t n = 0; n < m_objects.size(); ++n) {
        double* const effect = &m_effects[n * effectSize];
        if (effect[kernels::isTouched] == 0)
            continue;
        const ObjectRef& object = m_objects[n];
        const Vec3 spring = vectorAt(effect + kernels::springForce);
        const Vec3 damping = vectorAt(effect + kernels::dampingForce);
        const Vec3 friction = vectorAt(effect + kernels::frictionForce);
        const Vec3 arm = vectorAt(&m_motions[n * motionSize]) - surface.pose.position;
        const Vec3 surfaceVelocity = surface.velocity + surface.angularVelocity.cross(arm);
        ObjectState& state = *bodies[object.body].state;
        state.force.add(object.object, spring);
        state.damping.add(object.object, damping);
        const Vec3 force = spring + damping;
        sum.force -= force;
        sum.torque -= arm.cross(force);
        sum.power += force.dot(surfaceVelocity);
        energy += effect[kernels::storedEnergy];
        braking += damping.dot(surfaceVelocity);
        if (!friction.isZero(0))
            report.frictions.push_back({.object = object, .force = friction, .velocity = surfaceVelocity});
        if (effect[kernels::addedSlope] > 0)
            crowd.add(bodies[object.body], object.body, object.object, effect[kernels::addedSlope]);
        std::fill_n(effect, effectSize, 0.0);
    }
    load.force += sum.force;
    load.torque += sum.torque;
    load.power += sum.power;
    report.energy += energy;
    report.brakingPower -= braking;
}

void ContactBatch::press(std::span<const ContactBody> bodies, const PlacedSurface& surface, const ContactStep& step,
                         ContactCrowd& crowd, SurfaceLoad& load, ContactReport& report)
{
    keepPressures(step);
    readMotions(bodies);
    const std::size_t touchedBefore = report.count;
    const std::optional<kernels::PlacedForm> form = formOf(surface);
    for (const Stretch& stretch : m_stretches)
        pressBlock(stretch, surface, form, step, report);
    if (report.count > touchedBefore)
        giveToObjects(bodies, *surface, crowd, load, report);
}

} // namespace knead
