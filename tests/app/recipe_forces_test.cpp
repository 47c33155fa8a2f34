#include "support/workshop.h"

#include <QtTest>

#include <cmath>
#include <vector>

using namespace workshop;

/// Forces in and out of runs, and balance.
class RecipeForcesTest : public QObject {
    Q_OBJECT

private slots:
    void forcesComeOutAsReportAndTable();
    void aStaticRecipeFindsBalance();
    void momentsAreAboutTheStatedPoint();
    void whatIsFreeEndsWithStatusOneAndARemedy();
    void loadsAreAddedChangedAndTakenAway();
    void gripsTurnAsTheRecipeSays();
    void recipesThatDoNotFitAreRefused();
};

namespace {

constexpr double area = 1e-4;   // [m^2]
constexpr double length = 0.04; // [m]
constexpr double modulus = 1e6; // [Pa]

/// The bar held at x = 0 with a load on its other end.
json loadedRecipe(const json& load)
{
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe.erase("manipulators");
    recipe["material"] = {{"youngs_modulus_pa", modulus}, {"poisson_ratio", 0.25}, {"density_kg_m3", 1000}};
    recipe["loads"] = json::array({load});
    recipe["loads"][0]["name"] = "pull";
    recipe["loads"][0]["box_mm"] = {39.99, -1, -1, 41, 11, 11};
    recipe["duration_s"] = 1;
    return recipe;
}

json staticRecipe(const json& load)
{
    json recipe = loadedRecipe(load);
    recipe["analysis"] = "static";
    recipe["load_steps"] = 2;
    recipe["loads"][0]["ramp_s"] = 1;
    return recipe;
}

std::vector<std::vector<std::string>> rowsOf(const std::string& path)
{
    std::ifstream file(path);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        auto& row = rows.emplace_back();
        std::stringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');)
            row.push_back(field);
    }
    return rows;
}

} // namespace

void RecipeForcesTest::forcesComeOutAsReportAndTable()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json", "--csv", shop.qPath("forces.csv")});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    const json& fixture = report.at("fixtures").at(0);
    QCOMPARE(fixture.at("name").get<std::string>(), std::string("end"));
    QVERIFY(fixture.at("force_n")[2].get<double>() < 0); // the bar is pushed down, and pushes the fixture down
    QVERIFY(fixture.at("moment_nm")[1].get<double>() > 0);
    QVERIFY(fixture.at("peak_force_n").get<double>() >= std::abs(fixture.at("force_n")[2].get<double>()));
    QVERIFY(report.at("tools")[0].at("peak_torque_nm").get<double>() >= 0);
    QCOMPARE(report.at("forces_csv").get<std::string>(), shop.path("forces.csv"));
    QVERIFY(report.at("loads").empty() && !report.contains("static"));

    const auto rows = rowsOf(shop.path("forces.csv"));
    QCOMPARE(rows[0].size(), std::size_t(13));
    QCOMPARE(rows[0][0], std::string("time [s]"));
    QCOMPARE(rows[0][3], std::string("end Fz [N]"));
    QCOMPARE(rows[0][5], std::string("end My [N m]"));
    QCOMPARE(rows[0][7], std::string("press Fx [N]"));
    QVERIFY(rows.size() >= 12 && rows.size() <= 14); // every 1/60 s
    QVERIFY(std::abs(std::stod(rows.back()[0]) - report.at("simulated_s").get<double>()) < 1e-6);
    QVERIFY(std::abs(std::stod(rows.back()[3]) - fixture.at("force_n")[2].get<double>()) < 1e-6);
    QVERIFY(std::abs(std::stod(rows.back()[9]) - report.at("tools")[0].at("force_n")[2].get<double>()) <
            0.02 * std::abs(std::stod(rows.back()[9])));
}

