// What cmake --install leaves in a folder, and that the program runs from there.
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "support/build_settings.h"
#include "support/pressed_part.h"

#include <QtTest>

using namespace knead;
using namespace knead::sessions;
using namespace workshop;

class InstalledTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void allFilesAreThere_data();
    void allFilesAreThere();
    void nothingElseIsThere();
    void noPathOfTheSourcesIsInside();
    void theProgramRunsFromThere();
    void thumbnailersAreAnswered_data();
    void thumbnailersAreAnswered();
    void desktopsTakeTheEntry();
    void storesTakeTheDescription();
    void projectsAreToldByTheirBytes();

private:
    QString file(const QString& name) const { return m_prefix.filePath(name); }
    QByteArray bytesOf(const QString& name) const;
    Outcome installed(const QStringList& arguments) const;

    QTemporaryDir m_prefix;
    QTemporaryDir m_home;
};

void InstalledTest::initTestCase()
{
    const Outcome outcome = installInto(m_prefix.path(), {"--strip"}, m_home.path());
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
}

QByteArray InstalledTest::bytesOf(const QString& name) const
{
    QFile opened(file(name));
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

/// The installed program, which knows of nothing but the system.
Outcome InstalledTest::installed(const QStringList& arguments) const
{
    QProcessEnvironment environment;
    environment.insert("PATH", "/usr/bin:/bin");
    return outside(file("bin/knead"), arguments, m_home.path(), environment);
}

void InstalledTest::allFilesAreThere_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"bin/knead",
                             "share/knead/examples/bracket.step",
                             "share/knead/examples/bracket.png",
                             "share/knead/examples/bend-bar.recipe.json",
                             "share/knead/examples/cantilever/cantilever.frd",
                             "share/knead/handbook/keys.md",
                             "share/knead/materials/materials.json",
                             "share/knead/recipe.schema.json",
                             "share/knead/freecad/Knead/package.xml",
                             "share/knead/freecad/Knead/knead.svg",
                             "share/applications/org.knead.Knead.desktop",
                             "share/metainfo/org.knead.Knead.metainfo.xml",
                             "share/mime/packages/org.knead.Knead.xml",
                             "share/thumbnailers/org.knead.Knead.thumbnailer",
                             "share/icons/hicolor/scalable/apps/org.knead.Knead.svg",
                             "share/icons/hicolor/16x16/apps/org.knead.Knead.png",
                             "share/icons/hicolor/256x256/apps/org.knead.Knead.png",
                             "share/icons/hicolor/48x48/mimetypes/application-x-knead.png",
                             "share/man/man1/knead.1.gz",
                             "share/man/man1/knead-run.1.gz",
                             "share/bash-completion/completions/knead",
                             "share/fish/vendor_completions.d/knead.fish",
                             "share/doc/knead/changelog.gz",
                             "share/doc/knead/copyright"})
        QTest::newRow(name) << name;
}

void InstalledTest::allFilesAreThere()
{
    QFETCH(QString, name);
    QVERIFY(QFileInfo(file(name)).isFile());
    QVERIFY(QFileInfo(file(name)).size() > 0);
}

