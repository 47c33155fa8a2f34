#include "support/recipe_texts.h"

#include <QtTest>

#include <cmath>

using namespace knead;
using namespace knead::recipe_texts;

namespace {

bool isNear(const Vec3& a, const Vec3& b)
{
    return (a - b).norm() < 1e-12;
}

} // namespace

class RecipeTest : public QObject {
    Q_OBJECT

private slots:
    void smallestRecipeHasDefaults();
    void lengthsBecomeMeters();
    void spacingCanBeGivenByTheThinnestWall();
    void touchingBodiesCanBeGlued();
    void partIsFoundBesideTheRecipe();
    void materialNumbersReplaceThoseOfThePreset();
    void bodyMaterialsStartFromTheCommonOne();
    void rotationsTurnAboutFixedAxesXThenYThenZ();
    void keyFramesStartAtThePositionAndKeepWhatTheyDoNotSay();
    void fixturesHoldFacesOrBoxes();
    void manipulatorsHaveTheMeasuresOfTheirKind();
    void regionsAreMadeOfSomethingElse();
    void bodiesMayBeRigidAndMove();
    void partsAreBroughtTogether();
    void calculationCanBeAsPublished();
    void stepsCanBeImplicit();
    void theIntegratorIsChosenByWhatIsWanted();
    void eventsAreReadInOrder();
    void eventsRenormalizeAndChangeKinds();
    void picturesHaveSizeAndView();
};

void RecipeTest::smallestRecipeHasDefaults()
{
    const Recipe recipe = parse(smallest());
    QCOMPARE(recipe.material, Material{});
    QVERIFY(recipe.spacing.kind == SpacingChoice::Kind::Objects);
    QCOMPARE(recipe.spacing.value, 500.0);
    QCOMPARE(recipe.duration, 2.0);
    QVERIFY(recipe.gravity.isZero());
    QVERIFY(!recipe.floor);
    QVERIFY(recipe.manipulators.empty() && recipe.fixtures.empty() && recipe.events.empty() && recipe.exports.empty());
}

void RecipeTest::lengthsBecomeMeters()
{
    json recipe = withManipulator(R"({"name": "press", "size_mm": [10, 20, 30], "position_mm": [0, 0, 50],
                                      "speed_limit_mm_s": 200})");
    recipe.erase("objects");
    recipe["spacing_mm"] = 2.5;
    recipe["floor"] = {{"height_mm", -4}, {"friction", 0.6}};
    recipe["gravity_m_s2"] = {0, 0, -9.81};
    const Recipe read = parse(recipe);
    QCOMPARE(read.spacing.value, 0.0025);
    QVERIFY(isNear(read.manipulators[0].size, Vec3(0.01, 0.02, 0.03)));
    QVERIFY(isNear(read.manipulators[0].pose.position, Vec3(0, 0, 0.05)));
    QVERIFY(std::abs(read.manipulators[0].speedLimit - 0.2) < 1e-15);
    QCOMPARE(read.floor->height, -0.004);
    QCOMPARE(read.floor->friction, 0.6);
    QVERIFY(isNear(read.gravity, Vec3(0, 0, -9.81)));
}

void RecipeTest::spacingCanBeGivenByTheThinnestWall()
{
    json recipe = smallest();
    recipe.erase("objects");
    recipe["cells_across_wall"] = 3.5;
    QVERIFY(parse(recipe).spacing.kind == SpacingChoice::Kind::CellsAcrossWall);
    QCOMPARE(parse(recipe).spacing.value, 3.5);
}

void RecipeTest::touchingBodiesCanBeGlued()
{
    json recipe = smallest();
    QVERIFY(parse(recipe).touching == Touching::separate);
    recipe["touching"] = "glued";
    QVERIFY(parse(recipe).touching == Touching::glued);
}

void RecipeTest::partIsFoundBesideTheRecipe()
{
    const Recipe recipe = parse(smallest());
    QCOMPARE(recipe.part, QFileInfo(QString::fromStdString(recipe.file)).path().toStdString() + "/bar.stl");
}

void RecipeTest::materialNumbersReplaceThoseOfThePreset()
{
    QCOMPARE(parse(with("material", R"("rubber")")).material, presets[1].material);

    Material expected = presets[0].material;
    expected.youngsModulus = 7e5;
    QCOMPARE(parse(with("material", R"({"preset": "clay", "youngs_modulus_pa": 7e5})")).material, expected);

    expected = Material{};
    expected.friction = 0.1;
    QCOMPARE(parse(with("material", R"({"friction": 0.1})")).material, expected);
}

