#include "support/cantilever.h"
#include "support/workshop.h"

#include <QtTest>

#include <fstream>
#include <numbers>

using namespace workshop;
namespace quadratic_tets = knead::quadratic_tets;

namespace {

const QString cantilever = KNEAD_RESOURCES "/examples/cantilever/cantilever.step";
const QString results = KNEAD_RESOURCES "/examples/cantilever/cantilever.frd";
const QString bracket = KNEAD_RESOURCES "/examples/bracket.step";

json partOf(const std::string& path, std::size_t part = 0)
{
    return json::parse(workshop::runKnead({"info", QString::fromStdString(path), "--json"}).out).at("parts").at(part);
}

double volumeOf(const std::string& path, std::size_t part = 0)
{
    return partOf(path, part).at("volume_mm3");
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    file.open(QIODevice::ReadOnly);
    return file.readAll();
}

/// Of results, what is not about when and by what they were made.
QByteArray numbersIn(const QByteArray& text)
{
    QByteArray numbers;
    for (const QByteArray& line : text.split('\n'))
        if (line.startsWith(" -"))
            numbers += line + '\n';
    return numbers;
}

} // namespace

/// `knead morph`: fields and numbers to parts.
class MorphCommandTest : public QObject {
    Q_OBJECT

    Workshop m_shop;

    Outcome morph(const QString& part, const QStringList& how, const QString& out = "out.step")
    {
        return workshop::runKnead(QStringList{"morph", part} + how +
                                  QStringList{"--output", m_shop.qPath(out.toStdString())});
    }

private slots:
    /// The bundled results are those of the bundled input, and that is what the test's own mesh gives.
    void theExampleIsWhatCalculixMakesOfIt()
    {
        const std::string input = quadratic_tets::cantileverInput();
        QCOMPARE(contentOf(KNEAD_RESOURCES "/examples/cantilever/cantilever.inp").toStdString(), input);
        const QTemporaryDir folder;
        const std::string solved = quadratic_tets::solve(folder.path(), "cantilever", input);
        const QList<QByteArray> now = numbersIn(contentOf(QString::fromStdString(solved))).split('\n');
        const QList<QByteArray> bundled = numbersIn(contentOf(results)).split('\n');
        QCOMPARE(now.size(), bundled.size());
        const auto displacements =
            quadratic_tets::displacementsIn(solved, quadratic_tets::cantileverMesh().nodes.size());
        const auto known =
            quadratic_tets::displacementsIn(results.toStdString(), quadratic_tets::cantileverMesh().nodes.size());
        for (std::size_t n = 0; n < known.size(); ++n)
            QVERIFY((displacements[n] - known[n]).norm() < 1e-3);
    }

