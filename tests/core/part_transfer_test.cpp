// What was done to a part, done to another one.
#include "core/session/part_transfer.h"

#include "core/geometry/assignment.h"
#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "support/fuzz_random.h"
#include "support/scenes.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <limits>
#include <numbers>
#include <numeric>

using namespace knead;

namespace {

constexpr double wall = 0.005;
constexpr double width = 0.02;

/// One face where triangles lie in one plane, in the order of their numbers or the other way round.
Part withFaces(TriangleMesh mesh, bool isReversed)
{
    Part part;
    part.name = part.path = "bracket";
    mesh.faceOfTriangle.clear();
    std::vector<std::pair<Vec3, double>> planes;
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
        const Vec3 normal = crossOf(mesh.vertices, t).normalized();
        const double height = normal.dot(mesh.vertices[t[0]]);
        const auto isIt = [&](const auto& plane) {
            return (plane.first - normal).norm() < 1e-6 && std::abs(plane.second - height) < 1e-9;
        };
        const auto known = std::ranges::find_if(planes, isIt);
        mesh.faceOfTriangle.push_back(static_cast<std::uint32_t>(known - planes.begin()));
        if (known == planes.end())
            planes.emplace_back(normal, height);
    }
    if (isReversed)
        for (std::uint32_t& face : mesh.faceOfTriangle)
            face = static_cast<std::uint32_t>(planes.size()) - 1 - face;
    part.faces.resize(planes.size());
    const MassProperties properties = massProperties(mesh);
    part.box = boxOfPlaces(mesh.vertices);
    part.volume = properties.volume;
    part.area = 1;
    part.watertight = part.valid = true;
    part.mesh = std::move(mesh);
    return part;
}

/// A foot along x and a wall along y, both as thick, as wide as z goes: eight faces.
Part bracket(double foot, double height, bool isReversed = false)
{
    return withFaces(shapes::prism({{0, 0}, {foot, 0}, {foot, wall}, {wall, wall}, {wall, height}, {0, height}}, width),
                     isReversed);
}

/// The mirror image in the plane x = 0.
Part mirrored(Part part)
{
    for (Vec3& vertex : part.mesh.vertices)
        vertex.x() = -vertex.x();
    for (TriangleMesh::Triangle& triangle : part.mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    part.box = boxOfPlaces(part.mesh.vertices);
    return part;
}

Part scaled(Part part, double factor)
{
    for (Vec3& vertex : part.mesh.vertices)
        vertex *= factor;
    part.box = boxOfPlaces(part.mesh.vertices);
    return part;
}

/// Files that are parts by their names.
RecipeFiles filesOf(std::map<std::string, Part> parts)
{
    RecipeFiles files;
    files.import = [parts = std::move(parts)](const std::vector<std::string>& paths, const ImportOptions&,
                                              TaskControl&) {
        Model model;
        model.file = paths.front();
        model.parts = {parts.at(paths.front())};
        model.tree = {"root", std::nullopt, {{"bracket", 0, {}}}};
        return model;
    };
    files.isProject = [](const std::string&) { return false; };
    return files;
}

/// A ball over the foot, 4 mm from the wall, that goes down into it; the wall is held at its end.
Recipe pressed()
{
    Recipe recipe;
    recipe.file = "press.recipe.json";
    recipe.part = "old";
    recipe.spacing = {SpacingChoice::Kind::Length, 0.0025};
    recipe.duration = 1;
    RecipeManipulator ball;
    ball.name = "ball";
    ball.kind = ToolKind::ball;
    ball.size = Vec3::Constant(0.006);
    ball.pose.position = Vec3(wall + 0.004, wall + 0.0035, width / 2);
    ball.motion = DriveAt{Vec3(0.001, -0.01, 0.002), Vec3(1, 2, 3)};
    recipe.manipulators = {ball};
    recipe.gravity = Vec3(1, 2, 3);
    return recipe;
}

std::uint32_t faceAt(const Part& part, const Vec3& place)
{
    const SurfaceDistance surface(part.mesh);
    return part.mesh.faceOfTriangle[surface.nearest(place).triangle];
}

PartTransfer transferred(const Recipe& recipe, const Part& before, const Part& after, TransferOptions options = {})
{
    return transferToPart(recipe, "new", filesOf({{"old", before}, {"new", after}}), options, TaskControl::none());
}

/// Asks to stop when it was asked so often.
class CancelledLater final : public TaskControl {
public:
    explicit CancelledLater(int after = std::numeric_limits<int>::max())
        : m_after(after)
    {
    }
    void report(double fraction, std::string_view) override { fractions.push_back(fraction); }
    bool isCancelled() const override { return asked++ >= m_after; }

    std::vector<double> fractions;
    mutable std::atomic<int> asked = 0;

private:
    int m_after;
};

bool isNear(const Vec3& a, const Vec3& b, double within = 1e-6)
{
    return (a - b).norm() < within;
}

} // namespace

