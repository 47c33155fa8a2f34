#pragma once

#include "core/geometry/turn.h"
#include "core/session/sculpting.h"
#include "support/soak_document.h"

#include <array>
#include <functional>
#include <numbers>
#include <optional>

namespace knead::soak {

/// What a hand does to a document at random: strokes of all brushes, tools, knives, fixtures, loads and settings. The same for the
/// same seed. Undo, files and the like are not the hand's.
class Hand {
public:
    /// @param materials to choose from. All outlive it.
    Hand(Document& document, const std::vector<Material>& materials, fuzz::Random& random, Findings& findings)
        : m_document(document)
        , m_materials(materials)
        , m_random(random)
        , m_findings(findings)
    {
    }

    /// One gesture, an entry of the history. @return its name
    std::string gesture()
    {
        struct Kind {
            std::size_t weight;
            const char* name;
            void (Hand::*act)();
        };
        constexpr std::array kinds{Kind{44, "stroke", &Hand::stroke},     Kind{10, "press", &Hand::press},
                                   Kind{5, "knife", &Hand::knife},        Kind{3, "cut", &Hand::cut},
                                   Kind{6, "material", &Hand::material},  Kind{4, "refill", &Hand::refill},
                                   Kind{8, "fixture", &Hand::fixture},    Kind{5, "world", &Hand::world},
                                   Kind{4, "load", &Hand::load},          Kind{3, "scheme", &Hand::scheme},
                                   Kind{4, "body", &Hand::body},          Kind{2, "balance", &Hand::balance},
                                   Kind{1, "reset", &Hand::reset},        Kind{8, "wait", &Hand::wait},
                                   Kind{3, "tool", &Hand::toolsThatStay}, Kind{2, "names", &Hand::names}};
        std::size_t all = 0;
        for (const Kind& kind : kinds)
            all += kind.weight;
        std::size_t chosen = m_random.below(all);
        const Kind* kind = kinds.data();
        for (; chosen >= kind->weight; ++kind)
            chosen -= kind->weight;
        m_findings.count(kind->name);
        (this->*kind->act)();
        m_document.endGesture(kind->name);
        return kind->name;
    }

    double number(double low, double high)
    {
        return low + (high - low) * static_cast<double>(m_random.below(1 << 20)) / (1 << 20);
    }

private:
    Vec3 direction()
    {
        const double z = number(-1, 1);
        const double around = number(0, 2 * std::numbers::pi);
        const double across = std::sqrt(std::max(0.0, 1 - z * z));
        return {across * std::cos(around), across * std::sin(around), z};
    }

    BodyId someBody() { return static_cast<BodyId>(m_random.below(m_document.now().bodies.size())); }
    double size() const { return m_document.content().box.sizes().maxCoeff(); } ///< of all bodies [m]

    /// Some place that is drawn.
    SurfaceSpot someSpot(BodyId body, double radius)
    {
        const RenderMesh& mesh = m_document.frame().filled[body]->render;
        return spotAt(body, static_cast<std::uint32_t>(m_random.below(mesh.triangles.size())), radius);
    }

    SurfaceSpot spotAt(BodyId body, std::uint32_t triangle, double radius) const
    {
        const RenderMesh& mesh = m_document.frame().filled[body]->render;
        return surfaceSpot(mesh.triangles, m_document.frame().bodies[body]->points, triangle, middle(body, triangle),
                           radius);
    }

    Vec3 middle(BodyId body, std::uint32_t triangle) const
    {
        const BodyFrame& drawn = *m_document.frame().bodies[body];
        const auto& corners = m_document.frame().filled[body]->render.triangles[triangle];
        return (drawn.point(corners[0]) + drawn.point(corners[1]) + drawn.point(corners[2])) / 3;
    }

    SurfaceSpot spotNear(BodyId body, const Vec3& place, double radius) const
    {
        const std::size_t count = m_document.frame().filled[body]->render.triangles.size();
        std::uint32_t nearest = 0;
        for (std::uint32_t t = 1; t < count; ++t)
            if ((middle(body, t) - place).squaredNorm() < (middle(body, nearest) - place).squaredNorm())
                nearest = t;
        return spotAt(body, nearest, radius);
    }