void RecipeForcesTest::aStaticRecipeFindsBalance()
{
    const Workshop shop;
    const double force = 1e-3 * modulus * area;
    const Outcome outcome = runKnead({"run", shop.write(staticRecipe({{"force_n", {force, 0, 0}}})), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    // P L / E A, and the end whose objects are held does not contract.
    const double longest = report.at("bodies")[0].at("largest_displacement_mm");
    QVERIFY2(std::abs(longest - 1e-3 * 1000 * length) < 0.03e-3 * 1000 * length, std::to_string(longest).c_str());
    QCOMPARE(report.at("static").size(), std::size_t(2));
    QVERIFY(report.at("static")[1].at("residual").get<double>() <= 1e-7);
    QVERIFY(std::abs(report.at("fixtures")[0].at("force_n")[0].get<double>() - force) < 1e-5 * force);
    QVERIFY(std::abs(report.at("loads")[0].at("force_n")[0].get<double>() - force) < 1e-12 * force);
    QCOMPARE(report.at("energy_j").at("kinetic").get<double>(), 0.0);
    QCOMPARE(report.at("steps").get<int>(), 2);
    QCOMPARE(report.at("simulated_s").get<double>(), 1.0);
}

void RecipeForcesTest::momentsAreAboutTheStatedPoint()
{
    const Workshop shop;
    json recipe = staticRecipe({{"force_n", {0, 0, -0.001}}});
    recipe["fixtures"][0]["moment_center_mm"] = {0, 5, 5};
    const json report = json::parse(runKnead({"run", shop.write(recipe), "--json"}).out);
    const json& fixture = report.at("fixtures")[0];
    QCOMPARE(fixture.at("moment_center_mm"), (json{0.0, 5.0, 5.0}));
    QVERIFY(std::abs(fixture.at("moment_nm")[1].get<double>() - 0.001 * length) < 1e-3 * 0.001 * length);
}

void RecipeForcesTest::whatIsFreeEndsWithStatusOneAndARemedy()
{
    const Workshop shop;
    json recipe = staticRecipe({{"force_n", {1, 0, 0}}});
    recipe.erase("fixtures");
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json"});
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.errors.find("is free to move: hold it, or let time run (dynamic)") != std::string::npos,
             outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QVERIFY(report.at("failure").at("sentence").get<std::string>().find("hold it") != std::string::npos);
    QCOMPARE(report.at("steps").get<int>(), 0);
}

void RecipeForcesTest::loadsAreAddedChangedAndTakenAway()
{
    const Workshop shop;
    json recipe = loadedRecipe({{"pressure_pa", 100}});
    recipe["integrator"] = "implicit-euler";
    json second = recipe["loads"][0];
    second["name"] = "twist, \"hard\"";
    second.erase("pressure_pa"); // whose moment would be about where the end was at rest
    second["moment_nm"] = {0.001, 0, 0};
    recipe["events"] = {{{"time_s", 0.2}, {"add_load", second}},
                        {{"time_s", 0.5}, {"change_load", {{"name", "pull"}, {"force_n", {0.02, 0, 0}}}}},
                        {{"time_s", 0.8}, {"remove_load", "twist, \"hard\""}}};
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json", "--csv", shop.qPath("forces.csv")});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QCOMPARE(report.at("loads").size(), std::size_t(2));
    QVERIFY(std::abs(report.at("loads")[0].at("force_n")[0].get<double>() - 0.02) < 1e-12);
    QVERIFY(std::abs(report.at("loads")[1].at("moment_nm")[0].get<double>() - 0.001) < 1e-9);
    std::ifstream table(shop.path("forces.csv"));
    std::string header;
    std::getline(table, header);
    QVERIFY(header.find("\"twist, \"\"hard\"\" Fx [N]\"") != std::string::npos);
    const auto last = rowsOf(shop.path("forces.csv")).back();
    QCOMPARE(std::count_if(last.begin(), last.end(), [](const std::string& field) { return !field.empty(); }), 13);
}

void RecipeForcesTest::gripsTurnAsTheRecipeSays()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe.erase("manipulators");
    recipe["integrator"] = "implicit-euler";
    recipe["fixtures"].push_back(
        {{"name", "grip"},
         {"box_mm", {38, -1, -1, 41, 11, 11}},
         {"turn", {{"center_mm", {40, 5, 5}}, {"axis", {2, 0, 0}}, {"speed_deg_s", 300}, {"angle_deg", 30}}}});
    recipe["duration_s"] = 0.5;
    const json report = json::parse(runKnead({"run", shop.write(recipe), "--json"}).out);
    // Corners of the gripped end are sqrt(50) mm from the axis: a chord of 2 r sin 15 degrees.
    const double largest = report.at("bodies")[0].at("largest_displacement_mm");
    QVERIFY2(std::abs(largest - 2 * std::sqrt(50.0) * std::sin(15 * M_PI / 180)) < 1e-6,
             std::to_string(largest).c_str());
    QVERIFY(report.at("fixtures")[1].at("moment_nm")[0].get<double>() < 0);
    const double sum = report.at("fixtures")[1].at("moment_nm")[0].get<double>() +
                       report.at("fixtures")[0].at("moment_nm")[0].get<double>();
    QVERIFY(std::abs(sum) < 0.01 * report.at("fixtures")[1].at("peak_moment_nm").get<double>());
}

void RecipeForcesTest::recipesThatDoNotFitAreRefused()
{
    const Workshop shop;
    json recipe = loadedRecipe({{"pressure_pa", 100}});
    recipe["loads"][0]["box_mm"] = {50, 50, 50, 60, 60, 60};
    const Outcome nothing = runKnead({"run", shop.write(recipe)});
    QCOMPARE(nothing.status, 2);
    QVERIFY2(nothing.errors.find("acts on nothing") != std::string::npos, nothing.errors.c_str());
    recipe["loads"][0].erase("box_mm");
    recipe["loads"][0]["faces"] = {7};
    const Outcome faces = runKnead({"run", shop.write(recipe)});
    QCOMPARE(faces.status, 2);
    QVERIFY2(faces.errors.find("face") != std::string::npos, faces.errors.c_str());
    const Outcome table =
        runKnead({"run", shop.write(staticRecipe({{"pressure_pa", 1}})), "--csv", "/nowhere/forces.csv"});
    QCOMPARE(table.status, 1);
    QVERIFY2(table.errors.find("--csv") != std::string::npos, table.errors.c_str());
}

QTEST_GUILESS_MAIN(RecipeForcesTest)
#include "recipe_forces_test.moc"