class PartTransferTest : public QObject {
    Q_OBJECT

private slots:
    void pairsAreThoseOfTheLeastSum()
    {
        fuzz::Random random(3);
        for (int round = 0; round < 30; ++round) {
            std::vector<std::vector<PairingOption>> options(5);
            std::array<std::array<double, 5>, 5> cost{};
            for (std::uint32_t i = 0; i < 5; ++i)
                for (std::uint32_t j = 0; j < 5; ++j) {
                    cost[i][j] = 0.01 * static_cast<double>(random.below(100));
                    options[i].push_back({j, cost[i][j]});
                }
            constexpr double none = 0.6;
            double best = 5 * none;
            std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
            do {
                double sum = 0;
                for (std::size_t i = 0; i < 5; ++i)
                    sum += std::min(cost[i][order[i]], none);
                best = std::min(best, sum);
            } while (std::ranges::next_permutation(order).found);
            const auto pairs = leastCostPairs(options, 5, none);
            double sum = 0;
            std::vector<bool> isTaken(5);
            for (std::size_t i = 0; i < 5; ++i) {
                sum += pairs[i] ? cost[i][*pairs[i]] : none;
                QVERIFY(!pairs[i] || !isTaken[*pairs[i]]);
                if (pairs[i])
                    isTaken[*pairs[i]] = true;
            }
            QVERIFY2(std::abs(sum - best) < 1e-12, qPrintable(QString("%1 %2").arg(sum).arg(best)));
        }
    }

    void facesOfALongerFootAreFoundAgain()
    {
        const PartTransfer transfer = transferred(pressed(), bracket(0.04, 0.03), bracket(0.045, 0.03, true));
        QCOMPARE(transfer.report.faces.size(), std::size_t{8});
        for (const TransferReport::Face& face : transfer.report.faces) {
            QVERIFY(face.after.has_value());
            QCOMPARE(*face.after, 7 - face.before);
            QVERIFY(face.score > 0.5);
        }
        QVERIFY(transfer.report.leftOut.empty());
    }

    void facesOfOneNameAreTheSameFace()
    {
        Part before = bracket(0.05, 0.04);
        Part after = bracket(0.055, 0.04, true);
        const std::uint32_t foot = faceAt(before, {0.03, wall, width / 2});
        const std::uint32_t end = faceAt(after, {0.055, wall / 2, width / 2});
        const std::uint32_t footAfter = faceAt(after, {0.03, wall, width / 2});
        before.faces[foot].name = "seat";
        after.faces[end].name = "seat";
        const auto isFoot = [&](const FaceMatch& match) { return match.before == foot; };
        const auto match = [&] {
            const std::vector<FaceMatch> matches =
                matchFaces(faceLooks(before), before.box, faceLooks(after), after.box, {});
            return *std::ranges::find_if(matches, isFoot);
        };
        QCOMPARE(match().after, end);
        QCOMPARE(match().by, FoundBy::name);
        QCOMPARE(match().score, 1.0);
        // A name of several faces says nothing of which is which.
        after.faces[footAfter].name = "seat";
        QCOMPARE(match().after, footAfter);
        QCOMPARE(match().by, FoundBy::place);
    }

