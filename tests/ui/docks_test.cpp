#include "ui/frame/docks.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QtTest>

#include <algorithm>

using namespace knead;

class DocksTest : public QObject {
    Q_OBJECT

    static std::vector<const char*> names()
    {
        return {"modelDock",    "historyDock", "simulationDock", "propertiesDock", "displayDock",     "handsDock",
                "timelineDock", "logDock",     "importDock",     "exportDock",     "performanceDock", "measureDock",
                "probeDock",    "forcesDock",  "deformDock",     "traceDock"};
    }

    static void add(Docks& docks, const std::vector<const char*>& names)
    {
        for (const char* name : names)
            docks.add(name, QString("Panel ") + name, new QLabel(name));
    }

private slots:
    /// Whoever makes a panel first or last does not decide where it stands.
    void theOrderInWhichTheyAreMadeDoesNotMatter()
    {
        QMainWindow one;
        QMainWindow other;
        Docks docks(one);
        Docks turned(other);
        std::vector<const char*> order = names();
        add(docks, order);
        std::reverse(order.begin(), order.end());
        add(turned, order);
        docks.arrange();
        turned.arrange();
        for (const char* name : names()) {
            QCOMPARE(one.dockWidgetArea(&docks.of(name)), other.dockWidgetArea(&turned.of(name)));
            QStringList besides;
            QStringList besidesTurned;
            for (const QDockWidget* dock : one.tabifiedDockWidgets(&docks.of(name)))
                besides << dock->objectName();
            for (const QDockWidget* dock : other.tabifiedDockWidgets(&turned.of(name)))
                besidesTurned << dock->objectName();
            QCOMPARE(besides, besidesTurned);
        }
        QCOMPARE(one.tabifiedDockWidgets(&docks.of("propertiesDock")).size(), 3);
        QCOMPARE(one.tabifiedDockWidgets(&docks.of("logDock")).size(), 7);
        QVERIFY(one.tabifiedDockWidgets(&docks.of("timelineDock")).empty());
    }

    void allHaveTheSameAbilities()
    {
        QMainWindow window;
        Docks docks(window);
        add(docks, names());
        docks.arrange();
        constexpr auto wanted =
            QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetFloatable;
        for (const char* name : names())
            QCOMPARE(docks.of(name).features() & wanted, wanted);
    }

    void someComeLater()
    {
        QMainWindow window;
        Docks docks(window);
        add(docks, names());
        docks.arrange();
        docks.hideLaterOnes();
        int hidden = 0;
        for (const char* name : names())
            hidden += docks.of(name).isHidden() ? 1 : 0;
        QCOMPARE(hidden, 5);
        docks.show("probeDock");
        QVERIFY(!docks.of("probeDock").isHidden());
    }
};

QTEST_MAIN(DocksTest)
#include "docks_test.moc"
