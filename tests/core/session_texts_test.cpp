#include "core/session/csv.h"
#include "core/session/measurement_text.h"
#include "core/session/part_filling.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace knead;

namespace {

/// Two boxes of 20 x 10 x 5 mm, 60 mm apart, each with six faces of two triangles.
FilledModel twoBoxes()
{
    FilledModel content;
    for (const char* name : {"lid", "lid 2"}) {
        auto body = std::make_shared<FilledBody>();
        body->name = name;
        body->mesh = shapes::moved(shapes::box({0.02, 0.01, 0.005}),
                                   {.position = {0.06 * static_cast<double>(content.bodies.size()), 0, 0}});
        for (std::uint32_t t = 0; t < body->mesh.triangles.size(); ++t)
            body->mesh.faceOfTriangle.push_back(t / 2);
        content.bodies.push_back(std::move(body));
    }
    return content;
}

} // namespace

/// What people write for the session, and what it writes for them.
class SessionTextsTest : public QObject {
    Q_OBJECT

private slots:
    void waysOfMeasuringAreRead()
    {
        const FilledModel content = twoBoxes();
        const Measurement distance = measurementOf("distance 0,0,2.5 60,0,2.5", content);
        QVERIFY(distance.kind == MeasureKind::distance);
        QCOMPARE(distance.places.size(), std::size_t{2});
        QCOMPARE(distance.places[0].body, BodyId{0});
        QCOMPARE(distance.places[1].body, BodyId{1});
        for (const char* text : {"face-radius \"lid 2\":3", "face-radius #1:3"}) {
            const Measurement radius = measurementOf(text, content);
            QCOMPARE(radius.places.at(0).body, BodyId{1});
            QCOMPARE(content.bodies[1]->mesh.faceOfTriangle[radius.places[0].triangle], 3U);
        }
        QCOMPARE(wordFor(MeasureKind::distanceToFace), std::string("distance-to-face"));
    }

    void whatIsNotUnderstoodIsRefused_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("why");
        QTest::newRow("nothing") << ""
                                 << "it begins with none of point, distance";
        QTest::newRow("no way") << "girth 1,2,3"
                                << "it begins with none of";
        QTest::newRow("half a place") << "point 1,2"
                                      << "three coordinates in mm";
        QTest::newRow("no number") << "point 1,nan,2"
                                   << "three coordinates in mm";
        QTest::newRow("too few") << "angle 0,0,0 1,1,1"
                                 << "angle takes 3 places or faces";
        QTest::newRow("too many") << "point 0,0,0 1,1,1"
                                  << "point takes 1 places";
        QTest::newRow("metres") << "point 0,0,900"
                                << "lies far away";
        QTest::newRow("whose face") << "face-radius 3"
                                    << "#0:3";
        QTest::newRow("no body") << "face-radius pin:3"
                                 << "there is no body \"pin\"; there are: \"lid\", \"lid 2\"";
        QTest::newRow("no face") << "face-radius lid:6"
                                 << "there is no face lid:6";
    }

    void whatIsNotUnderstoodIsRefused()
    {
        QFETCH(QString, text);
        QFETCH(QString, why);
        try {
            measurementOf(text.toStdString(), twoBoxes());
            QFAIL("It was taken.");
        } catch (const Problem& problem) {
            QVERIFY2(QString(problem.what()).contains(why), problem.what());
        }
    }

    void fieldsOfTablesAreQuoted()
    {
        QCOMPARE(csvField("tip"), std::string("tip"));
        QCOMPARE(csvField("tip, left"), std::string("\"tip, left\""));
        QCOMPARE(csvField("2\" pipe"), std::string("\"2\"\" pipe\""));
        QCOMPARE(csvNumber(0.1), std::string("0.1"));
        QVERIFY(csvNumber(std::numeric_limits<double>::quiet_NaN()).empty());
    }

    void fillingsAreFinerForThinWalls()
    {
        const auto spacingOfBox = [](const Vec3& size) {
            Model model;
            model.parts.resize(1);
            model.parts[0].mesh = shapes::box(size);
            model.parts[0].watertight = true;
            const std::vector<std::size_t> parts = partsToFill(model, false);
            const FillingSizes sizes = fillingSizes(model, parts, {}, TaskControl::none());
            const SpacingChoice none{SpacingChoice::Kind::Length, 0};
            if (spacingOf(none, sizes) != automaticSpacing(sizes))
                return 0.0;
            return automaticSpacing(sizes);
        };
        const double cube = spacingOfBox({0.03, 0.03, 0.03});
        QVERIFY2(std::abs(std::pow(0.03 / cube, 3) / 3000 - 1) < 0.3, std::to_string(cube).c_str());
        const double sheet = spacingOfBox({0.06, 0.06, 0.0045}); // nearly two cells with as many objects
        QVERIFY2(0.0045 / sheet > 1.9 && 0.0045 / sheet < 3.2, std::to_string(sheet).c_str());
        Model open;
        open.parts.resize(1);
        open.parts[0].mesh = shapes::box({1, 1, 1});
        QVERIFY(partsToFill(open, false).empty());
        QCOMPARE(partsToFill(open, true).size(), std::size_t{1});
    }
};

QTEST_APPLESS_MAIN(SessionTextsTest)
#include "session_texts_test.moc"
