#include "app/first_recipe.h"

#include "support/shapes.h"

#include <QtTest>
#include <nlohmann/json.hpp>

using namespace knead;

class FirstRecipeTest : public QObject {
    Q_OBJECT
private slots:
    void partsFarAwayAreHeldAndPressed();
};

/// Four digits of a place 20 m away would be centimetres.
void FirstRecipeTest::partsFarAwayAreHeldAndPressed()
{
    const Vec3 size(0.1, 0.02, 0.01);
    const auto boxOfRecipe = [&](const Vec3& away) {
        Part part;
        part.mesh = shapes::moved(shapes::box(size), {away, Quaternion::Identity()});
        part.box = Box(away - 0.5 * size, away + 0.5 * size);
        part.volume = size.prod();
        part.area = 2 * (0.1 * 0.02 + 0.02 * 0.01 + 0.01 * 0.1);
        part.watertight = true;
        Model model;
        model.parts.push_back(part);
        return nlohmann::json::parse(firstRecipe(model, "bar.step"));
    };
    const nlohmann::json here = boxOfRecipe(Vec3::Zero());
    const nlohmann::json there = boxOfRecipe({20, -14, 4});
    const std::array<double, 3> away{20'000, -14'000, 4000};
    const auto& held = there.at("fixtures")[0].at("box_mm");
    const auto& block = there.at("manipulators")[0].at("position_mm");
    for (std::size_t i = 0; i < 6; ++i)
        QVERIFY(std::abs(held[i].get<double>() - away.at(i % 3) -
                         here.at("fixtures")[0].at("box_mm")[i].get<double>()) < 0.1);
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY(std::abs(block[i].get<double>() - away.at(i) -
                         here.at("manipulators")[0].at("position_mm")[i].get<double>()) < 0.1);
}

QTEST_APPLESS_MAIN(FirstRecipeTest)
#include "first_recipe_test.moc"
