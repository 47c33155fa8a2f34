#include "core/aggregate/published_fill.h"
#include "core/aggregate/spacing_choice.h"
#include "support/scenes.h"
#include "ui/language/language.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QtTest>

#include <iterator>
#include <limits>
#include <memory>

using namespace knead;

namespace {

constexpr double spacing = 0.005;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// What was refused, why.
class Refusals {
public:
    const std::vector<Message>& all() const { return m_all; }

    void add(const Message& refusal)
    {
        QVERIFY2(!refusal.empty(), "something was not refused");
        m_all.push_back(refusal);
    }

    void add(const std::vector<Message>& refusals)
    {
        QVERIFY2(!refusals.empty(), "something was not refused");
        m_all.insert(m_all.end(), refusals.begin(), refusals.end());
    }

    template <typename Work>
    void addFailure(Work work)
    {
        try {
            work();
            QFAIL("something was not refused");
        } catch (const Problem& problem) {
            add(problem.message());
        }
    }

    void addScene(const Scene& scene)
    {
        addFailure([&] { const Simulation simulation{Scene(scene)}; });
    }

    void addCommand(const Scene& scene, const Command& command)
    {
        Simulation simulation{Scene(scene)};
        simulation.post(command);
        simulation.applyCommands();
        add(simulation.snapshot()->notice);
    }

private:
    std::vector<Message> m_all;
};

TriangleMesh cube(double edge = 0.02)
{
    return shapes::box(Vec3::Constant(edge));
}

Material plastic()
{
    Material material;
    material.yieldStress = 1e4;
    return material;
}

Scene sceneOf(const Material& material = {})
{
    Scene scene;
    scene.bodies.push_back(scenes::body(cube(), spacing, material, "lump"));
    return scene;
}

Refusals ofMaterials()
{
    Refusals refusals;
    for (const MaterialField& field : materialFields())
        for (const double value : {-1.0, 1e30}) {
            Material material;
            material.*field.value = value;
            refusals.add(materialProblems(material));
        }
    Scene scene = sceneOf();
    Material bad;
    bad.friction = nan;
    refusals.addCommand(scene, SetMaterial{0, bad});
    refusals.addCommand(scene, SetMaterial{7, {}});
    refusals.addCommand(scene, SetMaterial{0, {}, {1'000'000}});
    refusals.addFailure([] {
        MaterialMap map(Material{}, 300);
        Material other;
        for (ObjectIndex i = 0; i < 300; ++i) {
            other.density += 1;
            map.set({i}, other);
        }
    });
    scene.bodies[0].regions.push_back({"core", {1}, bad});
    refusals.addScene(scene);
    scene.bodies[0].regions = {{"core", {1'000'000}, Material{}}};
    refusals.addScene(scene);
    return refusals;
}

Refusals ofTools()
{
    Refusals refusals;
    const auto add = [&](const auto& change) {
        Manipulator tool{.name = "block"};
        change(tool);
        refusals.add(manipulatorProblems(tool));
    };
    add([](Manipulator& tool) { tool.size.x() = 0; });
    add([](Manipulator& tool) { tool.kind = ToolKind::part; });
    add([](Manipulator& tool) {
        tool.kind = ToolKind::ball;
        tool.size = Vec3(0.01, 0.02, 0.03);
    });
    add([](Manipulator& tool) { tool.pose.position.x() = nan; });
    add([](Manipulator& tool) { tool.friction = 3; });
    add([](Manipulator& tool) { tool.speedLimit = 0; });
    add([](Manipulator& tool) { tool.adhesion = -1; });
    add([](Manipulator& tool) { tool.forceLimit = 0; });
    add([](Manipulator& tool) { tool.motion = FollowKeyFrames{}; });
    add([](Manipulator& tool) { tool.motion = FollowKeyFrames{{{1, {}}, {0, {}}}}; });
    add([](Manipulator& tool) { tool.motion = FollowKeyFrames{{{nan, {}}}}; });
    add([](Manipulator& tool) { tool.motion = DriveAt{Vec3(1e5, 0, 0), Vec3::Zero()}; });
    add([](Manipulator& tool) { tool.motion = GoTo{Pose{Vec3(infinite, 0, 0)}}; });
    refusals.addFailure([] { const ToolPart part{TriangleMesh{}}; });
    refusals.addCommand(sceneOf(), RemoveManipulator{3});
    refusals.addCommand(sceneOf(), AddManipulator{{.name = "block", .friction = 3}});
    return refusals;
}

Refusals ofFixtures()
{
    Refusals refusals;
    Fixture fast{.name = "clamp", .body = 0, .objects = {0}, .velocity = Vec3(1000, 0, 0)};
    Fixture turning{.name = "clamp", .body = 0, .objects = {0}};
    turning.turn.angularVelocity = Vec3(1e6, 0, 0);
    const Fixture elsewhere{.name = "clamp", .body = 7, .objects = {0}};
    for (const Fixture& fixture : {fast, turning, elsewhere}) {
        Scene scene = sceneOf();
        refusals.addCommand(scene, AddFixture{fixture});
        scene.fixtures.push_back(fixture);
        refusals.addScene(scene);
    }
    refusals.addCommand(sceneOf(), RemoveFixture{2});
    refusals.addCommand(sceneOf(), MoveFixture{2});
    refusals.addCommand(sceneOf(), RenameFixture{2, "grip"});
    return refusals;
}

Refusals ofLoads()
{
    Refusals refusals;
    const Scene scene = sceneOf();
    Load sound{.name = "weight", .body = 0};
    sound.patch = loadPatch(*scene.bodies[0].aggregate, cube(), {}, Box(Vec3(-1, -1, 0.009), Vec3(1, 1, 1)));
    const auto add = [&](const auto& change) {
        Load load = sound;
        change(load);
        refusals.addCommand(scene, AddLoad{load});
        Scene loaded = scene;
        loaded.loads.push_back(load);
        refusals.addScene(loaded);
    };
    add([](Load& load) { load.patch = {}; });
    add([](Load& load) { load.patch.objects.back() = 1'000'000; });
    add([](Load& load) { load.patch.share.front() = nan; });
    add([](Load& load) { load.amount.pressure = 1e20; });
    add([](Load& load) { load.ramp = -1; });
    add([](Load& load) { load.body = 7; });
    refusals.addCommand(scene, RemoveLoad{4});
    return refusals;
}

Refusals ofSettings()
{
    Refusals refusals;
    const auto add = [&](const auto& change) {
        Scene scene = sceneOf();
        change(scene);
        refusals.addScene(scene);
    };
    add([](Scene& scene) { scene.gravity.x() = 1e6; });
    add([](Scene& scene) { scene.floorHeight = 1e6; });
    add([](Scene& scene) { scene.floorFriction = 3; });
    add([](Scene& scene) { scene.floorAdhesion = -1; });
    add([](Scene& scene) { scene.timeStep = 10; });
    add([](Scene& scene) { scene.massScalingTimeStep = 10; });
    add([](Scene& scene) { scene.bodies[0].aggregate = nullptr; });
    add([](Scene& scene) { scene.bodies[0].velocity.x() = 1e6; });
    add([](Scene& scene) { scene.bodies[0].structuralFriction = 3; });
    add([](Scene& scene) {
        scene.bodies[0].material.dampingRatio = 0;
        scene.integrator = Integrator::forwardEuler;
    });
    refusals.addCommand(sceneOf(), SetGravity{Vec3(1e6, 0, 0)});
    refusals.addCommand(sceneOf(), SetFloor{1e6});
    refusals.addCommand(sceneOf(), SetFloor{0.0, 3});
    refusals.addCommand(sceneOf(), SetFloor{0.0, 0.4, -1});
    return refusals;
}

Refusals ofCommands()
{
    Refusals refusals;
    refusals.addCommand(sceneOf(), SetBodyKind{7, BodyKind::rigid});
    refusals.addCommand(sceneOf(), Renormalize{.body = 0, .duration = -1});
    refusals.addCommand(sceneOf(), Renormalize{.body = 0, .objects = {1'000'000}});
    refusals.addCommand(sceneOf(), FindBalance{-1});
    refusals.addCommand(sceneOf(), Cut{.normal = Vec3::Zero()});
    refusals.addCommand(sceneOf(), Cut{.point = Vec3(1, 0, 0), .normal = Vec3::UnitX()});
    Scene rigid = sceneOf();
    rigid.bodies[0].kind = BodyKind::rigid;
    refusals.addCommand(rigid, Renormalize{});
    refusals.addCommand(rigid, FindBalance{1});
    refusals.addCommand(rigid, Cut{});
    Scene falling = sceneOf();
    falling.gravity = Vec3(0, 0, -9.81);
    refusals.addCommand(falling, FindBalance{1});
    return refusals;
}

Refusals ofFillings()
{
    Refusals refusals;
    const auto add = [&](const TriangleMesh& mesh, const FillOptions& options) {
        refusals.addFailure([&] { fill(mesh, options); });
    };
    TriangleMesh open = cube(); // without a lid
    open.triangles.resize(10);
    open.faceOfTriangle.clear();
    TriangleMesh endless = cube();
    endless.vertices[0].x() = infinite;
    add({}, {.spacing = spacing});
    add(endless, {.spacing = spacing});
    add(open, {.spacing = spacing});
    add(open, {.spacing = spacing / 2, .dirty = DirtySurface::windingNumber});
    add(cube(), {.spacing = -1});
    add(cube(), {.spacing = 1e-6});
    add(cube(), {.spacing = 1});
    const auto addPublished = [&](const TriangleMesh& mesh, double a) {
        refusals.addFailure([&] { fillAsPublished(mesh, a); });
    };
    addPublished(open, spacing);
    addPublished(cube(), 0);
    addPublished(cube(), 1e-6);
    for (const double a : {0.0004, 0.002}) // many times too stiff, and by a share
        refusals.add(assessSpacing(a, sizeWithWalls(shapes::box(Vec3(0.0006, 0.03, 0.02)))).warning);
    return refusals;
}

Refusals ofFillingAnew()
{
    Refusals refusals;
    refusals.addCommand(sceneOf(), Refill{0, -1});
    refusals.addCommand(sceneOf(), Refill{});
    const auto add = [&](const Material& material, const auto& change) {
        Scene scene = sceneOf(material);
        scene.bodies[0].surface = std::make_shared<const TriangleMesh>(cube());
        change(scene);
        refusals.addCommand(scene, Refill{});
    };
    add({}, [](Scene&) {});
    add(plastic(), [](Scene& scene) { scene.bodies[0].kind = BodyKind::rigid; });
    add({}, [](Scene& scene) {
        scene.bodies[0].aggregate = std::make_shared<const Aggregate>(fillAsPublished(cube(), spacing));
    });
    add(plastic(), [](Scene& scene) {
        Load load{.name = "weight", .body = 0, .box = Box(Vec3(-1, -1, 0.009), Vec3(1, 1, 1))};
        load.patch = loadPatch(*scene.bodies[0].aggregate, cube(), {}, load.box);
        scene.loads.push_back(load);
    });
    return refusals;
}

bool hasLetters(const std::string& text)
{
    return QString::fromStdString(text).contains(QRegularExpression("[a-zA-Z]"));
}

/// All that is in a message and is said otherwise in other languages.
void collectSaid(const Message& message, std::vector<Message>& said)
{
    if (!message.subject().empty() && hasLetters(message.text()))
        said.push_back(message);
    for (const Message& argument : message.arguments())
        collectSaid(argument, said);
}

} // namespace