void RecipeTest::bodyMaterialsStartFromTheCommonOne()
{
    json recipe = with("material", R"("clay")");
    recipe["body_materials"] = json::parse(R"({"lid": {"density_kg_m3": 2000}, "box": "rubber"})");
    const Recipe read = parse(recipe);
    QCOMPARE(read.bodyMaterials.size(), std::size_t(2));
    for (const auto& [name, material] : read.bodyMaterials) {
        Material expected = name == "box" ? presets[1].material : presets[0].material;
        if (name == "lid")
            expected.density = 2000;
        QCOMPARE(material, expected);
    }
}

void RecipeTest::rotationsTurnAboutFixedAxesXThenYThenZ()
{
    const Recipe recipe = parse(withManipulator(
        R"({"name": "a", "size_mm": [1, 1, 1], "position_mm": [0, 0, 0], "rotation_deg": [90, 0, 90]})"));
    // y goes to z about x and stays there about z; x goes to y about z.
    const Quaternion& rotation = recipe.manipulators[0].pose.rotation;
    QVERIFY(isNear(rotation * Vec3::UnitY(), Vec3::UnitZ()));
    QVERIFY(isNear(rotation * Vec3::UnitX(), Vec3::UnitY()));
}

void RecipeTest::keyFramesStartAtThePositionAndKeepWhatTheyDoNotSay()
{
    const Recipe recipe = parse(withManipulator(R"({"name": "a", "size_mm": [1, 1, 1], "position_mm": [0, 0, 10],
        "keyframes": [{"time_s": 0.5, "position_mm": [0, 0, 4]}, {"time_s": 1, "rotation_deg": [0, 90, 0]}]})"));
    const auto& frames = std::get<FollowKeyFrames>(recipe.manipulators[0].motion).frames;
    QCOMPARE(frames.size(), std::size_t(3));
    QCOMPARE(frames[0].time, 0.0);
    QVERIFY(isNear(frames[0].pose.position, Vec3(0, 0, 0.01)));
    QVERIFY(isNear(frames[1].pose.position, Vec3(0, 0, 0.004)));
    QVERIFY(isNear(frames[2].pose.position, Vec3(0, 0, 0.004)));
    QVERIFY(isNear(frames[2].pose.rotation * Vec3::UnitZ(), Vec3::UnitX()));
}

void RecipeTest::fixturesHoldFacesOrBoxes()
{
    const Recipe recipe = parse(with("fixtures", R"([{"name": "left", "faces": [3, 0]},
        {"name": "right", "body": "bar", "box_mm": [-1, -2, -3, 4, 5, 6]}])"));
    QCOMPARE(recipe.fixtures[0].faces, (std::vector<std::uint32_t>{3, 0}));
    QVERIFY(!recipe.fixtures[0].box);
    QCOMPARE(recipe.fixtures[1].body, std::string("bar"));
    QVERIFY(isNear(recipe.fixtures[1].box->min(), Vec3(-1, -2, -3) / 1000));
    QVERIFY(isNear(recipe.fixtures[1].box->max(), Vec3(4, 5, 6) / 1000));
}

void RecipeTest::manipulatorsHaveTheMeasuresOfTheirKind()
{
    json recipe = smallest();
    recipe["manipulators"] = json::parse(R"([
        {"name": "a", "kind": "ball", "size_mm": 12, "position_mm": [0, 0, 0]},
        {"name": "b", "kind": "cylinder", "size_mm": [8, 30], "position_mm": [0, 0, 0], "rolls_freely": true},
        {"name": "c", "kind": "wedge", "size_mm": [30, 4, 20], "position_mm": [0, 0, 0]},
        {"name": "d", "kind": "part", "part_file": "bar.stl", "position_mm": [1, 2, 3]},
        {"name": "e", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0]}])");
    const Recipe read = parse(recipe);
    QVERIFY(read.manipulators[0].kind == ToolKind::ball);
    QVERIFY(isNear(read.manipulators[0].size, Vec3(0.012, 0.012, 0.012)));
    QVERIFY(read.manipulators[1].kind == ToolKind::cylinder);
    QVERIFY(isNear(read.manipulators[1].size, Vec3(0.008, 0.008, 0.03)));
    QVERIFY(read.manipulators[1].rolls() && !read.manipulators[0].rolls());
    QVERIFY(read.manipulators[2].kind == ToolKind::wedge);
    QVERIFY(read.manipulators[3].kind == ToolKind::part);
    QCOMPARE(read.manipulators[3].partFile, read.part);
    QVERIFY(read.manipulators[4].kind == ToolKind::box);
    for (const std::size_t i : {0, 1, 2, 4})
        QVERIFY(manipulatorProblems(read.manipulators[i]).empty());
}