    std::vector<ObjectIndex> objectsAround(BodyId body, const Vec3& place, double radius) const
    {
        const std::vector<Vec3>& positions = m_document.now().bodies[body].positions;
        std::vector<ObjectIndex> objects;
        for (ObjectIndex i = 0; i < positions.size(); ++i)
            if ((positions[i] - place).norm() < radius)
                objects.push_back(i);
        return objects;
    }

    bool play(double duration)
    {
        bool goesOn = true;
        for (double time = 0; time < duration && goesOn; time += Document::frameTime)
            goesOn = m_document.step();
        return goesOn;
    }

    void stroke()
    {
        m_document.draw();
        const BodyId body = someBody();
        SculptChoice choice;
        choice.brush = static_cast<SculptBrush>(m_random.below(sculptBrushCount));
        choice.radius = number(0.06, 0.3) * size();
        choice.strength = std::exp(number(-1.2, 1.2));
        for (bool& isMirrored : choice.mirrored)
            isMirrored = m_random.chance(12);
        choice.middle = m_document.content().box.center();
        choice.holdsRest = m_random.chance(70);
        choice.speed = number(0.03, 0.3);
        const SurfaceSpot spot = someSpot(body, choice.radius);
        const Vec3 right = spot.normal.unitOrthogonal();
        SculptStroke stroke(choice, body, m_document.now(), spot, right);
        if (stroke.isEmpty())
            return;
        m_document.postAll(stroke.begin());
        const double goesBy = number(0.1, 0.9); // [s] that the hand moves
        const Vec3 way = number(0.05, 0.6) * size() * direction();
        Vec3 hand = spot.place;
        for (double time = 0; time < goesBy; time += Document::frameTime) {
            hand += way * Document::frameTime / goesBy;
            stroke.moveTo(hand);
            if (usesFingers(choice.brush))
                stroke.moveTo(spotNear(body, hand, choice.radius));
            if (m_random.chance(2))
                stroke.strengthen(std::exp(number(-0.5, 0.5)));
            if (!m_document.step())
                return;
            m_document.postAll(stroke.follow(m_document.now(), true));
        }
        if (m_random.chance(8)) {
            m_document.postAll(stroke.abandon(m_document.now(), true));
            m_document.apply();
            return;
        }
        m_document.postAll(stroke.release(m_document.now(), true));
        for (int n = 0; n < 200 && !stroke.isOver(); ++n) {
            if (!m_document.step())
                return;
            m_document.postAll(stroke.follow(m_document.now(), true));
        }
        m_document.step();
        if (!stroke.isOver())
            m_findings.count("told: a finger was not gone after 200 frames");
    }

    Manipulator someTool(const SurfaceSpot& spot)
    {
        constexpr std::array kinds{ToolKind::ball, ToolKind::cylinder, ToolKind::box, ToolKind::plate, ToolKind::wedge};
        Manipulator tool{.name = "tool"};
        tool.kind = kinds[m_random.below(kinds.size())];
        const double x = number(0.1, 0.5) * size();
        const double y = number(0.1, 0.5) * size();
        const double z = tool.kind == ToolKind::plate ? 0.05 * size() : number(0.1, 0.5) * size();
        tool.size = fittingSize(tool.kind, Vec3(x, y, z));
        tool.pose.rotation = turnOnto(Vec3::UnitZ(), direction());
        tool.friction = number(0, 1);
        tool.forceLimit = m_random.chance(92) ? std::exp(number(0, 4)) : std::numeric_limits<double>::infinity();
        tool.speedLimit = number(0.03, 0.4);
        tool.adhesion = m_random.chance(15) ? std::exp(number(4, 9)) : 0;
        tool.rollsFreely = m_random.chance(25);
        tool.pose = pressPoses(tool.shape(), tool.pose.rotation, spot.place, spot.normal, 0.03 * size()).away;
        return tool;
    }

