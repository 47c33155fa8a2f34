#include "support/projects_on_test.h"
#include "ui/dialogs/recent_files.h"
#include "ui/exporting/export_feature.h"
#include "ui/importing/import_feature.h"
#include "ui/run_window.h"
#include "ui/viewport/viewport_widget.h"

#include <QComboBox>
#include <QPlainTextEdit>
#include <QToolButton>
#include <QtTest>

#include <atomic>

using namespace knead;

/// Parts of other files beside one that was kneaded.
class WindowAddedPartTest : public QObject, ProjectsOnTest {
    Q_OBJECT

    std::atomic<bool> m_isSlow = false; ///< reading waits

    const History& tree() { return document().history().tree(); }
    QString presentName() { return QString::fromStdString(tree().record(tree().current()).name); }
    const std::vector<Part>& parts() { return document().content().model->parts; }

    /// Of a body, as it is shown.
    Box seenBox(std::size_t body) { return boxOfPlaces(document().frame()->bodies[body]->places); }

    void add(const QStringList& paths)
    {
        const std::size_t entries = tree().records().size();
        m_window->features().imports->addParts(paths);
        QTRY_VERIFY2_WITH_TIMEOUT(tree().records().size() > entries && isIdle(), qPrintable(problem()), patience);
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare(qEnvironmentVariableIsEmpty("KNEAD_PICTURES") ? Eyes::none : Eyes::open);
    }

    void init() { ProjectsOnTest::begin(); }
    void cleanup() { m_window.reset(); }

    /// Its faces are as smooth, and as many; one step of undo away it is alone again.
    void whatWasKneadedStaysAsItIs()
    {
        work();
        const std::uint64_t kneaded = hash();
        const std::size_t count = parts().size();
        const Box seen = seenBox(0);
        const std::vector<PartFace> faces = parts()[0].faces;
        const Box opened = parts()[0].box;
        QVERIFY((seen.sizes() - opened.sizes()).norm() > 1e-3 * opened.diagonal().norm());
        add({example("plate.step")});
        QCOMPARE(presentName(), QString("Add plate.step"));
        QCOMPARE(parts().size(), count + 1);
        const std::size_t last = document().content().bodies.size() - 1;
        QVERIFY((seenBox(0).min() - seen.min()).norm() < 2e-3 * seen.diagonal().norm());
        QVERIFY((seenBox(0).max() - seen.max()).norm() < 2e-3 * seen.diagonal().norm());
        QVERIFY(parts()[0].faces == faces && parts()[0].exact && parts().back().exact);
        QVERIFY(seenBox(0).intersection(seenBox(last)).isEmpty());
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(document().selection(), (Selection{Selection::Kind::Body, static_cast<BodyId>(last)}));
        QVERIFY(m_window->viewport().showsAll());
        QCOMPARE(recent_files::list().front(), example("plate.step"));
        QVERIFY(!find<QComboBox>("takenUnit")->isEnabled()); // reading again would lose what was kneaded
        picture("added-part");

        const std::uint64_t added = hash();
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isIdle() && hash() == kneaded && parts().size() == count, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isIdle() && hash() == added && parts().size() == count + 1, patience);
    }

    /// Both leave as STEP, and a project has both.
    void bothAreKept()
    {
        work();
        const std::size_t count = parts().size() + 1;
        add({example("plate.step")});
        pushOn(); // the work goes on
        const std::uint64_t now = hash();
        m_window->features().exports->exportTo(file("both.step"));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file("both.step")) && isIdle(), patience);
        saveTo(file("both.knead"));
        newWindow(m_services);
        openProject(file("both.knead"));
        QCOMPARE(hash(), now);
        QCOMPARE(parts().size(), count);
        newWindow(m_services);
        m_window->open(QStringList(file("both.step")));
        QTRY_VERIFY2_WITH_TIMEOUT(isIdle() && !document().isEmpty() && parts().size() == count, qPrintable(problem()),
                                  patience);
        for (const Part& part : parts())
            QVERIFY2(part.valid && part.watertight && !part.faces.empty(), part.name.c_str());
    }

    void aPartThatLiesInsideOfOthersIsPutBesideThem()
    {
        openExample("bar.step", 12);
        add({example("bar.step")});
        const QString log = find<QPlainTextEdit>("log")->toPlainText();
        QVERIFY2(log.contains("where there is room: bar.step."), qPrintable(log));
        QVERIFY(seenBox(1).min().x() > seenBox(0).max().x());
        QVERIFY(std::abs(seenBox(1).min().z() - *snapshot().floorHeight) < 1e-9);
        QVERIFY((seenBox(1).sizes() - seenBox(0).sizes()).norm() < 1e-9);
        QVERIFY(document().content().bodies[0]->name != document().content().bodies[1]->name);
        add({example("lump.step"), example("grip.step")}); // several
        QCOMPARE(presentName(), QString("Add lump.step and others"));
        QCOMPARE(document().content().bodies.size(), std::size_t{4});
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < a; ++b)
                QVERIFY(seenBox(a).intersection(seenBox(b)).isEmpty());
    }

    /// It is told, and can be done again with a click.
    void whatIsDoneMeanwhileIsNotLost_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("an edit") << static_cast<int>(Qt::Key_G);
        QTest::newRow("time runs") << static_cast<int>(Qt::Key_Space);
    }

    void whatIsDoneMeanwhileIsNotLost()
    {
        QFETCH(int, key);
        Services slow = m_services;
        slow.import = [this, import = m_services.import](const std::vector<std::string>& paths,
                                                         const ImportOptions& options, TaskControl& control) {
            while (m_isSlow && !control.isCancelled())
                QTest::qSleep(5);
            return import(paths, options, control);
        };
        newWindow(slow);
        openExample("bar.step", 12);
        m_isSlow = true;
        m_window->features().imports->addParts({example("plate.step")});
        QTRY_VERIFY(m_window->tasks().isRunning());
        QTest::keyClick(m_window.get(), static_cast<Qt::Key>(key));
        if (key == Qt::Key_Space)
            QTRY_VERIFY(snapshot().playing && snapshot().step > 2);
        m_isSlow = false;
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY2(problem().contains("none were added"), qPrintable(problem()));
        QCOMPARE(parts().size(), std::size_t{1});
        QTest::mouseClick(find<QToolButton>("bannerRemedy"), Qt::LeftButton); // time stands still for it
        QTRY_VERIFY_WITH_TIMEOUT(parts().size() == 2 && isIdle(), patience);
    }

    void whatCannotBeReadChangesNothing()
    {
        openExample("bar.step", 12);
        const std::uint64_t before = hash();
        QFile text(file("text.step"));
        QVERIFY(text.open(QFile::WriteOnly));
        text.write("Nothing of a part.");
        text.close();
        m_window->features().imports->addParts({text.fileName()});
        QTRY_VERIFY_WITH_TIMEOUT(!problem().isEmpty() && isIdle(), patience);
        QCOMPARE(hash(), before);
        QCOMPARE(parts().size(), std::size_t{1});
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowAddedPartTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_added_part_test.moc"
