#include "ui/dialogs/file_question.h"

#include <QAbstractButton>
#include <QDir>
#include <QFileDialog>
#include <QFileSystemModel>
#include <QHeaderView>
#include <QLineEdit>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeView>
#include <QWidget>

using namespace knead;

class FileQuestionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QCoreApplication::setOrganizationName("knead-test");
        QCoreApplication::setApplicationName("file-question");
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.filePath("settings"));
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QVERIFY(QDir(m_folder.path()).mkdir("one"));
        QVERIFY(QDir(m_folder.path()).mkdir("two"));
        for (const char* name : {"one/a.step", "one/b.step", "two/c.html"}) {
            QFile file(m_folder.filePath(name));
            QVERIFY(file.open(QFile::WriteOnly));
        }
        m_parent.show();
    }

    void init() { QSettings().clear(); }

    void endingsOfFilters()
    {
        QCOMPARE(endingOf("STEP (*.step *.stp)"), "step");
        QCOMPARE(endingOf("Recipes (*.json)"), "json");
        QCOMPARE(endingOf("3MF (*.3mf)"), "3mf");
        QCOMPARE(endingOf("Folder (*)"), QString());
        QCOMPARE(endingOf("Folder (*.)"), QString());
    }

    void columnsAreAsWideAsWhatIsInThem()
    {
        QString answer;
        ask({.name = "write",
             .title = "Write",
             .filters = {"PDF (*.pdf)"},
             .key = "reports",
             .folder = m_folder.filePath("one"),
             .file = "report.pdf"},
            &answer);
        const auto* list = dialog()->findChild<QTreeView*>("treeView");
        QVERIFY(list != nullptr);
        const QHeaderView* header = list->header();
        QVERIFY(header->sectionSize(1) >= list->fontMetrics().horizontalAdvance("999.99 KiB"));
        const QString date = QLocale::system().toString(QDateTime::currentDateTime(), QLocale::ShortFormat);
        QVERIFY(header->sectionSize(3) >= list->fontMetrics().horizontalAdvance(date));
        QTRY_VERIFY(header->sectionSize(0) > 200);
        dialog()->reject();
        QTRY_VERIFY(dialog() == nullptr);
    }

    /// The ending is that of the filter that is chosen, and the folder is remembered under the key of the question.
    void namesGetTheEndingOfTheirFilter()
    {
        QString answer;
        ask({.name = "write",
             .title = "Write",
             .filters = {"PDF (*.pdf)", "Page (*.html *.htm)"},
             .key = "reports",
             .folder = m_folder.filePath("one"),
             .file = "report.pdf"},
            &answer);
        QCOMPARE(name()->text(), "report.pdf");
        QVERIFY(answer.isEmpty());
        enter("other");
        QTRY_COMPARE(answer, m_folder.filePath("one/other.pdf"));
        QCOMPARE(QSettings().value("reports").toString(), m_folder.filePath("one"));
        QTRY_VERIFY(dialog() == nullptr);

        answer.clear();
        ask({.name = "write",
             .title = "Write",
             .filters = {"PDF (*.pdf)", "Page (*.html *.htm)"},
             .key = "reports",
             .file = "report.pdf"},
            &answer);
        QCOMPARE(dialog()->directory().path(), m_folder.filePath("one"));
        dialog()->selectNameFilter("Page (*.html *.htm)");
        emit dialog()->filterSelected("Page (*.html *.htm)"); // as the box of filters does
        enter("third");
        QTRY_COMPARE(answer, m_folder.filePath("one/third.html"));
        QTRY_VERIFY(dialog() == nullptr);
    }

    /// Also where the name without its ending is none of a file.
    void filesAreReplacedOnlyWhenThatIsWanted()
    {
        QString answer;
        ask({.name = "write",
             .title = "Write",
             .filters = {"STEP (*.step)"},
             .key = "parts",
             .folder = m_folder.filePath("one")},
            &answer);
        int asked = 0;
        QTimer refusal; // the question has a loop of its own
        connect(&refusal, &QTimer::timeout, this, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                ++asked;
                box->button(QMessageBox::No)->click();
            }
        });
        refusal.start(50);
        enter("a");
        QCOMPARE(asked, 1);
        QVERIFY(answer.isEmpty());
        QVERIFY(dialog()->isVisible());
        dialog()->reject();
        QTRY_VERIFY(dialog() == nullptr);
        QVERIFY(answer.isEmpty());
        QVERIFY(!QSettings().contains("parts"));
    }

    /// The last folder of parts is proposed where the question has none of its own yet.
    void filesAreRead()
    {
        QSettings().setValue("folder", m_folder.filePath("one"));
        QStringList answer;
        askForFilesToRead(m_parent, {.name = "read", .title = "Read", .filters = {"STEP (*.step)"}, .key = "others"},
                          [&answer](const QStringList& paths) { answer = paths; });
        QCOMPARE(dialog()->directory().path(), m_folder.filePath("one"));
        QTRY_VERIFY(dialog()->isVisible());
        auto* files = dialog()->findChild<QFileSystemModel*>();
        QVERIFY(files != nullptr);
        QTRY_COMPARE(files->rowCount(files->index(m_folder.filePath("one"))),
                     2); // the folder is read on another thread
        enter(m_folder.filePath("one/b.step"));
        QTRY_COMPARE(answer, QStringList(m_folder.filePath("one/b.step")));
        QCOMPARE(QSettings().value("others").toString(), m_folder.filePath("one"));
    }

private:
    void ask(const FileQuestion& question, QString* answer)
    {
        askForFileToWrite(m_parent, question, [answer](const QString& path) { *answer = path; });
        QVERIFY(dialog() != nullptr);
        QTRY_VERIFY(dialog()->isVisible());
    }

    void enter(const QString& text)
    {
        dialog()
            ->activateWindow(); // there may be no window manager that does it; until then the list may take the focus back
        QTRY_VERIFY(dialog()->isActiveWindow());
        name()->setCompleter(nullptr); // its list would take Enter
        name()->setFocus();
        name()->selectAll();
        QTest::keyClicks(name(), text);
        QTest::keyClick(name(), Qt::Key_Return);
    }

    QFileDialog* dialog() { return m_parent.findChild<QFileDialog*>(); }
    QLineEdit* name() { return dialog()->findChild<QLineEdit*>("fileNameEdit"); }

    QTemporaryDir m_folder;
    QWidget m_parent;
};

QTEST_MAIN(FileQuestionTest)
#include "file_question_test.moc"