    /// Posts that a tool goes there, and lets it. @return whether time goes on
    bool go(ToolId id, const Manipulator& tool, const Pose& from, const Pose& to)
    {
        m_document.post(SetManipulatorMotion{id, GoTo{to}});
        return play(std::min(1.5, (to.position - from.position).norm() / tool.speedLimit + 0.1));
    }

    void press()
    {
        m_document.draw();
        const SurfaceSpot spot = someSpot(someBody(), 0.05 * size());
        const Manipulator tool = someTool(spot);
        const ToolId id = m_document.now().nextTool;
        m_document.post(AddManipulator{tool});
        Pose deep = tool.pose;
        deep.position -= (0.03 + number(0.02, 0.4)) * size() * spot.normal;
        Pose dragged = deep;
        dragged.position += number(0, 0.3) * size() * direction();
        if (go(id, tool, tool.pose, deep) && go(id, tool, deep, dragged) && go(id, tool, dragged, tool.pose))
            m_document.post(RemoveManipulator{id});
        m_document.step();
    }

    /// Through a body, or part of the way.
    void knife()
    {
        m_document.draw();
        const BodyId body = someBody();
        const SurfaceSpot spot = someSpot(body, 0.05 * size());
        if (m_document.now().materials[body].toughness == 0 && m_random.chance(80)) {
            Material material = m_document.now().materials[body];
            material.toughness = std::exp(number(1, 7));
            m_document.post(SetMaterial{body, material});
        }
        Manipulator tool{.name = "knife", .size = Vec3(1.5, 0.03, 0.6) * size()};
        tool.kind = ToolKind::wedge;
        if (m_random.chance(25)) {
            tool.kind = ToolKind::cylinder;
            tool.size = Vec3(0.015, 0.015, 1.5) * size();
        }
        tool.friction = number(0, 0.4);
        tool.speedLimit = number(0.05, 0.3);
        tool.pose = pressPoses(tool.shape(),
                               Quaternion(Eigen::AngleAxisd(number(0, std::numbers::pi), spot.normal)) *
                                   turnOnto(-Vec3::UnitZ(), -spot.normal),
                               spot.place, spot.normal, 0.02 * size())
                        .away;
        const ToolId id = m_document.now().nextTool;
        m_document.post(AddManipulator{tool});
        Pose deep = tool.pose;
        deep.position -= number(0.05, 0.9) * size() * spot.normal;
        if (go(id, tool, tool.pose, deep) && go(id, tool, deep, tool.pose))
            m_document.post(RemoveManipulator{id});
        m_document.step();
    }

    void cut()
    {
        m_document.draw();
        const BodyId body = someBody();
        m_document.post(Cut{.body = body, .point = someSpot(body, 0.05 * size()).place, .normal = direction()});
        play(number(0, 0.3));
    }

    void material()
    {
        const BodyId body = someBody();
        Material chosen = m_random.oneOf(m_materials);
        if (m_random.chance(30)) // glue, or clay that heals
            chosen.adhesion = std::exp(number(3, 10));
        if (m_random.chance(15))
            chosen.healingTime = number(0.01, 1);
        std::vector<ObjectIndex> objects;
        if (m_random.chance(25)) {
            m_document.draw();
            objects = objectsAround(body, someSpot(body, 0.05 * size()).place, number(0.1, 0.4) * size());
        }
        m_document.post(SetMaterial{body, chosen, std::move(objects)});
        play(number(0, 0.2));
    }

    void refill()
    {
        const BodyId body = someBody();
        const double spacing = m_document.now().bodies[body].aggregate->lattice.spacing;
        m_document.post(Refill{.body = body, .spacing = m_random.chance(60) ? 0 : number(0.85, 1.3) * spacing});
        play(number(0, 0.2));
    }

