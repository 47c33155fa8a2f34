// A part of the book in Knead: grips are fixtures whose speed is set again and again.
#include "core/aggregate/fill.h"
#include "core/geometry/refine.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/skin_stress.h"
#include "support/shapes.h"
#include "verify/experiment.h"
#include "verify/part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace knead::book {

namespace {

constexpr double frequency = 150;       // of the slowest motion, set by the choice of density [rad/s]
constexpr double fastestDamping = 1000; // of Material::shapeDamping [1/s]

/// Dense enough that the slowest motion has the wanted frequency, and damped so that it dies away at once.
Material slowed(Material material, double slowest)
{
    const double speed = frequency / slowest;
    material.density = std::clamp(material.youngsModulus / (speed * speed), 1.0, 30'000.0);
    const double reached = slowest * material.soundSpeed();
    material.shapeDamping = std::min(fastestDamping, 1.4 * reached);
    return material;
}

/// Fixtures of one grip, and the objects of each.
struct HeldGrip {
    std::size_t grip;
    std::vector<std::vector<ObjectIndex>> objects;
    std::vector<FixtureId> fixtures;
};

class PartRun {
public:
    PartRun(const Part& part, double spacing)
        : m_part(part)
        , m_mesh(shapes::moved(surfaceOf(part.block), part.pose))
        , m_aggregate(std::make_shared<const Aggregate>(fill(m_mesh, {.spacing = spacing})))
        , m_experiment(scene())
    {
        const double reached = part.slowest * m_experiment.simulation().bodies()[0].material.soundSpeed();
        m_period = 2 * pi / reached;
    }

    Outcome run(const Measure& measure)
    {
        std::vector<Finding> findings;
        std::vector<Curve> curves = emptyCurves();
        double share = 0;
        for (const Stage& stage : m_part.stages) {
            load(share, stage.share, curves);
            share = stage.share;
            for (const std::size_t grip : stage.released)
                release(grip);
            if (stage.withoutTools)
                for (ToolId tool = 0; tool < m_part.tools.size(); ++tool)
                    m_experiment.simulation().post(RemoveManipulator{tool});
            m_experiment.settle(m_experiment.time() + m_part.restPeriods * m_period, m_period / 3);
            findings.push_back(finding(stage.withoutTools));
        }
        Outcome outcome = m_experiment.outcome(measure(findings), m_mesh);
        std::erase_if(curves, [](const Curve& curve) { return curve.points.size() < 3; });
        outcome.curves = std::move(curves);
        outcome.curveAxes = "share of the load;force [N]";
        return outcome;
    }

private:
    Vec3 localRest(ObjectIndex i) const { return m_part.pose.toLocal(m_aggregate->lattice.position(i)); }

    Scene scene()
    {
        Scene scene;
        scene.bodies.push_back(
            {.name = "part", .aggregate = m_aggregate, .material = slowed(m_part.material, m_part.slowest)});
        const double density = scene.bodies[0].material.density;
        scene.gravity = m_part.weighs / density * (m_part.pose.rotation * m_part.gravity);
        for (std::size_t g = 0; g < m_part.grips.size(); ++g)
            addGrip(scene, g);
        for (const Tool& tool : m_part.tools) {
            scene.manipulators.push_back(tool.manipulator);
            scene.manipulators.back().speedLimit = 100;
            scene.manipulators.back().pose = posed(tool.manipulator.pose);
        }
        return scene;
    }

    Pose posed(const Pose& pose) const
    {
        return {m_part.pose.toWorld(pose.position), m_part.pose.rotation * pose.rotation};
    }

    /// Objects with the same key are one fixture.
    std::array<long, 4> keyOf(const Grip& grip, ObjectIndex i) const
    {
        if (grip.together == Grip::Together::all)
            return {};
        if (grip.together == Grip::Together::none)
            return {i, 0, 0, 0};
        const Vec3 place = localRest(i);
        const Vec3 path = (grip.path(place, 1) + 0.3 * grip.path(place, 0.5)) / (1e-7 * m_aggregate->lattice.spacing);
        return {std::lround(path.x()), std::lround(path.y()), std::lround(path.z()), 1};
    }

    void addGrip(Scene& scene, std::size_t index)
    {
        const Grip& grip = m_part.grips[index];
        HeldGrip held{.grip = index, .objects = {}, .fixtures = {}};
        std::map<std::array<long, 4>, std::size_t> known;
        for (ObjectIndex i = 0; i < m_aggregate->size(); ++i) {
            if (grip.program == Grip::Program::calculix ||
                grip.zone(localRest(i)) > 0.5 * m_aggregate->lattice.spacing + 1e-9)
                continue;
            const auto [entry, isNew] = known.try_emplace(keyOf(grip, i), held.objects.size());
            if (isNew)
                held.objects.emplace_back();
            held.objects[entry->second].push_back(i);
        }
        for (const std::vector<ObjectIndex>& objects : held.objects) {
            held.fixtures.push_back(static_cast<FixtureId>(scene.fixtures.size()));
            scene.fixtures.push_back({"grip", 0, objects, Vec3::Zero()});
        }
        m_grips.push_back(std::move(held));
    }

    /// Sets the speeds with which grips and tools get from share `from` to `to`, and lets time pass.
    void load(double from, double to, std::vector<Curve>& curves)
    {
        if (from == to)
            return;
        Simulation& simulation = m_experiment.simulation();
        const double begin = simulation.time();
        const double duration = m_part.loadPeriods * m_period;
        for (ToolId t = 0; t < m_part.tools.size(); ++t) {
            const Pose pose = posed(m_part.tools[t].manipulator.pose);
            const Vec3 way = m_part.pose.rotation * m_part.tools[t].way;
            simulation.post(SetManipulatorMotion{
                t, gentleWay({pose.position + from * way, pose.rotation}, (to - from) * way, begin, begin + duration)});
        }
        double share = from;
        for (int s = 1; s <= m_part.segments; ++s) {
            const double next = from + (to - from) * gentle(static_cast<double>(s) / m_part.segments);
            const double end = begin + duration * s / m_part.segments;
            const double wanted = end - simulation.time();
            const double steps = std::max(1.0, std::ceil(wanted / simulation.timeStep()));
            setSpeeds(share, next, steps * simulation.timeStep());
            m_experiment.runUntil(simulation.time() + (steps - 0.5) * simulation.timeStep());
            share = next;
            extend(curves, share);
        }
        setSpeeds(share, share, 1);
    }

    void setSpeeds(double from, double to, double duration)
    {
        for (const HeldGrip& held : m_grips) {
            const Grip& grip = m_part.grips[held.grip];
            for (std::size_t k = 0; k < held.fixtures.size(); ++k) {
                const Vec3 place = localRest(held.objects[k].front());
                const Vec3 way = grip.path(place, to) - grip.path(place, from);
                if (way == Vec3::Zero() && from != to)
                    continue; // it only holds
                m_experiment.simulation().post(MoveFixture{held.fixtures[k], m_part.pose.rotation * way / duration});
            }
        }
    }

    void release(std::size_t grip)
    {
        for (HeldGrip& held : m_grips)
            if (held.grip == grip) {
                for (const FixtureId fixture : held.fixtures)
                    m_experiment.simulation().post(RemoveFixture{fixture});
                held.objects.clear();
                held.fixtures.clear();
            }
    }

    Finding finding(bool withoutTools)
    {
        const std::vector<Vec3> toolForces =
            withoutTools || m_part.tools.empty() ? std::vector<Vec3>{} : m_experiment.meanToolForces(0.1 * m_period);
        const auto shot = m_experiment.simulation().snapshot();
        const Quaternion back = m_part.pose.rotation.conjugate();
        Finding found;
        found.spacing = m_aggregate->lattice.spacing;
        found.elasticEnergy = shot->energy.elastic;
        for (const Vec3& force : toolForces)
            found.toolForces.push_back(back * force);
        const std::vector<Vec3> displacements = shot->bodies[0].displacements();
        for (ObjectIndex i = 0; i < m_aggregate->size(); ++i) {
            found.rest.push_back(localRest(i));
            found.displacement.push_back(back * displacements[i]);
        }
        found.reactions.resize(m_part.grips.size());
        for (const HeldGrip& held : m_grips)
            for (std::size_t k = 0; k < held.fixtures.size(); ++k) {
                const auto place = std::find(shot->fixtureIds.begin(), shot->fixtureIds.end(), held.fixtures[k]);
                const auto row = static_cast<std::size_t>(place - shot->fixtureIds.begin());
                if (row >= shot->fixtureForces.size())
                    continue;
                PointForce sum{Vec3::Zero(), Vec3::Zero(), back * shot->fixtureForces[row]};
                for (const ObjectIndex i : held.objects[k]) {
                    sum.place += found.rest[i] / static_cast<double>(held.objects[k].size());
                    sum.now += (found.rest[i] + found.displacement[i]) / static_cast<double>(held.objects[k].size());
                }
                found.reactions[held.grip].push_back(sum);
            }
        found.vonMises = skinStress(*shot);
        return found;
    }

    /// What a person sees at the vertex of the skin next to a point.
    std::function<double(const Vec3&)> skinStress(const Snapshot& shot) const
    {
        const Snapshot::BodyState& body = shot.bodies[0];
        return [skin = refine(m_mesh, m_aggregate->lattice.spacing), aggregate = m_aggregate, pose = m_part.pose,
                displacements = body.displacements(), relaxed = body.relaxed, loaded = loadedObjects(shot, 0),
                stresses = std::make_shared<SkinStresses>()](const Vec3& place) {
            const Vec3 world = pose.toWorld(place);
            std::size_t nearest = 0;
            for (std::size_t v = 0; v < skin.vertices.size(); ++v)
                if ((skin.vertices[v] - world).squaredNorm() < (skin.vertices[nearest] - world).squaredNorm())
                    nearest = v;
            if (stresses->vonMises.empty()) // all at once, when the first is asked for
                *stresses = SkinStress(*aggregate, skin)
                                .stresses(ObjectStrains(*aggregate, displacements, *relaxed), loaded, false);
            return static_cast<double>(stresses->vonMises[nearest]);
        };
    }

    std::vector<Curve> emptyCurves() const
    {
        std::vector<Curve> curves;
        for (std::size_t g = 0; g < m_part.grips.size(); ++g)
            curves.push_back({"grip " + std::to_string(g + 1), {{0, 0}}});
        for (std::size_t t = 0; t < m_part.tools.size(); ++t)
            curves.push_back({"tool " + std::to_string(t + 1), {{0, 0}}});
        return curves;
    }

    void extend(std::vector<Curve>& curves, double share)
    {
        const auto shot = m_experiment.simulation().snapshot();
        std::vector<Vec3> sums(m_part.grips.size(), Vec3::Zero());
        for (const HeldGrip& held : m_grips)
            for (const FixtureId fixture : held.fixtures)
                for (std::size_t row = 0; row < shot->fixtureIds.size(); ++row)
                    if (shot->fixtureIds[row] == fixture)
                        sums[held.grip] += shot->fixtureForces[row];
        for (std::size_t g = 0; g < sums.size(); ++g)
            if (sums[g].norm() > 0)
                curves[g].points.push_back({share, sums[g].norm()});
        for (std::size_t t = 0; t < shot->tools.size(); ++t)
            curves[sums.size() + t].points.push_back({share, shot->tools[t].force.norm()});
    }

    const Part& m_part;
    TriangleMesh m_mesh;
    std::shared_ptr<const Aggregate> m_aggregate;
    std::vector<HeldGrip> m_grips; // filled by scene(), which the next one is made of
    Experiment m_experiment;
    double m_period = 0;
};

} // namespace

Outcome runKnead(const Part& part, double spacing, const Measure& measure)
{
    return guarded(0, [&] { return PartRun(part, spacing).run(measure); });
}

} // namespace knead::book
