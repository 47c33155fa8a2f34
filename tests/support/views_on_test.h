#pragma once

#include "support/window_on_test.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/view_name.h"

#include <QWheelEvent>
#include <QWindow>
#include <QtTest>

#include <array>
#include <cmath>

namespace knead {

/// A window whose views are looked into, with a mouse that is sent as the windowing system sends it.
class ViewsOnTest : protected WindowOnTest {
protected:
    ViewportWidget& view() { return m_window->viewport(); }
    ViewGrid& views() { return m_window->views(); }
    static std::size_t index(ViewSlot slot) { return static_cast<std::size_t>(slot); }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(m_window->windowHandle(), key, modifiers);
    }

    // The mouse as the windowing system sends it: Qt finds the widget.
    void mousePress(Qt::MouseButton button, const QPoint& at, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseMove(m_window->windowHandle(), at);
        QTest::mousePress(m_window->windowHandle(), button, modifiers, at);
        m_button = button;
    }
    void mouseMove(const QPoint& at, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseEvent(QTest::MouseMove, m_window->windowHandle(), m_button, modifiers, at);
        QCoreApplication::processEvents();
    }
    void mouseRelease(Qt::MouseButton button, const QPoint& at)
    {
        QTest::mouseRelease(m_window->windowHandle(), button, {}, at);
        m_button = Qt::NoButton;
    }
    void mouseClick(const QPoint& at)
    {
        mousePress(Qt::LeftButton, at);
        mouseRelease(Qt::LeftButton, at);
    }
    void drag(const QPoint& from, const QPoint& to)
    {
        mousePress(Qt::LeftButton, from);
        mouseMove((from + to) / 2);
        mouseMove(to);
        mouseRelease(Qt::LeftButton, to);
    }
    void doubleClick(const QWidget& widget)
    {
        QTest::mouseDClick(m_window->windowHandle(), Qt::LeftButton, {},
                           widget.mapTo(m_window.get(), widget.rect().center()));
    }
    void clickIn(ViewSlot slot, const QPoint& at) { mouseClick(placeOf(slot).topLeft() + at); }
    void wheel(const QPoint& at, int turned)
    {
        QWidget* widget = m_window->childAt(at);
        QWheelEvent event(widget->mapFrom(m_window.get(), at), m_window->mapToGlobal(at), {}, QPoint(0, turned),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &event);
    }

    QRect placeInGrid(ViewSlot slot) { return views().cell(slot); }
    /// In the window.
    QRect placeOf(ViewSlot slot)
    {
        const QRect cell = views().cell(slot);
        return {views().mapTo(m_window.get(), cell.topLeft()), cell.size()};
    }

    /// Of all views, in the order of ViewSlot.
    QStringList namesShown()
    {
        QStringList names;
        for (const ViewSlot slot : allViewSlots)
            if (views().name(slot).isVisible())
                names << views().name(slot).name();
        return names;
    }

    std::array<Camera, 4> cameras()
    {
        std::array<Camera, 4> all;
        for (const ViewSlot slot : allViewSlots)
            all[index(slot)] = views().camera(slot);
        return all;
    }

    static bool isSame(const Camera& a, const Camera& b)
    {
        return (a.eye() - b.eye()).norm() < 1e-12 && (a.target - b.target).norm() < 1e-12 &&
               a.perspective == b.perspective;
    }

    void verifyLinked()
    {
        const double scale = view().camera().viewHeight() / view().height();
        for (const ViewSlot slot : allViewSlots) {
            const Camera camera = views().camera(slot);
            QVERIFY((camera.target - view().camera().target).norm() < 1e-12);
            QVERIFY(std::abs(camera.viewHeight() / views().cell(slot).height() / scale - 1) < 1e-9);
        }
    }

    /// Where a view shows the part: the middle of the triangle that is nearest to the eye.
    QPoint seenFace(ViewSlot slot)
    {
        const Camera camera = views().camera(slot);
        const FilledBody& body = *document().content().bodies[0];
        Vec3 nearest = Vec3::Zero();
        double height = -1e9;
        for (const auto& t : body.mesh.triangles) {
            const Vec3 place = (body.mesh.vertices[t[0]] + body.mesh.vertices[t[1]] + body.mesh.vertices[t[2]]) / 3;
            if (place.dot(camera.towardsEye()) > height) {
                height = place.dot(camera.towardsEye());
                nearest = place;
            }
        }
        return views().sideView(slot)->widgetPosition(nearest)->toPoint();
    }

    /// What is neither ground nor grid, cube and legend aside: as strongly another color than the ground beside it.
    static QRect materialIn(const QImage& image)
    {
        QRect found;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor color = image.pixelColor(x, y);
                const QColor ground = image.pixelColor(2, y);
                const bool isOther = std::abs(color.red() - ground.red()) + std::abs(color.green() - ground.green()) +
                                         std::abs(color.blue() - ground.blue()) >
                                     60;
                if (isOther && !(x > image.width() - 110 && y < 110))
                    found |= QRect(x, y, 1, 1);
            }
        return found;
    }

    void bothThemes(const char* name)
    {
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            m_window->features().preferences->setTheme(theme);
            drawn();
            picture(qPrintable(QString("viewports-%1-%2").arg(name, theme == Theme::Dark ? "dark" : "light")));
        }
    }

private:
    Qt::MouseButton m_button = Qt::NoButton;
};

} // namespace knead