    void fixture()
    {
        const auto& ids = m_document.now().fixtureIds;
        if (!ids.empty() && m_random.chance(ids.size() > 2 ? 80 : 45)) {
            const FixtureId id = m_random.oneOf(ids);
            if (m_random.chance(60)) {
                m_document.post(RemoveFixture{id});
            } else {
                MoveFixture move{id, number(0, 0.05) * direction()};
                if (m_random.chance(50))
                    move.turn = {m_document.content().box.center(), number(0, 5) * direction(), number(0.01, 0.5)};
                m_document.post(move);
                play(number(0.05, 0.4));
                m_document.post(MoveFixture{id});
            }
        } else {
            m_document.draw();
            const BodyId body = someBody();
            const Vec3 place = someSpot(body, 0.05 * size()).place;
            std::vector<ObjectIndex> objects = objectsAround(body, place, number(0.05, 0.25) * size());
            m_document.post(AddFixture{{"fixture", body, std::move(objects)}});
        }
        m_document.step();
    }

    void world()
    {
        if (m_random.chance(50)) {
            m_document.post(SetGravity{m_random.chance(60) ? Vec3(0, 0, -9.81) : number(0, 20) * direction()});
        } else {
            SetFloor floor{.friction = number(0, 1), .adhesion = m_random.chance(20) ? std::exp(number(3, 8)) : 0};
            if (m_random.chance(75))
                floor.height = m_document.content().box.min().z() - number(0, 0.05) * size();
            m_document.post(floor);
        }
        play(number(0, 0.4));
    }

    void load()
    {
        const BodyId body = someBody();
        const Part& part = m_document.content().model->parts[m_document.content().bodies[body]->part];
        Load load{.name = "load", .body = body};
        load.faces = {static_cast<std::uint32_t>(m_random.below(std::max<std::size_t>(1, part.faces.size())))};
        load.patch = loadPatch(*m_document.now().bodies[body].aggregate, part.mesh, load.faces, std::nullopt);
        const Material& material = m_document.now().materials[body];
        const double stress = (material.yields() ? material.yieldStress : 0.05 * material.youngsModulus) * number(0, 1);
        load.amount.pressure = m_random.chance(40) ? stress : 0;
        load.amount.force = 0.05 * stress * size() * size() * direction();
        load.ramp = number(0, 0.2);
        const auto id = static_cast<LoadId>(m_document.moment()->loads.size());
        m_document.post(AddLoad{load});
        play(number(0.05, 0.4));
        m_document.post(RemoveLoad{id});
        m_document.step();
    }

    void scheme()
    {
        if (m_random.chance(50))
            m_document.post(SetPace{static_cast<Pace>(m_random.below(4))});
        else
            m_document.post(SetIntegrator{m_random.chance(60) ? Integrator::automatic : Integrator::implicitEuler});
        play(number(0, 0.2));
    }

    void body()
    {
        const BodyId body = someBody();
        if (m_random.chance(60)) {
            std::vector<ObjectIndex> objects;
            if (m_random.chance(30)) {
                m_document.draw();
                objects = objectsAround(body, someSpot(body, 0.05 * size()).place, 0.3 * size());
            }
            m_document.post(Renormalize{body, std::move(objects), m_random.chance(50) ? 0 : number(0.01, 0.3)});
        } else {
            m_document.post(SetBodyKind{body, m_random.chance(25) ? BodyKind::rigid : BodyKind::deformable});
        }
        play(number(0, 0.3));
    }

    void balance() { m_document.findBalance(); }

    void reset()
    {
        m_document.post(Reset{});
        play(number(0, 0.1));
    }

    void wait() { play(number(0.1, 1)); }

    void toolsThatStay()
    {
        const auto& tools = m_document.now().tools;
        if (!tools.empty() && m_random.chance(65)) {
            m_document.post(RemoveManipulator{m_random.oneOf(tools).id});
        } else {
            m_document.draw();
            m_document.post(AddManipulator{someTool(someSpot(someBody(), 0.05 * size()))});
        }
        play(number(0, 0.2));
    }

    void names()
    {
        m_document.post(SetPartLook{0, m_random.chance(50) ? "Würfel" : "", m_random.chance(50) ? "#ff8000" : ""});
        if (!m_document.now().fixtureIds.empty())
            m_document.post(RenameFixture{m_random.oneOf(m_document.now().fixtureIds), "held"});
        m_document.apply();
    }

    Document& m_document;
    const std::vector<Material>& m_materials;
    fuzz::Random& m_random;
    Findings& m_findings;
};

} // namespace knead::soak
