#include "core/session/pace_watch.h"
#include "core/simulation/run_quality.h"
#include "support/workshop.h"

#include <QtTest>

#include <future>

using workshop::json;
using workshop::Outcome;
using workshop::pressRecipe;
using workshop::Workshop;

/// What a run says of itself.
class RunWordsTest : public QObject {
    Q_OBJECT

private slots:
    void aRunThatGoesOnIsNotSlow()
    {
        using knead::slownessOf;
        QVERIFY(slownessOf({0, 1e-5, 0}, {0.2, 1e-5, 0.001}, 4).empty());  // a twentieth of real time
        QVERIFY(slownessOf({0, 1e-7, 0}, {1e-3, 1e-7, 0.5}, 4).empty());   // soon over
        QVERIFY(!slownessOf({0, 1e-7, 0}, {1e-3, 1e-7, 0.01}, 4).empty()); // 400 s are left
        QVERIFY(!slownessOf({0, 1e-7, 0}, {0, 1e-7, 0}, 4).empty());       // not even one step
    }

    void slownessIsSaidWithItsNumbers()
    {
        const std::string said = knead::slownessOf({0.1, 2e-7, 0.1}, {0.104, 2e-7, 0.104}, 4);
        QVERIFY2(said.find("0.004 s were simulated in 4 s, in steps of 2e-07 s") != std::string::npos, said.c_str());
        // 0.896 of the whole at 0.001 a second
        QVERIFY2(said.find("the rest of the run would take 15 minutes") != std::string::npos, said.c_str());
    }

    void theWatchSpeaksWithoutAStep()
    {
        std::promise<std::string> said;
        knead::PaceWatch watch([&](const std::string& sentence) { said.set_value(sentence); },
                               std::chrono::milliseconds(20));
        const std::string sentence = said.get_future().get();
        QVERIFY2(sentence.find("it may not end") != std::string::npos, sentence.c_str());
    }

    void remarksComeWhenTheyAreDue()
    {
        QVERIFY(knead::remarksOn({.penetration = 0.1, .imbalance = 0.009, .steps = 100}).empty());
        const auto remarks = knead::remarksOn(
            {.penetration = 0.83, .imbalance = 0.2, .addedMass = 0.25, .unsolvedSteps = 3, .steps = 100});
        QCOMPARE(remarks.size(), std::size_t{4});
        QVERIFY2(remarks[0].sentence.english().find("3 of 100 steps could not be solved") != std::string::npos,
                 remarks[0].sentence.english().c_str());
        QVERIFY2(remarks[1].sentence.english().find("off by 20 %") != std::string::npos,
                 remarks[1].sentence.english().c_str());
        QVERIFY2(remarks[2].sentence.english().find("0.83 spacings") != std::string::npos,
                 remarks[2].sentence.english().c_str());
        QVERIFY2(remarks[3].sentence.english().find("25 % of the mass") != std::string::npos,
                 remarks[3].sentence.english().c_str());
    }