/// Values that the material, a tool, a fixture, a load, a setting, a command or a filling cannot have are refused in a sentence of the
/// window's language.
class RefusedValuesTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { speak("en"); }

    void refusalsAreSaidInEveryLanguage_data()
    {
        QTest::addColumn<int>("kind");
        for (std::size_t k = 0; k < std::size(kinds); ++k)
            QTest::newRow(kinds[k].name) << static_cast<int>(k);
    }

    void refusalsAreSaidInEveryLanguage()
    {
        QFETCH(int, kind);
        const Refusals refusals = kinds[kind].collect();
        QVERIFY(!QTest::currentTestFailed());
        std::vector<Message> all;
        for (const Message& refusal : refusals.all())
            collectSaid(refusal, all);
        QVERIFY(all.size() >= refusals.all().size());
        QStringList missing;
        for (const char* code : {"de", "fr", "nl"}) {
            speak(code);
            for (const Message& message : all) {
                const QString english = QString::fromStdString(message.text());
                const QString translated =
                    QCoreApplication::translate(message.subject().c_str(), message.text().c_str());
                if (translated == english)
                    missing << QString("%1 %2: %3").arg(code, QString::fromStdString(message.subject()), english);
                for (int place = 1; place <= 9; ++place) {
                    const QString mark = QString("%%1").arg(place);
                    QVERIFY2(translated.contains(mark) == english.contains(mark), qPrintable(translated));
                }
            }
        }
        missing.removeDuplicates();
        QVERIFY2(missing.isEmpty(), qPrintable('\n' + missing.join('\n')));
    }

private:
    struct Kind {
        const char* name;
        Refusals (*collect)();
    };
    static constexpr Kind kinds[] = {
        {"materials", ofMaterials}, {"tools", ofTools},       {"fixtures", ofFixtures}, {"loads", ofLoads},
        {"settings", ofSettings},   {"commands", ofCommands}, {"fillings", ofFillings}, {"filling anew", ofFillingAnew},
    };
};

QTEST_GUILESS_MAIN(RefusedValuesTest)
#include "refused_values_test.moc"
