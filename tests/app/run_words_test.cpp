#include "app/pace_watch.h"
#include "app/run_quality.h"
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
        QVERIFY(knead::remarksOn({.penetration = 0.3, .imbalance = 0.009, .steps = 100}).empty());
        const auto remarks = knead::remarksOn(
            {.penetration = 0.83, .imbalance = 0.2, .addedMass = 0.25, .unsolvedSteps = 3, .steps = 100});
        QCOMPARE(remarks.size(), std::size_t{4});
        QVERIFY2(remarks[0].find("3 of 100 steps could not be solved") != std::string::npos, remarks[0].c_str());
        QVERIFY2(remarks[1].find("off by 20 %") != std::string::npos, remarks[1].c_str());
        QVERIFY2(remarks[2].find("0.83 spacings") != std::string::npos, remarks[2].c_str());
        QVERIFY2(remarks[3].find("25 % of the mass") != std::string::npos, remarks[3].c_str());
    }

    void theReportTellsHowFarItMayBeTrusted()
    {
        const Workshop shop;
        json recipe = pressRecipe();
        recipe.erase("exports");
        recipe["mass_scaling_time_step_s"] = 0.01;
        recipe["duration_s"] = 0.1;
        const Outcome outcome = workshop::knead({"run", shop.write(recipe), "--json"});
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

    void aToolThatBeginsInsideIsSaidOnce()
    {
        const Workshop shop;
        json recipe = pressRecipe();
        recipe.erase("exports");
        recipe["manipulators"][0]["position_mm"] = {35, 5, 10};
        recipe["manipulators"][0].erase("keyframes");
        recipe["duration_s"] = 0.01;
        const Outcome outcome = workshop::knead({"run", shop.write(recipe), "--json"});
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
