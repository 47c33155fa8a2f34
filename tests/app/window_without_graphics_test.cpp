// What a person is told where nothing can be drawn.
#include "app/gui.h"
#include "support/skip.h"
#include "ui/run_window.h"

#include <QApplication>
#include <QMessageBox>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

using namespace knead;

namespace {

QString& boxText()
{
    static QString text;
    return text;
}

/// Closes the box when it has come, as a person does who has read it.
void closeBoxWhenItComes()
{
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box == nullptr || !box->isVisible())
            return;
        boxText() = box->text();
        if (const QString folder = qEnvironmentVariable("KNEAD_PICTURES"); !folder.isEmpty())
            box->grab().save(folder + "/no-graphics.png");
        QTest::mouseClick(box->button(QMessageBox::Close), Qt::LeftButton);
    });
    timer->start(50);
}

bool& isClosing()
{
    static bool is = false;
    return is;
}

void whenTheApplicationBegins()
{
    if (isClosing())
        QTimer::singleShot(0, qApp, closeBoxWhenItComes);
}

} // namespace

Q_COREAPP_STARTUP_FUNCTION(whenTheApplicationBegins)

class WindowWithoutGraphicsTest : public QObject {
    Q_OBJECT

private slots:
    /// The whole program, in an environment without OpenGL, or with one that is too old: it says so and waits, where it crashed.
    void theProgramSaysWhatItNeeds_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("found");
        QTest::newRow("no OpenGL") << "QT_XCB_GL_INTEGRATION"
                                   << "none"
                                   << "here is none";
        QTest::newRow("an old one") << "MESA_GL_VERSION_OVERRIDE"
                                    << "2.1"
                                    << "here is 2.1";
    }

    void theProgramSaysWhatItNeeds()
    {
        QFETCH(QString, name);
        QFETCH(QString, value);
        QFETCH(QString, found);
        if (qEnvironmentVariable("QT_QPA_PLATFORM", "xcb") != "xcb" || qEnvironmentVariable("DISPLAY").isEmpty())
            KNEAD_SKIP_WITHOUT("display", "The program needs a display: run this test under xvfb-run.");
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(name, value);
        environment.insert("LC_ALL", "C.UTF-8");
        environment.insert("HOME", QDir::tempPath() + "/nobody-lives-here");
        environment.remove("XDG_CONFIG_HOME");
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::MergedChannels);
        program.start(KNEAD_PROGRAM, {KNEAD_RESOURCES "/examples/bar.step"});
        QByteArray said;
        const auto isSaid = [&] {
            program.waitForReadyRead(100);
            said += program.readAll();
            return said.contains("knead: The window needs OpenGL 3.2 or later to draw, and " + found.toUtf8());
        };
        QTRY_VERIFY2_WITH_TIMEOUT(isSaid(), said, 30'000);
        QVERIFY2(said.contains("Install or update the driver"), said);
        QVERIFY(!program.waitForFinished(300)); // a box says it, until it is closed
        QCOMPARE(program.state(), QProcess::Running);
        program.kill();
        program.waitForFinished();
    }

    void theBoxSaysItAndEndsTheProgram()
    {
        if (qEnvironmentVariable("DISPLAY").isEmpty())
            KNEAD_SKIP_WITHOUT("display", "The box needs a display: run this test under xvfb-run.");
        const QTemporaryDir settings; // not those of a person
        qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
        qputenv("LC_ALL", "C.UTF-8");
        qputenv("QT_XCB_GL_INTEGRATION", "none");
        isClosing() = true;
        char name[] = "knead";
        char* arguments[] = {name, nullptr};
        QCOMPARE(showMainWindow(1, arguments, fileServices(), {}), 1);
        isClosing() = false;
        QVERIFY2(boxText().startsWith("The window needs OpenGL 3.2"), qPrintable(boxText()));
    }
};

int main(int argc, char** argv)
{
    WindowWithoutGraphicsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_without_graphics_test.moc"
