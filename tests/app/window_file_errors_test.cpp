// What can be wrong with files and disks in the window: each gets a sentence, and nothing is lost.
#include "support/errors_on_test.h"
#include "support/full_disk.h"
#include "support/mesh_containers.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"

#include <QContextMenuEvent>
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

#include <new>

using namespace knead;

class WindowFileErrorsTest : public QObject, ErrorsOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { begin(); }
    void cleanup() { end(); }

    /// First, while nobody left anything.
    void thereIsNothingToRecover()
    {
        action("recover")->trigger();
        verifySaid("There is no unsaved work to recover");
    }

    // --- opening ---------------------------------------------------------------------------------------------------------

    void filesThatCannotBeOpened_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("no file") << "gone.step" << QByteArray() << "gone.step: the file does not exist";
        QTest::newRow("empty") << "empty.step" << QByteArray("") << "empty.step";
        QTest::newRow("text") << "text.step" << QByteArray("dear reader,\n") << "text.step";
        QTest::newRow("half") << "half.step" << QByteArray("ISO-10303-21;\nHEADER;\n") << "half.step";
        QTest::newRow("no solid") << "place.brep" << onlyAPlace() << "no solid and no surface";
        QTest::newRow("no surface") << "points.stl" << QByteArray("solid none\nendsolid none\n") << "points.stl";
        QTest::newRow("recipe") << "broken.recipe.json" << QByteArray("{\"version\": 1, \"partt\": 3}") << "partt";
        QTest::newRow("no project") << "text.knead" << QByteArray("dear reader,\n") << "text.knead";
    }

    void filesThatCannotBeOpened()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, sentence);
        openWithBlock();
        const QString path = m_folder->filePath(name);
        if (!bytes.isNull()) {
            QFile file(path);
            QVERIFY(file.open(QFile::WriteOnly) && file.write(bytes) == bytes.size());
        }
        remember();
        m_window->open(QStringList(path));
        verifySaid(sentence);
        verifyNothingLost();
    }

    void aFolderIsNoPart()
    {
        openWithBlock();
        remember();
        m_window->open(QStringList(m_folder->path()));
        verifySaid("folder");
        verifyNothingLost();
    }

    void projectsAndRecipesAreOpenedAlone()
    {
        openWithBlock();
        remember();
        m_window->open({example("bar.step"), m_folder->filePath("one.knead")});
        verifySaid("A project is opened alone");
        m_window->open({example("bar.step"), example("bend-bar.recipe.json")});
        verifySaid("A recipe is opened alone");
        verifyNothingLost();
    }

    void partsThatAreMissingAreNamedOrCounted()
    {
        write("one.3mf", threeMfWithEmptyParts(1));
        m_window->open(QStringList(m_folder->filePath("one.3mf")));
        verifySaid("has no triangles");
        QCOMPARE(document().content().bodies.size(), std::size_t{1});
        write("two.3mf", threeMfWithEmptyParts(2));
        m_window->open(QStringList(m_folder->filePath("two.3mf")));
        verifySaid("2 parts of the file are missing");
        QCOMPARE(document().content().bodies.size(), std::size_t{1});
        QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Show report"));
        picture("parts-missing");
    }

    void aFileThatNeedsTooMuchMemoryIsNotOpened()
    {
        Services services = m_services;
        services.import = [this](const std::vector<std::string>& paths, const ImportOptions& options,
                                 TaskControl& control) {
            if (m_isMemoryFull)
                throw std::bad_alloc();
            return m_services.import(paths, options, control);
        };
        show(services);
        openWithBlock();
        remember();
        m_isMemoryFull = true;
        m_window->open(QStringList(example("plate.step")));
        verifySaid("Opening plate.step: there is not enough memory");
        verifyNothingLost();
        m_isMemoryFull = false;
    }

    /// The reader sees to it that a history hangs together; here it is one that does not.
    void aHistoryThatDoesNotHangTogetherIsNotOpened()
    {
        Services services = m_services;
        services.projects.read = [this](const std::string& path, TaskControl& control) {
            Project project = m_services.projects.read(path, control);
            project.entries.back().parent = 99;
            project.current = 0;
            return project;
        };
        show(services);
        openWithBlock();
        m_window->projects().saveTo(m_folder->filePath("bar.knead"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && !m_window->projects().isModified(), patience);
        m_window->open(QStringList(example("plate.step")));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && document().content().bodies.size() == 1, patience);
        remember();
        m_window->open(QStringList(m_folder->filePath("bar.knead")));
        verifySaid("The history is damaged: its entry");
        verifyNothingLost();
    }

    void aFileOfLateThatIsGoneIsTakenOffTheList()
    {
        writeCube("cube.stl", 1);
        m_window->open(QStringList(m_folder->filePath("cube.stl")));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && !document().isEmpty(), patience);
        show(m_services);
        auto* card = find<QPushButton>("recent_cube.stl");
        QVERIFY(card != nullptr && QFile::remove(m_folder->filePath("cube.stl")));
        QTest::mouseClick(card, Qt::LeftButton);
        verifySaid("cube.stl is not there any more. It may have been moved: look for it with Ctrl+O.");
        QTRY_VERIFY(find<QPushButton>("recent_cube.stl") == nullptr);
        QVERIFY(document().isEmpty());
    }

    void aPartInAnotherUnitIsDoubted()
    {
        writeCube("small.stl", 1e-3); // a thousandth of a millimetre for each metre
        m_window->open(QStringList(m_folder->filePath("small.stl")));
        verifySaid("lengths are");
    }

    void filesThatCannotBeWritten_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"part.step", "part.stl", "part.recipe.json", "part.knead", "part.csv"})
            QTest::newRow(name) << name;
    }

    void filesThatCannotBeWritten()
    {
        QFETCH(QString, name);
        openWithBlock();
        simulate(0.1);
        settle();
        remember();
        const QString path = m_folder->filePath("missing/" + name);
        if (name.endsWith(".csv"))
            m_window->features().hands->exportForces(path);
        else if (name.endsWith(".knead"))
            m_window->projects().saveTo(path);
        else if (name.endsWith(".recipe.json"))
            m_window->features().recipes->exportTo(path);
        else
            m_window->features().exports->exportTo(path);
        verifySaid(name);
        QVERIFY(!QFile::exists(path));
        verifyNothingLost();
    }

    void anExportWithoutAFormatIsRefused()
    {
        openWithBlock();
        remember();
        m_window->features().exports->exportTo(m_folder->filePath("part.xyz"));
        verifySaid("part.xyz");
        verifyNothingLost();
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

    /// Nothing fits on the disk: files may be a few bytes long at most.
    void aFullDiskLeavesNoHalfTable()
    {
        openWithBlock();
        simulate(0.1);
        settle();
        remember();
        {
            const FullDisk disk(8);
            m_window->features().hands->exportForces(m_folder->filePath("forces.csv"));
            // In the log: work may be kept for recovery at that time, which has its own sentence in the banner then.
            QTRY_VERIFY_WITH_TIMEOUT(logged().contains("forces.csv cannot be written"), patience);
            QVERIFY(m_window->banner().isVisible());
        }
        const QStringList lines = logged().split('\n').filter("forces.csv cannot be written");
        QCOMPARE(lines.size(), 1);
        QVERIFY2(lines[0].contains("Error: ") && lines[0].contains("make room on the disk") && lines[0].endsWith('.'),
                 qPrintable(lines[0]));
        QVERIFY(QDir(m_folder->path()).isEmpty());
        verifyNothingLost();
    }

    /// Of real parts, a few in a thousand come back like that; here it is one that says so.
    void whatIsNotSoundInAFileIsSaid()
    {
        Services services = m_services;
        services.exportParts = [this](const std::string& path, const ExportJob& job, bool keepsReport,
                                      TaskControl& control) {
            ExportReport report = m_services.exportParts(path, job, keepsReport, control);
            report.parts.front().closed = false;
            report.parts.front().freeEdges = 3;
            return report;
        };
        show(services);
        openWithBlock();
        remember();
        m_window->features().exports->exportTo(m_folder->filePath("part.stl"));
        verifySaid("Not everything in part.stl is sound; the export report says what is not.");
        QVERIFY(find<QDockWidget>("exportDock")->isVisible());
        QVERIFY(QFile::exists(m_folder->filePath("part.stl")));
        verifyNothingLost();
    }

    void aFolderThatIsGoneCannotBeShown()
    {
        openWithBlock();
        QVERIFY(QDir(m_folder->path()).mkdir("out"));
        m_window->features().exports->exportTo(m_folder->filePath("out/part.stl"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && line("part.stl") != nullptr, patience);
        QVERIFY(QDir(m_folder->filePath("out")).removeRecursively());
        remember();
        clickLine("part.stl");
        auto* viewport = find<QTreeWidget>("modelTree")->viewport();
        const QPoint place = find<QTreeWidget>("modelTree")->visualItemRect(line("part.stl")).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, viewport->mapToGlobal(place));
        QApplication::sendEvent(viewport, &event);
        QTRY_VERIFY(find<QMenu>("modelMenu") != nullptr && find<QMenu>("modelMenu")->isVisible());
        QTest::keyClick(find<QMenu>("modelMenu"), Qt::Key_Down);
        QTest::keyClick(find<QMenu>("modelMenu"), Qt::Key_Return);
        verifySaid("out cannot be shown: look for it with your file manager");
        verifyNothingLost();
    }

    void aSurfaceIsNotSimulated()
    {
        writeCube("open.stl", 1, true);
        m_window->open(QStringList(m_folder->filePath("open.stl")));
        verifySaid("Nothing in this file is closed");
        verifyWhyNot("undo", "There is nothing to undo.");
        verifyWhyNot("play", "Nothing in this part is closed, so nothing can be simulated.");
    }

private:
    bool m_isMemoryFull = false;

    /// A BREP file with a place, and nothing else.
    static QByteArray onlyAPlace()
    {
        return "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\nCurve2ds 0\nCurves 0\n"
               "Polygon3D 0\nPolygonOnTriangulations 0\nSurfaces 0\nTriangulations 0\n\nTShapes 1\nVe\n1e-07\n0 0 0\n"
               "0 0\n\n0101101\n*\n\n+1 0 \n";
    }

    /// A tetrahedron, and objects of the name and nothing else.
    static QByteArray threeMfWithEmptyParts(int count)
    {
        std::string objects =
            "<object id=\"1\" type=\"model\" name=\"corner\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/>"
            "<vertex x=\"60\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"60\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"60\"/>"
            "</vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
            "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh></object>";
        std::string items = "<item objectid=\"1\"/>";
        for (int i = 2; i < 2 + count; ++i) {
            const std::string id = std::to_string(i);
            objects += "<object id=\"" + id + "\" type=\"model\" name=\"empty " + id +
                       "\"><mesh><vertices/><triangles/></mesh></object>";
            items += "<item objectid=\"" + id + "\"/>";
        }
        return QByteArray::fromStdString(
            threeMfOf("<?xml version=\"1.0\" encoding=\"UTF-8\"?><model unit=\"millimeter\" xml:lang=\"en-US\" "
                      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
                      objects + "</resources><build>" + items + "</build></model>"));
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowFileErrorsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_file_errors_test.moc"