/// Neither tests nor sources nor what only developers start.
void InstalledTest::nothingElseIsThere()
{
    QDirIterator files(m_prefix.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString name = QDir(m_prefix.path()).relativeFilePath(files.next());
        QVERIFY2(!name.contains("generator") && !name.endsWith(".cpp") && !name.endsWith(".h") &&
                     !name.contains("test") && !name.contains("CMake"),
                 qPrintable(name));
    }
    const QStringList folders = QDir(m_prefix.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    for (const QString& folder : folders)
        QVERIFY2((QStringList{"bin", "lib", "libexec", "share"}.contains(folder)), qPrintable(folder));
    for (const QString& folder : QDir(file("lib")).entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        QCOMPARE(folder, QString("python3")); // the module, where it is built
}

/// What counts lines or checks memory says where these are.
void InstalledTest::noPathOfTheSourcesIsInside()
{
    const bool isWhatPeopleRun = buildSetting("KNEAD_SANITIZE").isEmpty() && buildSetting("KNEAD_COVERAGE") != "ON";
    const QByteArray sources = buildSetting("CMAKE_HOME_DIRECTORY");
    QVERIFY(!sources.isEmpty());
    QDirIterator files(m_prefix.path(), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString name = QDir(m_prefix.path()).relativeFilePath(files.next());
        const bool isProgram = name.startsWith("bin") || name.startsWith("libexec");
        if (!isProgram || isWhatPeopleRun)
            QVERIFY2(!bytesOf(name).contains(sources + '/'), qPrintable(name));
    }
}

void InstalledTest::theProgramRunsFromThere()
{
    const Outcome info = installed({"info", file("share/knead/examples/bracket.step")});
    QVERIFY2(info.status == 0, info.errors.c_str());
    QVERIFY2(info.out.find("(2 closed)") != std::string::npos, info.out.c_str());
    // It takes a material from those that are bundled.
    const Outcome run = installed({"run", file("share/knead/examples/bent-tube.recipe.json"), "--out", "tube"});
    QVERIFY2(run.status == 0, run.errors.c_str());
    QVERIFY(QFileInfo::exists(m_home.filePath("tube/tube-bent.step")));
}

void InstalledTest::thumbnailersAreAnswered_data()
{
    QTest::addColumn<bool>("isProject");
    QTest::newRow("a CAD file") << false;
    QTest::newRow("a project, with the view it was saved with") << true;
}

/// As file managers call it: %s is the size, %i the file, %o the picture.
void InstalledTest::thumbnailersAreAnswered()
{
    QFETCH(bool, isProject);
    const std::string part = file("share/knead/examples/bar.step").toStdString();
    QString shown = QString::fromStdString(part);
    if (isProject) {
        QImage view(320, 200, QImage::Format_RGB32);
        view.fill(Qt::magenta);
        QByteArray png;
        QBuffer buffer(&png);
        buffer.open(QIODevice::WriteOnly);
        view.save(&buffer, "PNG");
        Project project = pressedPart(part, 0.004);
        const auto* begin = reinterpret_cast<const std::byte*>(png.constData());
        project.view.thumbnail.assign(begin, begin + png.size());
        shown = m_home.filePath("bar.knead");
        writeProject(shown.toStdString(), packed(project));
    }
    const QString entry = bytesOf("share/thumbnailers/org.knead.Knead.thumbnailer");
    QStringList words = entry.section("\nExec=", 1).section('\n', 0, 0).split(' ');
    QCOMPARE(words.takeFirst(), "knead");
    const QString picture = m_home.filePath("thumbnail.png");
    for (QString& word : words)
        word.replace("%s", "128").replace("%i", shown).replace("%o", picture);
    const Outcome outcome = installed(words);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const QImage image(picture);
    QCOMPARE(image.size(), isProject ? QSize(128, 80) : QSize(128, 128));
    QCOMPARE(image.pixelColor(64, 40) == QColor(Qt::magenta), isProject);
    QVERIFY(QFile::remove(picture));
}

void InstalledTest::desktopsTakeTheEntry()
{
    KNEAD_NEEDS_PROGRAM("desktop-file-validate");
    const Outcome outcome =
        outside("desktop-file-validate", {file("share/applications/org.knead.Knead.desktop")}, m_home.path());
    QCOMPARE(outcome.out + outcome.errors, std::string());
    QCOMPARE(outcome.status, 0);
}

void InstalledTest::storesTakeTheDescription()
{
    KNEAD_NEEDS_PROGRAM("appstreamcli");
    const Outcome outcome = outside(
        "appstreamcli", {"validate", "--no-net", "--no-color", file("share/metainfo/org.knead.Knead.metainfo.xml")},
        m_home.path());
    QVERIFY2(outcome.status == 0, (outcome.out + outcome.errors).c_str());
}

/// The database of types that all desktops read looks at the places of a project where SQLite and the project's mark are.
void InstalledTest::projectsAreToldByTheirBytes()
{
    KNEAD_NEEDS_PROGRAM("update-mime-database");
    QProcessEnvironment environment = serverEnvironment();
    environment.insert("XDG_DATA_HOME", file("share"));
    const Outcome outcome = outside("update-mime-database", {file("share/mime")}, m_home.path(), environment);
    QVERIFY2(outcome.status == 0 && outcome.errors.empty(), outcome.errors.c_str());
    const QByteArray rules = bytesOf("share/mime/magic");
    const QByteArray rule = rules.mid(rules.indexOf("[60:application/x-knead]\n")).split('[').value(1);
    QFile project(m_home.filePath("bar.knead"));
    QVERIFY(project.open(QIODevice::ReadOnly));
    const QByteArray begin = project.read(72);
    const auto rest = [](qsizetype length, const QByteArray& bytes) {
        return QByteArray(1, '\0') + QByteArray(1, static_cast<char>(length)) + bytes + '\n';
    };
    QVERIFY2(rule.contains(">0=" + rest(15, begin.left(15))), rule.constData());
    QVERIFY2(rule.contains("1>68=" + rest(4, begin.mid(68, 4))), rule.constData());
    QVERIFY(bytesOf("share/mime/globs2").contains(":application/x-knead:*.knead\n"));
}

QTEST_GUILESS_MAIN(InstalledTest)
#include "installed_test.moc"
