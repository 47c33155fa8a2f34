#include "core/session/edge_sight.h"
#include "support/window_on_test.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/timeline_axis.h"
#include "ui/preferences/preferences.h"
#include "ui/run_window.h"
#include "ui/viewport/color_legend.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace knead;

/// What is seen of the material: what is shown, colors with their legend, the section plane, before and after.
class WindowDisplayTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare(Eyes::open);
    }

    void init()
    {
        QSettings().clear();
        show(m_services);
    }

    void cleanup() { m_window.reset(); }

    void colorsOfAStretchedBarAreThoseOfTheLegend()
    {
        stretchBar();
        choose("colorQuantity", "Displacement");
        QTRY_VERIFY(legend()->isVisible());
        QCOMPARE(legend()->text().title, QString("Displacement [mm]"));
        QCOMPARE(legend()->text().ticks.front().text, QString("0"));
        QVERIFY(legend()->text().ticks.size() >= 4);
        const ColorScale scale = *view().scale();
        const double most = document().frame()->bodies[0]->places[farthestVertex()].x() - 0.16;
        QCOMPARE(scale.least, 0.0);
        QVERIFY(scale.most >= most && scale.most < 1.36 * most);
        const QImage seen = shot();
        for (const double x : {0.02, 0.08, 0.14}) {
            const auto [place, moved] = onTop(x);
            QVERIFY(std::abs(moved - x / 0.16 * most) < 0.1 * most); // it stretches evenly
            verifyColor(seen, place, scale, moved);
        }
        bothThemes("displacement");

        choose("colorQuantity", "Strain");
        QTRY_COMPARE(legend()->text().title, QString("Strain [%]"));
        const double strain = std::log(1 + most / 0.16) / (1 + 1.0 / 3); // about; between free and held sides
        QTRY_VERIFY(view().scale() && view().scale()->quantity == SurfaceQuantity::strain);
        QVERIFY(view().scale()->most > strain);
        choose("colorQuantity", "Von Mises stress");
        QTRY_VERIFY(legend()->text().title.contains("Pa]"));
        choose("colorQuantity", "Distance to the original");
        QTRY_VERIFY(view().scale() && view().scale()->quantity == SurfaceQuantity::distance);
        QCOMPARE(view().scale()->least, -view().scale()->most);
        QCOMPARE(view().scale()->map, ColorMap::diverging);
        QVERIFY(!find<QComboBox>("colorMap")->isVisible());
        bothThemes("distance");
        choose("colorQuantity", "Part colors");
        QTRY_VERIFY(!legend()->isVisible());
        choose("colorQuantity", "Distance to the original"); // of the same moment once more
        QTRY_VERIFY(legend()->isVisible());
    }

    void fixedFacesStandOutFromColorsWhileTheyAreChosen()
    {
        stretchBar();
        choose("colorQuantity", "Displacement");
        QTRY_VERIFY(view().scale());
        const QPoint place = view().widgetPosition(onTop(0.08).first)->toPoint();
        const auto isLike = [&](const QColor& color) { return shot().pixelColor(place) == color; };
        const QColor plain = shot().pixelColor(place);
        const PickHit hit = view().hitAt(place);
        QCOMPARE(hit.kind, PickHit::Kind::Body);
        document().toggleFace(hit.id, hit.face);
        QTRY_VERIFY(!document().fixtures().list().empty());
        QVERIFY(isLike(plain));
        action("fixFaces")->setChecked(true);
        QVERIFY(!isLike(plain));
        action("fixFaces")->setChecked(false);
        QVERIFY(isLike(plain));
    }

    /// Or one would not see whether a click fixed it.
    void aFaceThatWasJustFixedIsNotCoveredByTheHighlight()
    {
        openExample("bar.step");
        action("fixFaces")->setChecked(true);
        const QPoint place = view()
                                 .widgetPosition(document().content().box.center() +
                                                 Vec3(0, 0, document().content().box.sizes().z() / 2))
                                 ->toPoint();
        const QPoint away(5, view().height() / 2);
        QTest::mouseMove(&view(), away);
        const QColor plain = shot().pixelColor(place);
        QTest::mouseMove(&view(), place);
        const QColor under = shot().pixelColor(place);
        QVERIFY(under != plain); // what a click would fix
        QTest::mouseClick(&view(), Qt::LeftButton, {}, place);
        QTRY_COMPARE(document().fixtures().list().size(), std::size_t{1});
        const QColor fixed = shot().pixelColor(place);
        QVERIFY(fixed != under && fixed != plain);
        QTest::mouseMove(&view(), place + QPoint(2, 0)); // still the same face
        QCOMPARE(shot().pixelColor(place), fixed);
        QTest::mouseMove(&view(), away);
        QCOMPARE(shot().pixelColor(place), fixed);
        QTest::mouseMove(&view(), place);
        QVERIFY(shot().pixelColor(place) != fixed);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, place);
        QTRY_VERIFY(document().fixtures().list().empty());
        QCOMPARE(shot().pixelColor(place), plain);
    }

    void aTypedRangeStaysAndHasUnits()
    {
        stretchBar();
        choose("colorQuantity", "Displacement");
        QTRY_VERIFY(view().scale());
        auto* automatic = find<QCheckBox>("automaticRange");
        QVERIFY(automatic->isChecked());
        click(automatic);
        QVERIFY(view().options().colors.range.has_value());
        type("rangeMost", "4 cm");
        QCOMPARE(view().options().colors.range->second, 0.04);
        QTRY_COMPARE(legend()->text().ticks.back().text, QString("40"));
        type("rangeLeast", "5 cm"); // beyond the other end
        QVERIFY(find<QuantityField>("rangeLeast")->hasProblem());
        QTest::keyClick(find<QuantityField>("rangeLeast"), Qt::Key_Escape);
        QCOMPARE(view().options().colors.range->first, 0.0);
        type("rangeLeast", "0,01 m");
        QCOMPARE(view().options().colors.range->first, 0.01);
        QTRY_COMPARE(legend()->text().ticks.front().text, QString("10"));
        Preferences chosen = readPreferences();
        chosen.lengthUnit = "in";
        m_window->features().preferences->set(chosen);
        QTRY_COMPARE(legend()->text().title, QString("Displacement [in]"));
        chosen.lengthUnit = "mm";
        m_window->features().preferences->set(chosen);
        QTRY_COMPARE(legend()->text().title, QString("Displacement [mm]"));
        choose("colorMap", "Cividis");
        QTRY_COMPARE(view().scale()->map, ColorMap::cividis);
        verifyColor(shot(), onTop(0.14).first, *view().scale(), onTop(0.14).second);
        click(automatic);
        QTRY_COMPARE(view().scale()->least, 0.0);
    }

    void shadingsShowTheShapeInTheirWays()
    {
        openExample("grip.step");
        for (const char* name : {"edges", "grid"})
            action(name)->setChecked(false);
        QCOMPARE(view().options().shading, Shading::usual);
        const QImage usual = shot();
        std::vector<QImage> seen;
        const QString folder = qEnvironmentVariable("KNEAD_PICTURES");
        for (const char* name : {"shadingUsual", "shadingClay", "shadingPolished", "shadingZebra", "shadingCurvature",
                                 "shadingWax", "shadingChrome", "shadingPorcelain"}) {
            action(name)->trigger();
            QCOMPARE(static_cast<std::size_t>(view().options().shading), seen.size());
            seen.push_back(shot());
            if (!folder.isEmpty())
                seen.back().save(QStringLiteral("%1/%2.png").arg(folder, name));
        }
        QCOMPARE(seen[0], usual);
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(shareOfOthers(seen[i], seen[j]) > 0.01);
        QVERIFY(mostStripes(seen[3]) >= 6);
        QVERIFY(mostStripes(seen[3]) > 2 * mostStripes(usual));
        QCOMPARE(QSettings().value("display/shading").toString(), QString("porcelain"));
        QCOMPARE(find<QComboBox>("shading")->currentText(), QString("Porcelain"));
        action("shadingZebra")->trigger();
        QCOMPARE(QSettings().value("display/shading").toString(), QString("zebra"));
        QCOMPARE(find<QComboBox>("shading")->currentText(), QString("Zebra"));

        choose("colorQuantity", "Displacement"); // numbers keep their colors
        QTRY_VERIFY(view().scale());
        const QImage values = shot();
        choose("shading", "Usual");
        QCOMPARE(view().options().shading, Shading::usual);
        QCOMPARE(shot(), values);
        choose("colorQuantity", "Part colors");
        QTRY_VERIFY(!view().scale());
        QCOMPARE(shot(), usual);
    }

    /// One sees how far it is, and where it will touch.
    void aHoveringBallDarkensThePartUnderIt()
    {
        openExample("bar.step", 24);
        for (const char* name : {"edges", "grid"})
            action(name)->setChecked(false);
        const Box box = document().content().box;
        const double size = 0.016;
        const auto ballAt = [&](double gap) {
            return Pose{Vec3(box.center().x(), box.center().y(), box.max().z() + gap + size / 2)};
        };
        Manipulator ball;
        ball.name = "ball";
        ball.kind = ToolKind::ball;
        ball.size = Vec3::Constant(size);
        ball.pose = ballAt(0.2);
        document().post(AddManipulator{ball});
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        rest();
        const Vec3 beside(box.center().x() - 0.006, box.center().y() - 0.004, box.max().z());
        const Vec3 far(box.min().x() + 0.01, box.center().y(), box.max().z());
        const auto lightnessAt = [&](const Vec3& place) {
            return shot().pixelColor(view().widgetPosition(place)->toPoint()).lightness();
        };
        double before = lightnessAt(beside);
        const double away = lightnessAt(far);
        QVERIFY2(std::abs(before - away) < 8, "no tool is near");
        for (const double gap : {0.006, 0.003, 0.0003}) {
            document().post(PlaceManipulator{0, ballAt(gap)});
            QTRY_COMPARE(snapshot().tools[0].pose.position.z(), ballAt(gap).position.z());
            rest();
            const double now = lightnessAt(beside);
            QVERIFY2(now < before - 5, qPrintable(QString("%1 after %2 at %3").arg(now).arg(before).arg(gap)));
            QVERIFY(std::abs(lightnessAt(far) - away) < 3);
            before = now;
            picture(qPrintable(QString("hovering-%1").arg(gap * 1e4)));
        }
        QVERIFY2(before < 0.75 * away, qPrintable(QString("%1 of %2").arg(before).arg(away)));
    }

    void curvatureTellsHollowsFromBumpsByColor()
    {
        openExample("lump.step");
        for (const char* name : {"edges", "grid"})
            action(name)->setChecked(false);
        QVERIFY(!legend()->isVisible());
        action("shadingCurvature")->trigger();
        QTRY_VERIFY(legend()->isVisible());
        QCOMPARE(legend()->text().title, QString("Curvature"));
        QCOMPARE(legend()->text().ticks.size(), std::size_t{3});
        bothThemes("curvature");
        choose("colorQuantity", "Displacement");
        QTRY_COMPARE(legend()->text().title, QString("Displacement [mm]"));
        choose("colorQuantity", "Part colors");
        QTRY_COMPARE(legend()->text().title, QString("Curvature"));
        action("shadingUsual")->trigger();
        QTRY_VERIFY(!legend()->isVisible());
    }

    /// White and light gray keep gradients, dark ones can be seen.
    void whiteIsNotBurntAndBlackNotLost()
    {
        openExample("grip.step");
        for (const char* name : {"edges", "grid"})
            action(name)->setChecked(false);
        const QString folder = qEnvironmentVariable("KNEAD_PICTURES");
        const auto inColor = [&](const char* color) {
            document().post(SetPartLook{0, "", color});
            QTRY_COMPARE_WITH_TIMEOUT(document().appearance().faceColor(*document().content().model, 0, 0),
                                      *colorOf(color), patience);
        };
        for (const char* side : {"viewIsometric", "viewFront", "viewTop", "viewLeft"}) {
            action(side)->trigger();
            inColor("#000000");
            rest();
            const QImage black = shot();
            QImage white;
            for (const char* color : {"#ffffff", "#e6e6e6", "#202020"}) {
                inColor(color);
                rest();
                const QImage seen = shot();
                if (white.isNull())
                    white = seen;
                if (!folder.isEmpty())
                    seen.save(QStringLiteral("%1/%2-%3.png").arg(folder, QString(color).mid(1), side));
                const auto [clipped, darkest, brightest] = lightOf(seen, black, white);
                const QString what = QString("%1, %2: %3 clipped, gray %4 .. %5")
                                         .arg(color, side)
                                         .arg(clipped)
                                         .arg(darkest)
                                         .arg(brightest);
                QVERIFY2(clipped < 0.01, qPrintable(what));
                const bool isDark = QByteArray(color) == "#202020";
                QVERIFY2(brightest - darkest > (isDark ? 15 : 60), qPrintable(what));
                QVERIFY2(brightest > (isDark ? 35 : 200) && brightest < 250, qPrintable(what));
            }
        }
    }

    /// They stuck out as single dashes where they begin at the outline.
    void edgesBehindThePartDoNotStickOut()
    {
        openExample("bracket.step");
        action("grid")->setChecked(false);
        action("viewIsometric")->trigger();
        rest();
        const QImage with = shot();
        action("edges")->setChecked(false);
        const QImage without = shot();
        const Camera& camera = view().camera();
        std::vector<std::pair<QPointF, QPointF>> seen; // on the screen
        for (std::size_t b = 0; b < document().frame()->bodies.size(); ++b) {
            const RenderMesh& mesh = document().frame()->filled[b]->render;
            const BodyFrame& frame = *document().frame()->bodies[b];
            const std::vector<bool> isSeen = EdgeSight(mesh).seenFrom(
                frame.points, camera.perspective ? std::optional(camera.eye()) : std::nullopt, camera.towardsEye());
            for (std::size_t e = 0; e < isSeen.size(); ++e)
                if (isSeen[e])
                    seen.emplace_back(*view().widgetPosition(frame.point(mesh.edges[e][0])),
                                      *view().widgetPosition(frame.point(mesh.edges[e][1])));
        }
        const auto distanceFrom = [](const QPointF& place, const std::pair<QPointF, QPointF>& edge) {
            const QPointF way = edge.second - edge.first;
            const double square = std::max(1e-9, QPointF::dotProduct(way, way));
            const double along = std::clamp(QPointF::dotProduct(place - edge.first, way) / square, 0.0, 1.0);
            const QPointF off = place - edge.first - along * way;
            return std::hypot(off.x(), off.y());
        };
        int drawn = 0;
        int stray = 0;
        for (int y = 0; y < with.height(); ++y)
            for (int x = 0; x < with.width(); ++x) {
                if (std::abs(qGray(with.pixel(x, y)) - qGray(without.pixel(x, y))) < 30)
                    continue;
                ++drawn;
                const QPointF place(x + 0.5, y + 0.5);
                stray += std::ranges::none_of(seen, [&](const auto& edge) { return distanceFrom(place, edge) < 2.2; });
            }
        QVERIFY(drawn > 500);
        QCOMPARE(stray, 0);
    }

    void contactForceShowsWhereTheFloorPresses()
    {
        openExample("bar.step");
        choose("colorQuantity", "Contact force");
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.2, patience);
        QVERIFY(snapshot().bodies[0].pressing);
        QTRY_VERIFY(view().scale() && view().scale()->isKnown);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing && document().isSettled());
        QVERIFY(view().scale()->isKnown && legend()->remark().isEmpty());
        QVERIFY(legend()->text().title.startsWith("Contact force [") && view().scale()->most > 1e-4);
        choose("colorQuantity", "Part colors");
        QTRY_VERIFY(!snapshot().bodies[0].pressing); // nobody asks for it any more
    }

    void lookingBackHasColorsOrSaysWhyNot()
    {
        stretchBar();
        choose("colorQuantity", "Von Mises stress");
        QTRY_VERIFY(view().scale());
        const double now = view().scale()->most;
        lookBack(0.3);
        QTRY_VERIFY(view().scale() && view().scale()->most < now); // of elastic material it is known
        QVERIFY(legend()->remark().isEmpty());
        choose("colorQuantity", "Contact force");
        QTRY_VERIFY(view().scale() && !view().scale()->isKnown);
        QTRY_VERIFY(legend()->remark().contains("return to the present"));
        picture("display-not-kept");
        choose("colorQuantity", "Strain");
        QTRY_VERIFY(view().scale() && view().scale()->isKnown);
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        choose("colorQuantity", "Contact force");
        QTRY_VERIFY(legend()->remark().isEmpty() && view().scale() && view().scale()->isKnown);
    }

    /// Of the present, for as long as the next step takes.
    void whatIsNotKnownYetComesWithTheNextStep()
    {
        ColorLegend legend(m_window.get());
        legend.show({.quantity = SurfaceQuantity::contactForce, .isKnown = false}, false);
        QVERIFY(legend.remark().contains("comes with the next step"));
        legend.show({.quantity = SurfaceQuantity::contactForce, .isKnown = true}, false);
        QVERIFY(legend.remark().isEmpty());
    }

    void skinObjectsAndConnectionsGoTogether()
    {
        openExample("bar.step");
        m_window->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_O);
        QVERIFY(!action("skin")->isChecked() && !view().options().skin);
        QCOMPARE(view().options().objects, ObjectDisplay::Surface);
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ShiftModifier);
        QVERIFY(view().options().skin);
        drawn();
        picture("display-glass");
        QTest::keyClick(m_window.get(), Qt::Key_O);
        QTest::keyClick(m_window.get(), Qt::Key_C, Qt::ShiftModifier);
        QVERIFY(view().options().connections && !view().options().skin);
        drawn();
        bothThemes("connections");
        QTest::keyClick(m_window.get(), Qt::Key_C, Qt::ShiftModifier);
        QVERIFY(view().options().skin && action("skin")->isChecked());
    }

    void whatIsShownIsRemembered()
    {
        openExample("bar.step");
        raisePanel();
        click(find<QCheckBox>("originalBox"));
        click(find<QCheckBox>("connectionsBox"));
        click(find<QCheckBox>("gridBox"));
        QVERIFY(action("original")->isChecked() && !action("grid")->isChecked() && !action("skin")->isChecked());
        choose("colorQuantity", "Strain");
        m_window.reset();
        show(m_services);
        QVERIFY(action("original")->isChecked() && action("connections")->isChecked());
        QVERIFY(!action("grid")->isChecked() && !action("skin")->isChecked() && action("edges")->isChecked());
        openExample("bar.step");
        QVERIFY(view().options().original && view().options().connections && !view().options().grid);
        QTRY_VERIFY(view().scale() && view().scale()->quantity == SurfaceQuantity::strain);
    }

    /// How the last part was turned and colored says nothing of it.
    void anotherPartIsSeenFromTheFrontAndAsItsMaterialLooks()
    {
        openExample("bar.step");
        const Camera first = view().camera();
        choose("colorQuantity", "Strain");
        QTRY_VERIFY(view().scale());
        view().setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_7); // from above
        rest();
        QVERIFY(std::abs(view().camera().pitch - first.pitch) > 0.1);
        m_window->features().imports->refill(document().size() / 20); // the same part
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        rest();
        QVERIFY(std::abs(view().camera().pitch - first.pitch) > 0.1);
        QVERIFY(view().options().colors.quantity == SurfaceQuantity::strain);
        openExample("plate.step");
        QVERIFY(std::abs(view().camera().pitch - first.pitch) < 1e-9);
        QVERIFY(std::abs(view().camera().yaw - first.yaw) < 1e-9);
        QVERIFY(!view().options().colors.quantity);
        QVERIFY(action("colorParts")->isChecked());
    }

    void theOriginalIsSeenAroundWhatBecameOfIt()
    {
        stretchBar();
        const QImage without = shot();
        raisePanel();
        click(find<QCheckBox>("originalBox"));
        QTRY_VERIFY(difference(without, shot()) > 0.002);
        bothThemes("original");
    }

    void brokenConnectionsAreMarked()
    {
        openExample("bar.step");
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        document().post(SetMaterial{0, {.youngsModulus = 1e4, .tensileStrength = 1}});
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().broken > 200, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing && document().isSettled());
        const QImage without = shot();
        QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ShiftModifier);
        QTRY_VERIFY(difference(without, shot()) > 0.0005);
        bothThemes("breaks");
    }

    void aSectionIsCappedAndItsAreaIsRight()
    {
        openExample("bracket.step", 24);
        QTest::keyClick(m_window.get(), Qt::Key_7);
        QTest::keyClick(m_window.get(), Qt::Key_5);
        QTest::keyClick(m_window.get(), Qt::Key_E); // no edges
        rest();
        raisePanel();
        click(find<QCheckBox>("sectionBox"));
        choose("sectionAxis", "Z");
        click(find<QCheckBox>("sectionHatched"));
        QVERIFY(!view().options().section.isHatched);
        const Box box = document().content().box;
        QCOMPARE(view().options().section.plane->normal, Vec3(Vec3::UnitZ()));
        QVERIFY(std::abs(view().options().section.plane->offset - box.center().z()) < 1e-12);
        rest();
        const auto& body = *document().content().bodies[0];
        const PlaneSection section =
            planeSection(body.mesh.vertices, body.mesh.triangles, *view().options().section.plane);
        QVERIFY(section.area() > 0);
        const auto& t = section.triangles[largest(section)];
        const Vec3 middle = (section.points[t[0]] + section.points[t[1]] + section.points[t[2]]) / 3;
        Camera near = view().camera();
        Box whole;
        for (const Vec3& point : section.points)
            whole.extend(point);
        near.fit(whole, static_cast<double>(view().width()) / view().height());
        QTRY_VERIFY_WITH_TIMEOUT(view().fields() && view().fields()->request.section == view().options().section.plane,
                                 patience);
        view().jumpTo(near);
        const QImage seen = shot();
        const QColor cap = seen.pixelColor(view().widgetPosition(middle)->toPoint());
        const QPointF one = *view().widgetPosition(whole.min());
        const QPointF other = *view().widgetPosition(whole.max());
        const QRect where = QRectF(one, other).normalized().toAlignedRect().adjusted(-3, -3, 3, 3); // and its line
        int count = 0;
        for (int y = where.top(); y <= where.bottom(); ++y)
            for (int x = where.left(); x <= where.right(); ++x)
                count += std::abs(seen.pixelColor(x, y).lightness() - cap.lightness()) < 6 &&
                                 std::abs(seen.pixelColor(x, y).hue() - cap.hue()) < 6
                             ? 1
                             : 0;
        double around = 0; // half of the line around it, two pixels wide, lies on the cap
        for (const auto& side : section.outline)
            around += (section.points[side[1]] - section.points[side[0]]).norm();
        const double pixel = view().camera().viewHeight() / view().height();
        const double drawn = count * pixel * pixel + around * pixel;
        qInfo("area %.1f mm2, drawn %.1f mm2", 1e6 * section.area(), 1e6 * drawn);
        QVERIFY(std::abs(drawn / section.area() - 1) < 0.05);
        document().colorPart(body.part, Color{1, 0, 0});
        const QColor red = shot().pixelColor(view().widgetPosition(middle)->toPoint());
        QVERIFY2(red.red() > 2 * red.green(), qPrintable(red.name()));
        document().colorPart(body.part, std::nullopt);
        QTest::keyClick(m_window.get(), Qt::Key_E);
        click(find<QCheckBox>("sectionHatched"));
        QTest::keyClick(m_window.get(), Qt::Key_0);
        rest();
        bothThemes("section");
    }

    void theSectionPlaneIsDraggedTypedAndFlipped()
    {
        openExample("bracket.step", 24);
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        raisePanel();
        auto* knob = find<QWidget>("sectionKnob");
        QTRY_VERIFY(knob->isVisible());
        const double before = view().options().section.plane->offset;
        const Vec3 normal = view().options().section.plane->normal;
        const QPoint center = knob->rect().center();
        const QPointF way = *view().widgetPosition(0.02 * normal) - *view().widgetPosition(Vec3::Zero());
        QTest::mousePress(knob, Qt::LeftButton, {}, center);
        QTest::mouseMove(knob, center + (way / 2).toPoint());
        drawn();
        QTest::mouseRelease(knob, Qt::LeftButton, {}, center);
        const double after = view().options().section.plane->offset;
        QVERIFY2(after - before > 0.004 && after - before < 0.02, qPrintable(QString::number(after - before)));
        QCOMPARE(find<QuantityField>("sectionOffset")->text(), formatQuantity(after, Quantity::Length));
        type("sectionOffset", "2 cm");
        QCOMPARE(view().options().section.plane->offset, 0.02);
        type("sectionOffset", "3 m");
        QVERIFY(find<QuantityField>("sectionOffset")->hasProblem());
        QTest::keyClick(find<QuantityField>("sectionOffset"), Qt::Key_Escape);
        click(find<QCheckBox>("flipSectionBox"));
        QCOMPARE(view().options().section.plane->normal, Vec3(-normal));
        QCOMPARE(view().options().section.plane->offset, -0.02);
        QCOMPARE(find<QuantityField>("sectionOffset")->text(), QString("20 mm"));
        knob->setFocus();
        QTest::keyClick(knob, Qt::Key_Up);
        QVERIFY(view().options().section.plane->offset > -0.02);
        choose("sectionAxis", "Towards the eye");
        QVERIFY((view().options().section.plane->normal + view().camera().towardsEye()).norm() < 1e-9); // still flipped
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(!view().options().section.plane && !find<QCheckBox>("sectionBox")->isChecked());
        QTRY_VERIFY(!knob->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        choose("sectionAxis", "X");
        type("sectionOffset", "2 cm");
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(!view().options().section.plane);
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        QCOMPARE(view().options().section.plane->offset, -0.02); // where it was, and still flipped
    }

    /// Seen from below it lies before the part, and before what is drawn as through glass around that.
    void theGridCoversGlassThatIsBehindIt()
    {
        openExample("bracket.step");
        Camera camera = view().camera();
        camera.pitch = -1;
        view().jumpTo(camera);
        rest();
        const auto contrast = [&](bool hasGlass) {
            SceneOptions options = view().options();
            options.original = hasGlass;
            options.edges = false;
            options.grid = true;
            view().setOptions(options);
            const QImage with = shot();
            options.grid = false;
            view().setOptions(options);
            const QImage without = shot();
            // Beside the middle of the part, all of which is behind the ground.
            const QPoint middle = view().widgetPosition(document().content().box.center())->toPoint();
            double sum = 0;
            for (int y = middle.y() - 60; y < middle.y() + 60; ++y)
                for (int x = middle.x() - 60; x < middle.x() + 60; ++x)
                    sum += std::abs(qGray(with.pixel(x, y)) - qGray(without.pixel(x, y)));
            return sum;
        };
        const double plain = contrast(false);
        const double glass = contrast(true);
        qInfo("contrast of the ground %.0f, before glass %.0f", plain, glass);
        QVERIFY(plain > 0);
        QVERIFY2(glass > 0.9 * plain, qPrintable(QString("%1 of %2").arg(glass).arg(plain)));
    }

    /// A step of the drag of a plane through a large part takes hardly more than one of turning the view.
    void aCutIsNoFace()
    {
        openExample("bar.step", 24);
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier); // cuts off what is beyond x = 80 mm
        view().lookFrom(Vec3(1, 0, 0));
        rest();
        const PickHit hit = view().hitAt(*view().widgetPosition(Vec3(0.08, 0.01, 0.01)));
        QCOMPARE(hit.kind, PickHit::Kind::Cut);
        QVERIFY(std::abs(hit.place.x() - 0.08) < 1e-9);
    }

    void anotherPartMayComeWhileThePlaneIsDragged()
    {
        openExample("bracket.step", 24);
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        auto* knob = find<QWidget>("sectionKnob");
        QTRY_VERIFY(knob->isVisible());
        const QPoint center = knob->rect().center();
        QTest::mousePress(knob, Qt::LeftButton, {}, center);
        openExample("bar.step", 24);
        QVERIFY(!view().options().section.plane);
        QTest::mouseMove(knob, center + QPoint(10, 10));
        QTest::mouseRelease(knob, Qt::LeftButton, {}, center);
        QVERIFY(!view().options().section.plane);
    }

    void thePlaneReachesMaterialThatWasPulledOut()
    {
        stretchBar();
        const double end = document().frame()->bodies[0]->places[farthestVertex()].x();
        QVERIFY(end > 0.165);
        click(find<QCheckBox>("sectionBox"));
        choose("sectionAxis", "X");
        type("sectionOffset", "0.164 m"); // at rest the bar ends at 0.16 m
        QCOMPARE(view().options().section.plane->offset, 0.164);
    }

    void theDividerHasTheOriginalLeftAndThePresentRight()
    {
        stretchBar();
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::KeypadModifier);
        rest();
        const auto added = view().widgetPosition(Vec3(0.17, 0, 0.01))->toPoint(); // where only the stretched bar is
        const QColor material = shot().pixelColor(added);
        QTest::keyClick(m_window.get(), Qt::Key_V, Qt::ShiftModifier);
        auto* divider = find<QWidget>("dividerHandle");
        QTRY_VERIFY(divider->isVisible());
        QVERIFY(view().options().divider == 0.5);
        drawn();
        QCOMPARE(shot().pixelColor(added), material);
        const auto dragTo = [&](int x) {
            QTest::mousePress(divider, Qt::LeftButton, {}, divider->rect().center());
            QTest::mouseMove(divider, divider->mapFrom(&view(), QPoint(x, view().height() / 2)));
            drawn();
            QTest::mouseRelease(divider, Qt::LeftButton, {}, divider->rect().center());
            drawn();
        };
        dragTo(added.x() + 15);
        QVERIFY(std::abs(*view().options().divider * view().width() - added.x() - 15) < 3);
        const QImage original = shot();
        QVERIFY(original.pixelColor(added).lightness() != material.lightness());
        QVERIFY(std::abs(original.pixelColor(added).lightness() -
                         original.pixelColor(added - QPoint(0, 60)).lightness()) < 25); // the ground
        dragTo(added.x() - 30);
        QTest::mouseMove(&view(), QPoint(5, 5)); // what lies under the mouse is highlighted
        QTRY_COMPARE(shot().pixelColor(added), material);
        divider->setFocus();
        const double share = *view().options().divider;
        QTest::keyClick(divider, Qt::Key_Right);
        QVERIFY(*view().options().divider > share);
        bothThemes("compare"); // last: with another theme panels may be of another width, and pixels of other places
        QTest::keyClick(m_window.get(), Qt::Key_V, Qt::ShiftModifier);
        QVERIFY(!view().options().divider);
    }

    void aSectionAndADividerAndColorsGoTogether()
    {
        openExample("bracket.step", 24);
        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        document().post(SetManipulatorMotion{0, DriveAt{Vec3(0, 0, -0.05)}});
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.4, patience);
        choose("colorQuantity", "Von Mises stress");
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        choose("sectionAxis", "Y");
        QTest::keyClick(m_window.get(), Qt::Key_V, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.6, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing && document().isSettled());
        rest();
        QVERIFY(view().scale());
        bothThemes("all");
        m_window->resize(1920, 1080);
        rest();
        picture("display-all-large");
    }