void RecipeTest::regionsAreMadeOfSomethingElse()
{
    const Recipe recipe = parse(with("regions", R"([{"name": "core", "body": "bar", "box_mm": [0, 0, 0, 1, 2, 3],
        "material": {"preset": "clay", "density_kg_m3": 1800}}])"));
    QCOMPARE(recipe.regions[0].name, std::string("core"));
    QCOMPARE(recipe.regions[0].body, std::string("bar"));
    QVERIFY(isNear(recipe.regions[0].box->max(), Vec3(1, 2, 3) / 1000));
    Material expected = presets[0].material;
    expected.density = 1800;
    QCOMPARE(recipe.regions[0].material.on(Material{}), expected);
}

void RecipeTest::bodiesMayBeRigidAndMove()
{
    const Recipe recipe = parse(with("bodies", R"({"lid": {"kind": "rigid", "velocity_mm_s": [0, 0, -50],
        "angular_velocity_deg_s": [180, 0, 0]}, "base": {"kind": "glue"}})"));
    QCOMPARE(recipe.bodies.size(), std::size_t(2));
    const RecipeBody& base = recipe.bodies[0];
    QCOMPARE(base.name, std::string("base"));
    QVERIFY(base.kind == BodyKind::glue && base.velocity.isZero());
    const RecipeBody& lid = recipe.bodies[1];
    QCOMPARE(lid.name, std::string("lid"));
    QVERIFY(lid.kind == BodyKind::rigid);
    QVERIFY(isNear(lid.velocity, Vec3(0, 0, -0.05)));
    QVERIFY(isNear(lid.angularVelocity, Vec3(std::acos(-1.0), 0, 0)));
}

void RecipeTest::partsAreBroughtTogether()
{
    const Recipe recipe = parse(with("extra_parts", R"([{"file": "bar.stl", "name": "other half",
        "position_mm": [0, 0, 20], "rotation_deg": [0, 0, 90]}])"));
    QCOMPARE(recipe.extraParts.size(), std::size_t(1));
    QCOMPARE(recipe.extraParts[0].file, recipe.part);
    QCOMPARE(recipe.extraParts[0].name, std::string("other half"));
    QVERIFY(isNear(recipe.extraParts[0].pose.toWorld(Vec3::UnitX()), Vec3(0, 1, 0.02)));
}

void RecipeTest::calculationCanBeAsPublished()
{
    json recipe = smallest();
    recipe.erase("objects");
    recipe.update(json::parse(R"({"spacing_mm": 2, "arrangement": "published", "integrator": "forward-euler",
        "vicinity": "half-partition", "time_step_s": 1e-4, "mass_scaling_time_step_s": 2e-4,
        "structural_friction": 0.2})"));
    const Recipe read = parse(recipe);
    QVERIFY(read.arrangement == Arrangement::published);
    QVERIFY(read.integrator == Integrator::forwardEuler);
    QVERIFY(read.vicinity == VicinityMethod::halfPartition);
    QCOMPARE(read.timeStep.value(), 1e-4);
    QCOMPARE(read.massScalingTimeStep.value(), 2e-4);
    QCOMPARE(read.structuralFriction, 0.2);
}

void RecipeTest::stepsCanBeImplicit()
{
    QVERIFY(parse(with("integrator", R"("implicit-euler")")).integrator == Integrator::implicitEuler);
    QVERIFY(parse(with("integrator", R"("automatic")")).integrator == Integrator::automatic);
}