    /// As programs do that number faces: another face has the name now.
    void namesThatWereCountedAnewTellNothing()
    {
        Part before = bracket(0.05, 0.04);
        Part after = bracket(0.055, 0.04, true);
        for (std::uint32_t f = 0; f < before.faces.size(); ++f)
            before.faces[f].name = after.faces[f].name = "F" + std::to_string(f);
        const auto matches = [&] { return matchFaces(faceLooks(before), before.box, faceLooks(after), after.box, {}); };
        QCOMPARE(matches().size(), std::size_t{8});
        for (const FaceMatch& match : matches()) {
            QCOMPARE(match.after, 7 - match.before);
            QCOMPARE(match.by, FoundBy::place);
        }
        for (std::uint32_t f = 0; f < 8; ++f)
            after.faces[7 - f].name = before.faces[f].name;
        for (const FaceMatch& match : matches()) {
            QCOMPARE(match.after, 7 - match.before);
            QCOMPARE(match.by, FoundBy::name);
        }
    }

    void aFaceThatIsNotThereIsReported()
    {
        Recipe recipe = pressed();
        const Part before = bracket(0.04, 0.03);
        const std::uint32_t top = faceAt(before, Vec3(0.03, wall, width / 2));
        recipe.fixtures = {
            RecipeFixture{RecipeRegion{.name = "top", .body = {}, .faces = {top}, .box = {}, .objects = {}}}};
        recipe.events = {{.time = 0.5, .step = {}, .action = ReleaseFixture{"top"}},
                         {.time = 0.6, .step = {}, .action = TakeManipulatorAway{"ball"}}};
        // A wall without a foot: neither its end nor its top are there.
        const PartTransfer transfer = transferred(
            recipe, before, withFaces(shapes::prism({{0, 0}, {wall, 0}, {wall, 0.03}, {0, 0.03}}, width), false));
        QVERIFY(transfer.report.found() < 8);
        QVERIFY(transfer.recipe.fixtures.empty());
        QCOMPARE(transfer.recipe.events.size(), std::size_t{1}); // that which releases it is gone, too
        QVERIFY(!transfer.report.leftOut.empty());
    }

    void placesKeepTheirDistanceFromTheNearestFaces()
    {
        const PartTransfer transfer = transferred(pressed(), bracket(0.04, 0.03), bracket(0.045, 0.03));
        const auto at = [&](const Vec3& place) { return placeOnPart(transfer.bodies, place); };
        QVERIFY(isNear(at(Vec3(wall + 0.002, wall, 0.01)), Vec3(wall + 0.002, wall, 0.01), 2e-5)); // near the wall
        QVERIFY(isNear(at(Vec3(0.039, wall, 0.01)), Vec3(0.044, wall, 0.01), 2e-5));               // near the end
        QVERIFY(isNear(at(Vec3(0.04, 0.002, 0.004)), Vec3(0.045, 0.002, 0.004), 2e-5));            // on it
        QVERIFY(isNear(at(Vec3(0, 0.02, 0.01)), Vec3(0, 0.02, 0.01), 2e-5));                       // behind the wall
        const double middle = at(Vec3(0.0225, wall, 0.01)).x();
        QVERIFY(middle > 0.0235 && middle < 0.0265);
    }

