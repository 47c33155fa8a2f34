#include "io/importer.h"
#include "support/window_on_test.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/measuring/marks_overlay.h"
#include "ui/run_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

#include <cmath>

using namespace knead;

/// Files that the window writes.
class WindowExportTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { show(m_services); }
    void cleanup() { m_window.reset(); }

    void eachPartHasItsFile_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::newRow("STEP") << "step";
        QTest::newRow("STL") << "stl";
    }
    void eachPartHasItsFile()
    {
        QFETCH(QString, ending);
        openExample("bracket.step");
        ExportRequest request;
        request.onePerPart = true;
        const QTemporaryDir folder;
        write(folder.filePath("out." + ending), request);
        const QStringList wanted{"out-Bracket." + ending, "out-Bushing." + ending};
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files, QDir::Name), wanted);
        const Model& model = *document().content().model;
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            const Model read = importFile(folder.filePath(wanted[static_cast<int>(i)]).toStdString(),
                                          {.unit = ending == "stl" ? "mm" : ""});
            QCOMPARE(read.parts.size(), std::size_t{1});
            QVERIFY(read.parts.front().watertight);
            QVERIFY(std::abs(read.parts.front().volume / model.parts[i].volume - 1) < 0.01);
            if (ending == "step")
                QCOMPARE(read.parts.front().name, model.parts[i].name);
        }
    }

    /// As the comparison has it: that chords hold less than round faces is no change.
    void trianglesOfAPartAtRestHaveItsVolume()
    {
        openExample("bracket.step", 10);
        const QTemporaryDir folder;
        write(folder.filePath("out.stl"), {});
        const auto* rows = find<QTreeWidget>("exportedParts");
        int parts = 0;
        for (int i = 0; i < rows->topLevelItemCount(); ++i)
            if (const QString volume = rows->topLevelItem(i)->text(6); !volume.isEmpty()) {
                QVERIFY2(volume.endsWith("(0 %)"), qPrintable(rows->topLevelItem(i)->text(0) + ": " + volume));
                ++parts;
            }
        QCOMPARE(parts, 2);
    }

    /// The rows of the report bring one to their parts.
    void partsOfTheReportAreShown()
    {
        openExample("bracket.step", 10);
        const QTemporaryDir folder;
        write(folder.filePath("out.stl"), {});
        auto* rows = find<QTreeWidget>("exportedParts");
        auto* shown = find<MarksOverlay>("shownPlace");
        const auto& bodies = document().content().bodies;
        for (int i = 0; i < 2; ++i) {
            QTreeWidgetItem* row = rows->topLevelItem(i);
            const auto body = std::ranges::find(bodies, row->text(0).toStdString(), &FilledBody::name);
            QVERIFY2(body != bodies.end(), qPrintable(row->text(0)));
            Box box;
            for (const Vec3& place : (*body)->mesh.vertices)
                box.extend(place);
            Camera elsewhere;
            elsewhere.target = Vec3(1, 1, 1);
            m_window->viewport().jumpTo(elsewhere);
            if (i == 0) {
                rows->scrollToItem(row);
                QTest::mouseClick(rows->viewport(), Qt::LeftButton, {}, showMeOf(*rows, *row));
            } else {
                rows->setCurrentItem(row);
                QTest::keyClick(rows, Qt::Key_Return);
            }
            QVERIFY2(looksAt(box.center()), qPrintable(row->text(0)));
            QVERIFY(shown->isVisible());
            QCOMPARE(document().selection().kind, Selection::Kind::Body);
            QCOMPARE(document().content().bodies[document().selection().id], *body);
        }
        picture("export-shown");
    }

    /// Two bars opened together: their files have numbers.
    void filesOfPartsOfOneNameStayApart()
    {
        m_window->open(QStringList{example("bar.step"), example("bar.step")});
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(document().content().model->parts.size(), std::size_t{2});
        ExportRequest request;
        request.onePerPart = true;
        const QTemporaryDir folder;
        write(folder.filePath("bars.stl"), request);
        const QStringList files = QDir(folder.path()).entryList(QDir::Files, QDir::Name);
        QCOMPARE(files.size(), 2);
        QVERIFY2(files.contains("bars-Bar.stl"), qPrintable(files.join(' ')));
    }

    void hiddenPartsGetNoFile()
    {
        openExample("bracket.step");
        ExportRequest request;
        request.onePerPart = true;
        request.which = ExportRequest::Which::visible;
        auto options = m_window->viewport().options();
        options.hiddenParts.insert(0);
        m_window->viewport().setOptions(options);
        const QTemporaryDir folder;
        write(folder.filePath("out.stl"), request);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"out-Bushing.stl"});
    }

    void textIsAskedForWhereThereIsAChoice()
    {
        ExportDialog dialog({}, false, m_window.get());
        auto* formats = dialog.findChild<QComboBox*>("exportFormat");
        auto* text = dialog.findChild<QCheckBox*>("exportText");
        auto* unit = dialog.findChild<QComboBox*>("exportUnit");
        text->setChecked(true);
        QStringList withText;
        for (int i = 0; i < formats->count(); ++i) {
            formats->setCurrentIndex(i);
            if (!text->isHidden())
                withText << QString::fromStdString(dialog.format().name);
            QCOMPARE(dialog.request().options.isText, !text->isHidden());
            QCOMPARE(unit->isEnabled(), dialog.format().name != "glTF");
        }
        QCOMPARE(withText, (QStringList{"STL", "PLY"}));
    }

    void textIsWritten()
    {
        openExample("bar.step");
        ExportRequest request;
        request.options.isText = true;
        const QTemporaryDir folder;
        write(folder.filePath("bar.stl"), request);
        QFile file(folder.filePath("bar.stl"));
        QVERIFY(file.open(QFile::ReadOnly));
        QVERIFY(file.readLine().startsWith("solid "));
        QVERIFY(file.readLine().trimmed().startsWith("facet normal"));
    }

private:
    void write(const QString& path, const ExportRequest& request)
    {
        m_window->features().exports->exportTo(path, request);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowExportTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_export_test.moc"