    void theExampleBecomesASmoothPart()
    {
        const Outcome outcome = morph(cantilever, {"--field", results, "--json", "--report"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json said = json::parse(outcome.out);
        QVERIFY(said.at("sound").get<bool>());
        const json& field = said.at("deformations").at(0);
        QCOMPARE(field.at("kind").get<std::string>(), std::string("field"));
        QCOMPARE(field.at("nodes").get<int>(), 315);
        QVERIFY(std::abs(field.at("largest_mm").get<double>() - 7.509) < 1e-2);
        const json& part = said.at("parts").at(0);
        QVERIFY(std::abs(part.at("largest_displacement_mm").get<double>() - 7.509) < 0.05);
        QVERIFY(part.at("mean_displacement_mm").get<double>() > 1 && part.at("mean_displacement_mm").get<double>() < 4);
        QVERIFY(std::abs(part.at("largest_displacement_near_mm").at(0).get<double>() - 120) < 1e-6);
        QVERIFY(QFileInfo::exists(m_shop.qPath("out.step.report.json")));

        const json before = partOf(cantilever.toStdString());
        const json after = partOf(m_shop.path("out.step"));
        for (const char* same : {"name", "color", "faces", "edges", "solids", "watertight", "valid"})
            QVERIFY2(after.at(same) == before.at(same), same);
        QVERIFY(std::abs(after.at("volume_mm3").get<double>() / before.at("volume_mm3").get<double>() - 1) < 5e-3);
        QVERIFY(after.at("bbox_mm").at(2).get<double>() < -6);
    }

    void aPersonIsToldWhatWasDone()
    {
        const Outcome outcome = morph(cantilever, {"--field", results, "--factor", "-1"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        for (const char* words : {"cantilever.frd: CalculiX results", "315 nodes", "factor -1", "Arm: moved by 7.5",
                                  "smooth faces, sound", "at rest 23.4"})
            QVERIFY2(outcome.out.find(words) != std::string::npos, (words + ("\n" + outcome.out)).c_str());
        QVERIFY(partOf(m_shop.path("out.step")).at("bbox_mm").at(5).get<double>() > 16);
    }

    /// The end that is pushed, face 5, stays where it is beside the held one; what is 40 mm away from it moves as before.
    void keptFacesStay()
    {
        for (const char* faces : {"5", "Arm:5"}) {
            const Outcome outcome =
                morph(cantilever, {"--field", results, "--keep-faces", faces, "--fade", "40", "--json"});
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
            const json said = json::parse(outcome.out);
            QCOMPARE(said.at("deformations").at(0).at("fade_mm").get<double>(), 40.0);
            QCOMPARE(said.at("export").at("parts").at(0).at("faces").at("kept").get<int>(), 2);
            QVERIFY(said.at("parts").at(0).at("largest_displacement_mm").get<double>() < 6);
            QVERIFY(std::abs(partOf(m_shop.path("out.step")).at("bbox_mm").at(3).get<double>() - 120) < 1e-3);
        }
    }

    void aLockHoldsADirection()
    {
        const Outcome outcome = morph(cantilever, {"--field", results, "--lock", "y,z"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json box = partOf(m_shop.path("out.step")).at("bbox_mm");
        for (const int axis : {1, 2, 4, 5})
            QVERIFY(std::abs(box.at(static_cast<std::size_t>(axis)).get<double>() - (axis == 4   ? 20
                                                                                     : axis == 5 ? 10
                                                                                                 : 0)) < 0.02);
    }

    /// 30 mm of straight arm, a quarter of a circle with the middle at 20 mm, and what is left of 120 mm, upright.
    void aBendIsMadeByNumber()
    {
        const Outcome outcome =
            morph(cantilever, {"--bend", "90", "--axis", "x", "--side", "z", "--from", "30", "--radius", "20"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json after = partOf(m_shop.path("out.step"));
        const double rest = 120 - 30 - 20 * std::numbers::pi / 2;
        QVERIFY(std::abs(after.at("bbox_mm").at(3).get<double>() - (30 + 20 + 5)) < 0.02);
        QVERIFY(std::abs(after.at("bbox_mm").at(5).get<double>() - (5 + 20 + rest)) < 0.02);
        QVERIFY(after.at("valid").get<bool>() && after.at("watertight").get<bool>());
        QVERIFY(std::abs(after.at("volume_mm3").get<double>() / volumeOf(cantilever.toStdString()) - 1) < 1e-3);
    }

    /// First twice as long, then half as wide at the end, is not the other way around.
    void deformationsFollowEachOtherInTheirOrder()
    {
        const QStringList stretch{"--stretch", "2"};
        const QStringList shear{"--shear", "40", "--from", "0", "--to", "120"};
        const auto height = [&](const QStringList& how) {
            const Outcome outcome = morph(cantilever, how, "out.stl");
            return outcome.status == 0 ? partOf(m_shop.path("out.stl")).at("bbox_mm").at(5).get<double>() : 0;
        };
        QVERIFY(std::abs(height(stretch + shear) - 50) < 1e-3); // beyond 120 mm nothing more
        QVERIFY(std::abs(height(QStringList{"--axis", "x", "--side", "-z"} + shear + stretch) - 10) < 1e-3);
        const Outcome both = morph(cantilever, stretch + QStringList{"--json"} + shear, "out.stl");
        const json said = json::parse(both.out);
        QCOMPARE(said.at("deformations").at(0).at("kind").get<std::string>(), std::string("stretch"));
        QCOMPARE(said.at("deformations").at(1).at("to_mm").get<double>(), 120.0);
        QCOMPARE(said.at("deformations").at(0).at("to_mm").get<double>(), 120.0);
    }

    /// What stands first holds for all, what follows a deformation only for that.
    void optionsBelongToWhatTheyFollow()
    {
        const Outcome outcome = morph(
            cantilever,
            {"--axis", "y", "--ease", "--twist", "10", "--axis", "x", "--scale", "1.5", "--stays", "0.5", "--json"},
            "out.stl");
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json made = json::parse(outcome.out).at("deformations");
        QCOMPARE(made.at(0).at("axis").at(0).get<double>(), 1.0);
        QCOMPARE(made.at(1).at("axis").at(1).get<double>(), 1.0);
        QVERIFY(made.at(0).at("ease").get<bool>() && made.at(1).at("ease").get<bool>());
        QCOMPARE(made.at(0).at("stays").get<double>(), 0.0);
        QCOMPARE(made.at(1).at("stays").get<double>(), 0.5);
    }

    void onlyNamedPartsAreDeformed()
    {
        const Outcome outcome = morph(bracket, {"--stretch", "1.5", "--axis", "z", "--part", "Bushing", "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json said = json::parse(outcome.out);
        QVERIFY(!said.at("parts").at(0).at("is_deformed").get<bool>());
        QVERIFY(std::abs(volumeOf(m_shop.path("out.step"), 0) / volumeOf(bracket.toStdString(), 0) - 1) < 1e-6);
        QVERIFY(std::abs(volumeOf(m_shop.path("out.step"), 1) / volumeOf(bracket.toStdString(), 1) - 1.5) < 1e-4);
    }

    void unitsAreHeeded()
    {
        const QTemporaryDir folder;
        std::ofstream(folder.filePath("shift.csv").toStdString())
            << "0,0,0,0,0,1\n5,0,0,0,0,1\n0,1,0,0,0,1\n0,0,1,0,0,1\n5,1,1,0,0,1\n5,1,0,0,0,1\n5,0,1,0,0,1\n0,1,1,0,0,"
               "1\n";
        const Outcome outcome =
            morph(cantilever, {"--field", folder.filePath("shift.csv"), "--field-unit", "inch", "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QVERIFY(std::abs(partOf(m_shop.path("out.step")).at("bbox_mm").at(5).get<double>() - 35.4) < 1e-3);
    }

    /// A part that came out 10 % wider, scanned where it was made: compensated, it is 10 % narrower.
    void aScanIsAField()
    {
        QCOMPARE(morph(cantilever, {"--stretch", "1.1", "--axis", "y", "--stays", "0.5"}, "scan.stl").status, 0);
        const Outcome outcome =
            morph(cantilever, {"--field", m_shop.qPath("scan.stl"), "--in-place", "--factor", "-1"}, "out.stl");
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QVERIFY2(outcome.out.find("scan.stl: scan") != std::string::npos, outcome.out.c_str());
        const json after = partOf(m_shop.path("out.stl"));
        QVERIFY(std::abs(after.at("volume_mm3").get<double>() / volumeOf(cantilever.toStdString()) - 0.9) < 2e-3);
        QVERIFY(std::abs(after.at("bbox_mm").at(0).get<double>()) < 0.05);
        QVERIFY(std::abs(after.at("bbox_mm").at(3).get<double>() - 120) < 0.05);
    }

    /// Pulled to 1.4 times its middle it gets thinner there, and keeps its volume; ends are where the exact way takes them.
    void physicsFindsTheShapeBetweenGrips()
    {
        const Outcome outcome =
            morph(cantilever, {"--stretch", "1.4", "--from", "40", "--to", "80", "--physics", "--material",
                               "modeling-clay", "--objects", "800", "--time", "0.3", "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json said = json::parse(outcome.out);
        QCOMPARE(said.at("fixtures").size(), std::size_t{2});
        const json after = partOf(m_shop.path("out.step"));
        QVERIFY(after.at("watertight").get<bool>() && after.at("valid").get<bool>());
        QVERIFY(std::abs(after.at("bbox_mm").at(3).get<double>() - 136) < 0.05);
        QVERIFY(std::abs(after.at("volume_mm3").get<double>() / volumeOf(cantilever.toStdString()) - 1) < 0.02);
    }

    void whatDoesNotFitIsOneSentenceAndNothingIsWritten_data()
    {
        QTest::addColumn<QStringList>("how");
        QTest::addColumn<QString>("words");
        const QString broken = m_shop.qPath("broken.frd");
        std::ofstream(broken.toStdString()) << contentOf(results).left(20'000).toStdString();
        const auto row = [](const char* name, const QStringList& how, const char* words) {
            QTest::newRow(name) << how << words;
        };
        row("nothing", {}, "nothing is said");
        row("no file", {"--field", "/nowhere/a.frd"}, "a.frd");
        row("cut off", {"--field", broken}, "broken.frd");
        row("no field", {"--field", KNEAD_RESOURCES "/examples/cantilever/cantilever.inp"}, "cantilever.inp");
        row("other unit", {"--field", results, "--field-unit", "km"}, "unit");
        row("no such step", {"--field", results, "--step", "7"}, "cantilever.frd");
        row("no such component", {"--field", results, "--component", "TEMPERATURE"}, "TEMPERATURE");
        row("no such face", {"--field", results, "--keep-faces", "99"}, "no face 99");
        row("no number", {"--bend", "much"}, "--bend takes a number");
        row("no direction", {"--bend", "9", "--axis", "up"}, "--axis takes");
        row("no unit", {"--field", results, "--field-unit", "cubit"}, "--field-unit takes");
        row("no axis", {"--field", results, "--lock", "w"}, "--lock takes");
        row("of another", {"--field", results, "--axis", "x"}, "--axis says nothing");
        row("no such part", {"--bend", "9", "--part", "Lid"}, "no part or assembly \"Lid\"");
        row("no room", {"--bend", "9", "--from", "5", "--to", "5"}, "lane");
        row("twice", {"--bend", "9", "--to", "5", "--radius", "5"}, "radius");
        row("physics of nothing", {"--bend", "9", "--let-go"}, "give --physics too");
        row("no material", {"--bend", "9", "--physics"}, "give --material, one of");
        row("another material", {"--bend", "9", "--physics", "--material", "cheese"}, "no material \"cheese\"");
        row("taper", {"--taper", "2", "--physics", "--material", "steel"}, "do it exactly");
        row("two at once", {"--bend", "9", "--twist", "9", "--physics", "--material", "steel"}, "one bend");
    }

    void whatDoesNotFitIsOneSentenceAndNothingIsWritten()
    {
        QFETCH(QStringList, how);
        QFETCH(QString, words);
        const Outcome outcome = morph(cantilever, how, "never.step");
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.errors.starts_with("knead: "), outcome.errors.c_str());
        QCOMPARE(lineCount(outcome.errors), std::size_t(1));
        QVERIFY2(outcome.errors.find(words.toStdString()) != std::string::npos, outcome.errors.c_str());
        QCOMPARE(outcome.out, std::string());
        QVERIFY(!QFileInfo::exists(m_shop.qPath("never.step")));
    }

    void whereToWriteIsSaidBeforeAnythingIsRead()
    {
        const Outcome outcome = workshop::runKnead({"morph", "/nowhere/a.step", "--bend", "9", "--output", "a.xyz"});
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.errors.find("a.xyz: the ending is none of") != std::string::npos, outcome.errors.c_str());
        const Outcome folder = morph(cantilever, {"--bend", "9"}, "no/such/folder/out.step");
        QCOMPARE(folder.status, 1);
    }
};

QTEST_GUILESS_MAIN(MorphCommandTest)
#include "morph_command_test.moc"