    void toolsGoWithThePlaceThatTheyActOn()
    {
        Recipe recipe = pressed();
        RecipeManipulator& ball = recipe.manipulators[0];
        ball.pose.position = Vec3(0.038, wall + 0.0035, 0.01); // over the end of the foot
        ball.motion = GoTo{{.position = Vec3(0.038, wall + 0.001, 0.01)}};
        recipe.probes = {{.name = "end", .body = {}, .place = Vec3(0.04, 0.0025, 0.01)}};
        const PartTransfer transfer = transferred(recipe, bracket(0.04, 0.03), bracket(0.045, 0.03));
        const RecipeManipulator& moved = transfer.recipe.manipulators[0];
        QVERIFY(isNear(moved.pose.position, ball.pose.position + Vec3(0.005, 0, 0), 1e-4));
        QVERIFY(isNear(std::get<GoTo>(moved.motion).target.position, Vec3(0.043, wall + 0.001, 0.01), 1e-4));
        QVERIFY(isNear(transfer.recipe.probes[0].place, Vec3(0.045, 0.0025, 0.01), 1e-5));
        QCOMPARE(transfer.recipe.spacing.value, recipe.spacing.value);
        QCOMPARE(transfer.recipe.part, std::string("new"));
        QCOMPARE(transfer.report.moved.size(), std::size_t{2});
    }

    void aPartInAnotherPlaceTakesAllAlong()
    {
        Part there = bracket(0.045, 0.03);
        const Vec3 way(0.5, -0.3, 0.2);
        for (Vec3& vertex : there.mesh.vertices)
            vertex += way;
        const Recipe recipe = pressed();
        const PartTransfer transfer = transferred(recipe, bracket(0.04, 0.03), there);
        QCOMPARE(transfer.report.found(), std::size_t{8});
        QVERIFY(
            isNear(transfer.recipe.manipulators[0].pose.position, recipe.manipulators[0].pose.position + way, 3e-4));
    }

