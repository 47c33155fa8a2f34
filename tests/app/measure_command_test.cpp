// knead measure, knead compare, and probes in recipes.
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "support/pressed_part.h"
#include "support/workshop.h"

#include <QtTest>

using namespace knead;
using namespace knead::sessions;
using namespace workshop;

namespace {

constexpr const char* bar = KNEAD_RESOURCES "/examples/bar.step"; // 160 x 20 x 20 mm

const json& measured(const json& report, const std::string& of, const std::string& reading)
{
    static const json none;
    for (const json& one : report.at("measurements"))
        if (one.at("of") == of)
            for (const json& value : one.at("readings"))
                if (value.at("name") == reading)
                    return value;
    return none;
}

} // namespace

class MeasureCommandTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { writeProject(m_shop.path("bar.knead"), packed(pressedPart(bar, 0.004))); }

    void filesAreMeasuredAsTheyAre()
    {
        const Outcome outcome = workshop::runKnead({"measure", bar, "--json", "-m", "distance 0,0,0 100,0,0", "-m",
                                                    "angle 100,0,0 0,0,0 0,20,0", "-m", "distance-to-face 0,0,0 0"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json report = json::parse(outcome.out);
        QVERIFY(report.at("entry").is_null());
        const json info = json::parse(workshop::runKnead({"info", bar, "--json"}).out).at("parts")[0];
        const std::string name = info.at("name");
        const auto near = [](const json& value, double wanted) {
            return std::abs(value.at("now").get<double>() - wanted) < 1e-6 * std::max(1.0, std::abs(wanted));
        };
        const json& box = info.at("bbox_mm");
        QVERIFY(near(measured(report, name, "Size X"), box[3].get<double>() - box[0].get<double>()));
        QVERIFY(near(measured(report, name, "Volume"), info.at("volume_mm3").get<double>()));
        QVERIFY(measured(report, name, "Mass").is_null()); // a file has no material
        QVERIFY(near(measured(report, "distance 0,0,0 100,0,0", "Distance"), 100));
        QVERIFY(near(measured(report, "angle 100,0,0 0,0,0 0,20,0", "Angle"), 90));
        QVERIFY(!measured(report, "distance-to-face 0,0,0 0", "Distance").is_null());
    }

    void projectsAreMeasuredAtAnEntry()
    {
        const auto run = [&](const QStringList& more) {
            const Outcome outcome =
                workshop::runKnead(QStringList{"measure", m_shop.qPath("bar.knead"), "--json"} + more);
            return outcome.status == 0 ? json::parse(outcome.out) : json();
        };
        const json before = run({"--entry", "0"});
        const json after = run({});
        QVERIFY(!before.is_null() && !after.is_null());
        const std::string name = after.at("measurements")[0].at("of");
        QCOMPARE(before.at("time_s").get<double>(), 0.0);
        QVERIFY(after.at("time_s").get<double>() > 0);
        const json& mass = measured(after, name, "Mass");
        QVERIFY(mass.at("now").get<double>() > 0);
        QCOMPARE(mass.at("now").get<double>(), mass.at("at_rest").get<double>());
        const json& height = measured(after, name, "Size Z");
        QVERIFY(height.at("now") != height.at("at_rest"));
        QCOMPARE(measured(before, name, "Size Z").at("now"), height.at("at_rest"));
        QCOMPARE(workshop::runKnead({"measure", m_shop.qPath("bar.knead"), "--entry", "99"}).status, 2);
    }

    void projectsAreComparedWithTheirOriginal()
    {
        const Outcome outcome =
            workshop::runKnead({"compare", m_shop.qPath("bar.knead"), "--json", "--report", m_shop.qPath("bar.html")});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json body = json::parse(outcome.out).at("bodies")[0];
        QVERIFY(body.at("largest_distance_mm").get<double>() > 1e-3);
        QVERIFY(body.at("largest_displacement_mm") >= body.at("largest_distance_mm"));
        QVERIFY(body.at("mean_distance_mm") < body.at("largest_distance_mm"));
        QFile page(m_shop.qPath("bar.html"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray html = page.readAll();
        QVERIFY(html.contains("data:image/png;base64,") && html.contains("Largest distance"));
        QCOMPARE(workshop::runKnead({"compare", m_shop.qPath("bar.knead"), "--report", m_shop.qPath("bar.pdf")}).status,
                 0);
        QFile pdf(m_shop.qPath("bar.pdf"));
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        QVERIFY(pdf.read(5) == "%PDF-");
    }

    /// Two boxes, the one higher by 1 mm.
    void filesAreComparedWithEachOther()
    {
        const auto box = [&](const char* name, double height) {
            std::ofstream file(m_shop.path(name));
            file << "solid box\n" << boxFacets({0, 0, 0}, {20, 10, height}) << "endsolid\n";
        };
        box("before.stl", 5);
        box("after.stl", 6);
        const Outcome outcome =
            workshop::runKnead({"compare", m_shop.qPath("before.stl"), m_shop.qPath("after.stl"), "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json body = json::parse(outcome.out).at("bodies")[0];
        QVERIFY(std::abs(body.at("largest_distance_mm").get<double>() - 1) < 1e-6);
        QVERIFY(body.at("largest_displacement_mm").is_null()); // nobody followed the points
        QVERIFY(std::abs(body.at("volume_before_mm3").get<double>() - 1000) < 1e-6);
        QVERIFY(std::abs(body.at("volume_mm3").get<double>() - 1200) < 1e-6);
        // By area: the lid of 200 mm2 at 1 mm, and the last 1 mm of the walls, of 760 mm2 in all.
        const double mean = body.at("mean_distance_mm").get<double>();
        QVERIFY2(mean > 200 / 760.0 && mean < 300 / 760.0, std::to_string(mean).c_str());
    }

    void anAssemblyIsAsFarFromItselfAsNothing()
    {
        const QString bracket = KNEAD_RESOURCES "/examples/bracket.step";
        const Outcome same = workshop::runKnead({"compare", bracket, bracket, "--json"});
        QVERIFY2(same.status == 0, same.errors.c_str());
        const json bodies = json::parse(same.out).at("bodies");
        QCOMPARE(bodies.size(), std::size_t{2});
        for (const json& body : bodies)
            QVERIFY(body.at("largest_distance_mm").get<double>() < 1e-9);
        const Outcome other = workshop::runKnead({"compare", bar, bracket, "--json"});
        QVERIFY2(other.status == 0, other.errors.c_str());
        QCOMPARE(json::parse(other.out).at("only_in_changed").size(), std::size_t{1});
        QVERIFY2(other.errors.find("belongs to no closed part of the original") != std::string::npos,
                 other.errors.c_str());
    }

    void bodiesAreNamedWithBlanks()
    {
        const QString bracket = KNEAD_RESOURCES "/examples/bracket.step";
        for (const char* face : {"face-radius \"Bushing\":0", "face-radius #1:0"}) {
            const Outcome outcome = workshop::runKnead({"measure", bracket, "-m", face});
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        }
        QCOMPARE(workshop::runKnead({"measure", bracket, "-m", "face-radius \"Bushing 2\":0"}).status, 2);
        QCOMPARE(workshop::runKnead({"compare", bracket, bracket, "--entry", "1"}).status, 2);
        const Outcome unclear = workshop::runKnead({"measure", bracket, "-m", "face-radius 1"});
        QCOMPARE(unclear.status, 2);
        QVERIFY2(unclear.errors.find("#0:1") != std::string::npos, unclear.errors.c_str());
        const Outcome far = workshop::runKnead({"measure", bracket, "-m", "point 0,0,900"});
        QCOMPARE(far.status, 2);
        QVERIFY2(far.errors.find("lies far away") != std::string::npos, far.errors.c_str());
        QCOMPARE(workshop::runKnead({"measure", bracket, "-m", "point 0,nan,0"}).status, 2);
    }

    void probesOfARecipeAreRead()
    {
        write("probed.recipe.json",
              R"({"version": 1, "part": {"file": "BAR"}, "objects": 400, "material": {"preset": "silicone-rubber"},
            "fixtures": [{"name": "end", "box_mm": [-1, -1, -1, 30, 21, 21]}],
            "manipulators": [{"name": "block", "size_mm": [20, 24, 5], "position_mm": [90, 10, 23],
                "keyframes": [{"time_s": 0.2, "position_mm": [90, 10, 17]}]}],
            "probes": [{"name": "tip", "place_mm": [100, 10, 0]}, {"name": "root", "place_mm": [0, 10, 0]}],
            "duration_s": 0.2})");
        const Outcome outcome = workshop::runKnead({"run", m_shop.qPath("probed.recipe.json"), "--json", "--out",
                                                    m_shop.qPath("out"), "--probes", m_shop.qPath("probes.csv")});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json probes = json::parse(outcome.out).at("probes");
        QCOMPARE(probes.size(), std::size_t{2});
        QCOMPARE(probes[0].at("name").get<std::string>(), std::string("tip"));
        QVERIFY(probes[0].at("displacement_mm").get<double>() > 2);
        QVERIFY(probes[1].at("displacement_mm").get<double>() <
                0.02 * probes[0].at("displacement_mm").get<double>()); // held
        QVERIFY(probes[1].at("von_mises_pa").get<double>() > 0);
        std::ifstream file(m_shop.path("probes.csv"));
        std::string head;
        std::getline(file, head);
        QVERIFY(head.starts_with("time [s],tip displacement [mm],"));
        int rows = 0;
        for (std::string line; std::getline(file, line);)
            ++rows;
        QVERIFY2(rows >= 12, std::to_string(rows).c_str()); // one per 1/60 s, and the start
    }

    void aProbeOfNothingIsRefused()
    {
        write("none.recipe.json", R"({"version": 1, "part": {"file": "BAR"}, "objects": 300, "duration_s": 0.01})");
        const Outcome none = workshop::runKnead({"run", m_shop.qPath("none.recipe.json"), "--out", m_shop.qPath("out"),
                                                 "--probes", m_shop.qPath("none.csv")});
        QCOMPARE(none.status, 2);
        QVERIFY(!QFile::exists(m_shop.qPath("none.csv")));
        write("lost.recipe.json", R"({"version": 1, "part": {"file": "BAR"}, "objects": 300,
            "probes": [{"name": "tip", "body": "lid", "place_mm": [0, 0, 0]}], "duration_s": 0.01})");
        const Outcome outcome =
            workshop::runKnead({"run", m_shop.qPath("lost.recipe.json"), "--out", m_shop.qPath("out")});
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.errors.find("the probe \"tip\" names the body \"lid\"") != std::string::npos,
                 outcome.errors.c_str());
    }

private:
    void write(const char* name, const char* recipe)
    {
        QFile file(m_shop.qPath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(recipe).replace("BAR", bar));
    }

    Workshop m_shop;
};

QTEST_APPLESS_MAIN(MeasureCommandTest)
#include "measure_command_test.moc"