private:
    ViewportWidget& view() { return m_window->viewport(); }
    ColorLegend* legend() { return find<ColorLegend>("colorLegend"); }

    /// What is drawn now, without what lies over it.
    /// Share of pixels that differ visibly.
    static double shareOfOthers(const QImage& a, const QImage& b)
    {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x) {
                const QColor one = a.pixelColor(x, y);
                const QColor other = b.pixelColor(x, y);
                const int difference = std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
                                       std::abs(one.blue() - other.blue());
                count += difference > 24 ? 1 : 0;
            }
        return static_cast<double>(count) / a.width() / a.height();
    }

    /// Of a part: share of its pixels that are white altogether, and the gray that 2 % of them are darker, and brighter
    /// than. Its pixels are those where it makes a difference whether it is black or white.
    struct Light {
        double clipped = 0;
        int darkest = 0;
        int brightest = 0;
    };
    static Light lightOf(const QImage& seen, const QImage& black, const QImage& white)
    {
        std::vector<int> grays;
        int clipped = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x)
                if (qGray(white.pixel(x, y)) - qGray(black.pixel(x, y)) > 20) {
                    grays.push_back(qGray(seen.pixel(x, y)));
                    clipped += seen.pixel(x, y) == qRgb(255, 255, 255) ? 1 : 0;
                }
        std::ranges::sort(grays);
        const std::size_t few = grays.size() / 50;
        return {static_cast<double>(clipped) / static_cast<double>(grays.size()), grays.at(few),
                grays.at(grays.size() - 1 - few)};
    }

    /// How often a column of pixels goes from black to white or back, where most do, left of the cube.
    static int mostStripes(const QImage& image)
    {
        int most = 0;
        for (int x = 0; x < image.width() * 4 / 5; ++x) {
            int changes = 0;
            int last = 0;
            for (int y = 0; y < image.height(); ++y) {
                const int gray = qGray(image.pixel(x, y));
                const int now = gray < 70 ? -1 : (gray > 165 ? 1 : last);
                changes += last != 0 && now != last ? 1 : 0;
                last = now;
            }
            most = std::max(most, changes);
        }
        return most;
    }

    QImage shot()
    {
        drawn();
        return view().grabFramebuffer();
    }

    /// A bar that is held at one end and pulled at the other.
    void stretchBar()
    {
        openExample("bar.step", 32);
        const Aggregate& aggregate = *document().content().bodies[0]->aggregate;
        const auto grip = [&](const char* name, double from, double to, const Vec3& velocity) {
            document().post(
                AddFixture{{name, 0, objectsInBox(aggregate, Box(Vec3(from, -1, -1), Vec3(to, 1, 1))), velocity}});
        };
        grip("held", -1, 0.006, Vec3::Zero());
        grip("pulled", 0.154, 1, Vec3(0.08, 0, 0));
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.3, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing && document().isSettled());
        QTest::keyClick(m_window.get(), Qt::Key_F);
        rest();
        raisePanel();
    }

    std::size_t farthestVertex()
    {
        const auto& vertices = document().content().bodies[0]->mesh.vertices;
        return static_cast<std::size_t>(std::max_element(vertices.begin(), vertices.end(),
                                                         [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); }) -
                                        vertices.begin());
    }

    /// A vertex on the middle of the top of the bar: where it is now, and how far it came [m].
    std::pair<Vec3, double> onTop(double x)
    {
        const auto& vertices = document().content().bodies[0]->mesh.vertices;
        const Vec3 wanted(x, 0.01, 0.02);
        const auto nearest = std::min_element(vertices.begin(), vertices.end(), [&](const Vec3& a, const Vec3& b) {
            return (a - wanted).norm() < (b - wanted).norm();
        });
        const Vec3 place = document().frame()->bodies[0]->places[static_cast<std::size_t>(nearest - vertices.begin())];
        return {place, (place - *nearest).norm()};
    }

    /// Light changes how bright a color is, and hardly its hue and saturation.
    void verifyColor(const QImage& seen, const Vec3& place, const ColorScale& scale, double value)
    {
        const QColor color = seen.pixelColor(view().widgetPosition(place)->toPoint());
        const Color wanted = colorAt(scale.map, scale.shareOf(value));
        const QColor pure = QColor::fromRgbF(wanted.r, wanted.g, wanted.b);
        const int apart = std::abs(color.hue() - pure.hue());
        QVERIFY2(std::min(apart, 360 - apart) < 20 || pure.saturation() < 40,
                 qPrintable(QStringLiteral("%1 instead of %2 for %3").arg(color.name(), pure.name()).arg(value)));
    }

    static std::size_t largest(const PlaneSection& section)
    {
        const auto area = [&](const auto& t) {
            return (section.points[t[1]] - section.points[t[0]])
                .cross(section.points[t[2]] - section.points[t[0]])
                .norm();
        };
        return static_cast<std::size_t>(
            std::max_element(section.triangles.begin(), section.triangles.end(),
                             [&](const auto& a, const auto& b) { return area(a) < area(b); }) -
            section.triangles.begin());
    }

    /// Share of pixels that differ visibly.
    static double difference(const QImage& a, const QImage& b)
    {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 12 ? 1 : 0;
        return static_cast<double>(count) / a.width() / a.height();
    }

    /// Brings the panel to the front.
    void raisePanel()
    {
        auto* dock = find<QDockWidget>("displayDock");
        dock->show();
        dock->raise();
        QTRY_VERIFY(dock->isVisible() && find<QWidget>("displayPanel")->isVisible());
    }

    void reveal(QWidget* widget)
    {
        raisePanel();
        for (QWidget* parent = widget->parentWidget(); parent != nullptr; parent = parent->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(parent))
                area->ensureWidgetVisible(widget);
        QTRY_VERIFY(widget->isVisible()); // one that was just made comes a moment later
    }

    using WindowOnTest::click;
    void click(QCheckBox* box)
    {
        reveal(box);
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(10, box->height() / 2));
    }

    void choose(const char* name, const QString& text)
    {
        auto* box = find<QComboBox>(name);
        reveal(box);
        box->setFocus();
        box->setCurrentText(text);
        QCOMPARE(box->currentText(), text);
        emit box->activated(box->currentIndex());
        view().setFocus();
    }

    void type(const char* name, const QString& text)
    {
        auto* field = find<QuantityField>(name);
        reveal(field);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }

    void lookBack(double share)
    {
        auto* axis = find<TimelineAxis>("timelineAxis");
        QTRY_VERIFY(axis->timeline().pictures.size() > 3);
        const Timeline line = axis->timeline();
        QTest::mousePress(axis, Qt::LeftButton, {}, axis->placeOf(line.present));
        QTest::mouseMove(axis, axis->placeOf(0.6 * line.end));
        QTest::mouseMove(axis, axis->placeOf(share * line.end));
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(share * line.end));
    }

    void bothThemes(const char* name)
    {
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            m_window->features().preferences->setTheme(theme);
            drawn();
            picture(qPrintable(QStringLiteral("display-%1-%2").arg(name, theme == Theme::Dark ? "dark" : "light")));
        }
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowDisplayTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_display_test.moc"