    void aMirroredPartnerIsPressedFromTheOtherSide()
    {
        const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
        Recipe recipe = pressed();
        RecipeManipulator wedge = recipe.manipulators[0];
        wedge.name = "wedge";
        wedge.kind = ToolKind::wedge;
        wedge.size = Vec3(0.004, 0.002, 0.006);
        wedge.pose.rotation = Quaternion(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
        recipe.manipulators.push_back(wedge);
        const Part before = bracket(0.04, 0.03);
        const PartTransfer transfer =
            transferred(recipe, before, mirrored(before), {.mirror = Vec3(2, 0, 0), .timesOfSteps = {}});
        QCOMPARE(transfer.report.found(), std::size_t{8});
        const RecipeManipulator& ball = transfer.recipe.manipulators[0];
        QVERIFY(isNear(ball.pose.position, mirror * recipe.manipulators[0].pose.position));
        const auto& drive = std::get<DriveAt>(ball.motion);
        QVERIFY(isNear(drive.velocity, Vec3(-0.001, -0.01, 0.002)));
        QVERIFY(isNear(drive.angularVelocity, Vec3(1, -2, -3)));
        QVERIFY(isNear(transfer.recipe.gravity, Vec3(-1, 2, 3)));
        // The surface of the wedge is the mirror image of what it was.
        const RecipeManipulator& other = transfer.recipe.manipulators[1];
        for (const Vec3& at : {Vec3(0.001, 0.002, 0.003), Vec3(-0.002, 0.0005, -0.004)}) {
            const SurfacePoint was = surfaceOf(wedge.shape(), wedge.pose.toLocal(wedge.pose.position + at));
            const SurfacePoint is = surfaceOf(other.shape(), other.pose.toLocal(other.pose.position + mirror * at));
            QVERIFY(std::abs(was.distance - is.distance) < 1e-9);
        }
    }

    void anImportedToolHasNoMirrorImage()
    {
        Recipe recipe = pressed();
        recipe.manipulators[0].kind = ToolKind::part;
        recipe.manipulators[0].partFile = "old";
        recipe.events = {{.time = 0.5, .step = {}, .action = TakeManipulatorAway{"ball"}}};
        const Part before = bracket(0.04, 0.03);
        const PartTransfer transfer = transferred(recipe, before, mirrored(before), {.mirror = Vec3::UnitX()});
        QVERIFY(transfer.recipe.manipulators.empty() && transfer.recipe.events.empty());
        QCOMPARE(transfer.report.leftOut.size(), std::size_t{1});
    }

    void alargerMemberOfAFamilyFeelsTheSameStress()
    {
        Recipe recipe = pressed();
        const Part before = bracket(0.04, 0.03);
        recipe.manipulators[0].forceLimit = 10;
        const std::uint32_t end = faceAt(before, Vec3(0.04, 0.0025, 0.01));
        recipe.loads = {RecipeLoad{RecipeRegion{.name = "end", .body = {}, .faces = {end}, .box = {}, .objects = {}},
                                   {.force = Vec3(0, 0, 1), .moment = Vec3(0, 1, 0), .pressure = 7}}};
        const PartTransfer transfer =
            transferred(recipe, before, scaled(before, 3), {.scale = std::nullopt, .timesOfSteps = {}});
        QVERIFY(std::abs(transfer.report.scale - 3) < 1e-9);
        QCOMPARE(transfer.report.found(), std::size_t{8});
        const RecipeManipulator& ball = transfer.recipe.manipulators[0];
        QVERIFY(isNear(ball.pose.position, 3 * recipe.manipulators[0].pose.position));
        QVERIFY(isNear(ball.size, Vec3::Constant(0.018)));
        QVERIFY(std::abs(ball.forceLimit - 90) < 1e-6);
        QVERIFY(isNear(std::get<DriveAt>(ball.motion).velocity, Vec3(0.003, -0.03, 0.006)));
        const LoadAmount& amount = transfer.recipe.loads[0].amount;
        QVERIFY(isNear(amount.force, Vec3(0, 0, 9)) && isNear(amount.moment, Vec3(0, 27, 0)) && amount.pressure == 7);
        QVERIFY(std::abs(transfer.recipe.spacing.value - 0.0075) < 1e-12);
    }

    void whatIsHeldIsHeldThereToo()
    {
        Recipe recipe = pressed();
        const Part before = bracket(0.04, 0.03);
        const Part after = bracket(0.045, 0.03, true);
        const std::uint32_t end = faceAt(before, Vec3(0.04, 0.0025, 0.01));
        const RecipeRegion byFace{.name = "face", .body = {}, .faces = {end}, .box = {}, .objects = {}};
        const RecipeRegion byBox{.name = "box",
                                 .body = {},
                                 .faces = {},
                                 .box = Box(Vec3(0.036, -0.001, -0.001), Vec3(0.041, 0.006, 0.021)),
                                 .objects = {}};
        RecipeRegion byNumber{.name = "objects", .body = {}, .faces = {}, .box = {}, .objects = RecipeObjects{}};
        const Aggregate filled = fill(before.mesh, {.spacing = recipe.spacing.value});
        byNumber.objects->of = filled.size();
        byNumber.objects->numbers = objectsInBox(filled, *byBox.box);
        recipe.fixtures = {RecipeFixture{byFace}, RecipeFixture{byBox}};
        recipe.fixtures[1].turn = {.center = Vec3(0.04, 0.0025, 0.01), .angularVelocity = Vec3(0, 0, 1)};
        recipe.events = {{.time = 0.5, .step = {}, .action = AddRecipeFixture{RecipeFixture{byNumber}}}};
        const PartTransfer transfer = transferred(recipe, before, after);
        QVERIFY(transfer.report.leftOut.empty());
        QCOMPARE(transfer.recipe.fixtures[0].faces, std::vector{7 - end});
        const Box& box = *transfer.recipe.fixtures[1].box;
        QVERIFY(isNear(box.max(), Vec3(0.046, 0.006, 0.021), 3e-4));
        QVERIFY(isNear(box.min(), Vec3(0.041, -0.001, -0.001), 2e-3));
        QVERIFY(isNear(transfer.recipe.fixtures[1].turn.center, Vec3(0.045, 0.0025, 0.01), 1e-3));
        const auto& added = std::get<AddRecipeFixture>(transfer.recipe.events[0].action).fixture;
        const Aggregate there = fill(after.mesh, {.spacing = recipe.spacing.value});
        QCOMPARE(added.objects->of, there.size());
        QVERIFY(added.objects->numbers.size() > byNumber.objects->numbers.size() / 2);
        for (const ObjectIndex object : added.objects->numbers)
            QVERIFY(there.lattice.position(object).x() > 0.036 + 0.002);
    }

    void eventsGoByTime()
    {
        Recipe recipe = pressed();
        recipe.durationSteps = 100;
        recipe.events = {{.time = 0, .step = 30, .action = TakeManipulatorAway{"ball"}}};
        const Part before = bracket(0.04, 0.03);
        const PartTransfer transfer =
            transferred(recipe, before, before, {.timesOfSteps = {{0, 0.0}, {20, 1.0}, {40, 3.0}, {100, 4.0}}});
        QVERIFY(!transfer.recipe.events[0].step && !transfer.recipe.durationSteps);
        QVERIFY(std::abs(transfer.recipe.events[0].time - 2) < 1e-12);
        QVERIFY(std::abs(transfer.recipe.duration - 4) < 1e-12);
    }

    void aFieldGoesAlong()
    {
        const Part before = bracket(0.04, 0.03);
        const PartTransfer transfer =
            transferred(pressed(), before, mirrored(before), {.mirror = Vec3::UnitX(), .timesOfSteps = {}});
        DisplacementField field{{Vec3(0.04, 0.002, 0.01)}, {Vec3(0.001, 0.002, 0.003)}};
        const DisplacementField there = fieldOnPart(field, transfer);
        QVERIFY(isNear(there.nodes[0], Vec3(-0.04, 0.002, 0.01)));
        QVERIFY(isNear(there.displacements[0], Vec3(-0.001, 0.002, 0.003)));
    }

    /// Of an assembly: wherever a person asks to stop, it stops, and says until then how far it is.
    void matchingAndCarryingAreCancelled()
    {
        std::vector<Part> before;
        for (int i = 0; i < 40; ++i) {
            before.push_back(bracket(0.04 + 0.0005 * i, 0.03));
            before.back().name = "bracket " + std::to_string(i);
            for (Vec3& vertex : before.back().mesh.vertices)
                vertex.y() += 0.05 * i;
        }
        CancelledLater never;
        PartTransfer transfer;
        transfer.bodies = mapBodies(before, before, {}, never);
        QCOMPARE(transfer.bodies.size(), before.size());
        QVERIFY(never.fractions.size() > 1 && std::ranges::is_sorted(never.fractions));
        for (const int asked : {0, never.asked / 3, never.asked - 1}) {
            CancelledLater control(asked);
            QVERIFY_THROWS_EXCEPTION(Cancelled, mapBodies(before, before, {}, control));
        }
        DisplacementField field;
        for (int i = 0; i < 5000; ++i)
            field.nodes.emplace_back(0.001 * (i % 40), 0.0004 * i, 0.002);
        field.displacements.assign(field.nodes.size(), Vec3(0, 0, 0.001));
        CancelledLater whole;
        const DisplacementField there = fieldOnPart(field, transfer, whole);
        QVERIFY(whole.fractions.size() > 1 && std::ranges::is_sorted(whole.fractions));
        for (std::size_t i = 0; i < field.nodes.size(); i += 97)
            QVERIFY(isNear(there.nodes[i], field.nodes[i], 1e-9)); // no place of another bracket
        CancelledLater control(whole.asked / 2);
        QVERIFY_THROWS_EXCEPTION(Cancelled, fieldOnPart(field, transfer, control));
    }

    void anotherPartIsRefused()
    {
        Part open = bracket(0.04, 0.03);
        open.watertight = false;
        QVERIFY_THROWS_EXCEPTION(UnusableInput, transferred(pressed(), bracket(0.04, 0.03), open));
    }
};

QTEST_APPLESS_MAIN(PartTransferTest)
#include "part_transfer_test.moc"