void RecipeTest::theIntegratorIsChosenByWhatIsWanted()
{
    json recipe = smallest();
    recipe["duration_s"] = 1;
    const auto chosen = [&](const json& more) {
        json changed = recipe;
        changed.update(more);
        return parse(changed).integrator;
    };
    QVERIFY(chosen(json::object()) == Integrator::automatic);
    // A blow is over within some frames.
    QVERIFY(chosen({{"duration_s", 0.1}}) == Integrator::semiImplicitEuler);
    QVERIFY(chosen({{"duration_s", 0.1}, {"integrator", "automatic"}}) == Integrator::semiImplicitEuler);
    QVERIFY(chosen({{"duration_s", 0.1}, {"integrator", "implicit-euler"}}) == Integrator::implicitEuler);
    // Steps that are named are those of the explicit scheme, as in recipes of earlier versions.
    QVERIFY(chosen({{"time_step_s", 1e-5}}) == Integrator::semiImplicitEuler);
    QVERIFY(chosen({{"mass_scaling_time_step_s", 1e-4}}) == Integrator::semiImplicitEuler);
    QVERIFY(chosen({{"events", json::parse(R"([{"step": 5, "gravity_m_s2": [0, 0, -1]}])")}}) ==
            Integrator::semiImplicitEuler);
    QVERIFY(chosen({{"time_step_s", 1e-5}, {"integrator", "automatic"}}) == Integrator::automatic);
    recipe.erase("duration_s");
    QVERIFY(chosen({{"duration_steps", 100}}) == Integrator::semiImplicitEuler);
    QVERIFY(chosen({{"duration_steps", 100}, {"integrator", "automatic"}}) == Integrator::automatic);
}

void RecipeTest::eventsRenormalizeAndChangeKinds()
{
    const Recipe recipe = parse(with("events", R"([{"time_s": 0, "renormalize": {}},
        {"time_s": 1, "renormalize": {"body": "bar", "box_mm": [0, 0, 0, 1, 1, 1], "duration_s": 0.5}},
        {"time_s": 1, "body_kind": {"body": "bar", "kind": "glue"}},
        {"time_s": 2, "material": "clay", "box_mm": [0, 0, 0, 1, 1, 2]}])"));
    const auto& whole = std::get<RenormalizeBodies>(recipe.events[0].action);
    QVERIFY(whole.body.empty() && !whole.box && whole.duration == 0);
    const auto& part = std::get<RenormalizeBodies>(recipe.events[1].action);
    QCOMPARE(part.body, std::string("bar"));
    QCOMPARE(part.duration, 0.5);
    QVERIFY(isNear(part.box->max(), Vec3(1, 1, 1) / 1000));
    QVERIFY(std::get<ChangeBodyKind>(recipe.events[2].action).kind == BodyKind::glue);
    QVERIFY(isNear(std::get<ChangeMaterial>(recipe.events[3].action).box->max(), Vec3(1, 1, 2) / 1000));
}

void RecipeTest::eventsAreReadInOrder()
{
    json recipe = with("fixtures", R"([{"name": "left", "faces": [3]}])");
    recipe["events"] = json::parse(R"([{"time_s": 0.5, "remove_fixture": "left"},
        {"time_s": 0.5, "material": {"youngs_modulus_pa": 1e5}, "body": "bar"},
        {"time_s": 1.5, "gravity_m_s2": [0, 0, -1]}])");
    const Recipe read = parse(recipe);
    QCOMPARE(read.events.size(), std::size_t(3));
    QCOMPARE(std::get<ReleaseFixture>(read.events[0].action).fixture, std::string("left"));
    const auto& change = std::get<ChangeMaterial>(read.events[1].action);
    QCOMPARE(change.body, std::string("bar"));
    Material expected = presets[0].material;
    expected.youngsModulus = 1e5;
    QCOMPARE(change.material.on(presets[0].material), expected);
    QVERIFY(isNear(std::get<ChangeGravity>(read.events[2].action).gravity, -Vec3::UnitZ()));
}

void RecipeTest::picturesHaveSizeAndView()
{
    const Recipe recipe =
        parse(with("exports", R"([{"file": "a.stl"}, {"file": "sub/b.PNG", "width": 640, "height": 480,
        "view": "top"}, {"file": "c.png", "view": [1, 2, -1], "show_tools": false}])"));
    QVERIFY(!recipe.exports[0].isPicture());
    QVERIFY(recipe.exports[1].showTools);
    QVERIFY(!recipe.exports[2].showTools);
    QVERIFY(recipe.exports[1].isPicture());
    QCOMPARE(recipe.exports[1].width, 640);
    QCOMPARE(recipe.exports[1].height, 480);
    QVERIFY(isNear(*recipe.exports[1].viewDirection, -Vec3::UnitZ()));
    QVERIFY(isNear(recipe.exports[1].up, Vec3::UnitY()));
    QVERIFY(isNear(*recipe.exports[2].viewDirection, Vec3(1, 2, -1)));
}

QTEST_GUILESS_MAIN(RecipeTest)
#include "recipe_test.moc"