    void theReportTellsHowFarItMayBeTrusted()
    {
        const Workshop shop;
        json recipe = pressRecipe();
        recipe.erase("exports");
        recipe["mass_scaling_time_step_s"] = 0.01;
        recipe["duration_s"] = 0.1;
        const Outcome outcome = workshop::runKnead({"run", shop.write(recipe), "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json report = json::parse(outcome.out);
        const json& quality = report.at("quality");
        QVERIFY(quality.at("penetration_spacings").get<double>() > 0);
        QVERIFY(quality.at("penetration_spacings").get<double>() < 1);
        QVERIFY(quality.at("imbalance_share").get<double>() >= 0);
        QCOMPARE(quality.at("added_mass_share"), report.at("added_mass"));
        QVERIFY(quality.at("added_mass_share").get<double>() > 0.01);
        QCOMPARE(quality.at("steps_not_converged").get<int>(), 0);
        bool isSaid = false;
        for (const json& warning : report.at("warnings"))
            isSaid = isSaid || warning.get<std::string>().find("Mass scaling made") != std::string::npos;
        QVERIFY(isSaid);
        QVERIFY(outcome.errors.find("Mass scaling made") != std::string::npos);
    }

    /// Nothing in the file is wrong: the failure comes in the midst of the run, and what was known then is told.
    void aRunThatFailsStillReports()
    {
        const Workshop shop;
        json recipe = pressRecipe();
        recipe["manipulators"] = json::array();
        recipe["gravity_m_s2"] = {0, 0, -10000};
        recipe["material"] = {{"youngs_modulus_pa", 1e4}, {"damping_ratio", 0.1}, {"density_kg_m3", 2000}};
        recipe["integrator"] = "semi-implicit-euler";
        recipe["duration_s"] = 5;
        const Outcome outcome =
            workshop::runKnead({"run", shop.write(recipe), "--json", "--csv", shop.qPath("forces.csv")});
        QCOMPARE(outcome.status, 1);
        const json report = json::parse(outcome.out);
        const std::string sentence = report.at("failure").at("sentence");
        QVERIFY2(sentence.find("The simulation was stopped at") != std::string::npos, sentence.c_str());
        QVERIFY2(sentence.find("Lower gravity or raise the damping ratio") != std::string::npos, sentence.c_str());
        QVERIFY2(report.at("failure").at("kind") != "failed", report.dump().c_str());
        QVERIFY(outcome.errors.find(sentence) != std::string::npos);
        QVERIFY(report.at("simulated_s").get<double>() < 5);
        QCOMPARE(report.at("bodies").size(), std::size_t{1});
        QVERIFY(report.at("files").empty());
        QVERIFY(QFile::exists(shop.qPath("forces.csv")));
    }

    void aRunThatCannotBeginReportsWhy()
    {
        const Workshop shop;
        json recipe = pressRecipe();
        recipe["spacing_mm"] = 1e-4; // more objects than any machine takes
        const Outcome outcome = workshop::runKnead({"run", shop.write(recipe), "--json"});
        QCOMPARE(outcome.status, 1);
        const std::string sentence = json::parse(outcome.out).at("failure").at("sentence");
        QVERIFY2(outcome.errors.find(sentence) != std::string::npos, outcome.errors.c_str());
    }

    /// The bar is 10 mm thick.
    void cellsAcrossTheThinnestWallAreSaid_data()
    {
        QTest::addColumn<double>("spacing");
        QTest::addColumn<double>("cells");
        QTest::addColumn<double>("error"); ///< 0: not known
        QTest::addColumn<QString>("words");
        QTest::newRow("fine") << 5.0 << 2.0 << 0.15 << QString();
        QTest::newRow("rough") << 6.25 << 1.6 << 0.4 << QString("bending of such walls comes out up to 40 % too stiff");
        QTest::newRow("coarse") << 8.0 << 1.25 << 0.9 << QString("comes out up to 90 % too stiff");
        QTest::newRow("missing") << 12.5 << 0.8 << 0.0 << QString("comes out many times too stiff");
    }
    void cellsAcrossTheThinnestWallAreSaid()
    {
        QFETCH(double, spacing);
        QFETCH(double, cells);
        QFETCH(double, error);
        QFETCH(QString, words);
        const Workshop shop;
        json recipe = pressRecipe();
        recipe.erase("exports");
        recipe.erase("fixtures");
        recipe["manipulators"] = json::array();
        recipe["spacing_mm"] = spacing;
        recipe["duration_s"] = 0.01;
        const Outcome outcome = workshop::runKnead({"run", shop.write(recipe), "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json quality = json::parse(outcome.out).at("quality");
        QVERIFY(std::abs(quality.at("cells_across_thinnest_wall").get<double>() - cells) < 1e-6);
        const json& known = quality.at("wall_bending_too_stiff_share");
        QVERIFY(error == 0 ? known.is_null() : std::abs(known.get<double>() - error) < 1e-9);
        QCOMPARE(outcome.errors.find("Thinnest walls") != std::string::npos, !words.isEmpty());
        QVERIFY2(outcome.errors.find(words.toStdString()) != std::string::npos, outcome.errors.c_str());
        if (!words.isEmpty())
            QVERIFY2(outcome.errors.find("Fill with a spacing of 5 mm for 2 cells") != std::string::npos,
                     outcome.errors.c_str());
    }

    void aToolThatBeginsInsideIsSaidOnce()
    {
        const Workshop shop;
        json recipe = pressRecipe();
        recipe.erase("exports");
        recipe["manipulators"][0]["position_mm"] = {35, 5, 10};
        recipe["manipulators"][0].erase("keyframes");
        recipe["duration_s"] = 0.01;
        const Outcome outcome = workshop::runKnead({"run", shop.write(recipe), "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const std::string sentence = "The tool \"press\" begins 3 mm inside \"bar\"";
        const std::size_t said = outcome.errors.find(sentence);
        QVERIFY2(said != std::string::npos, outcome.errors.c_str());
        QVERIFY(outcome.errors.find(sentence, said + 1) == std::string::npos);
        QVERIFY(outcome.out.find("begins 3 mm inside") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(RunWordsTest)
#include "run_words_test.moc"
