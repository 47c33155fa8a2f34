// What cmake --install --component development leaves in a folder, and that a project elsewhere builds on it.
#include "io/importer.h"
#include "support/build_settings.h"

#include <QtTest>

using namespace knead;
using namespace workshop;

class OutsideProjectTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void nothingNamesTheFolderOfTheBuild();
    void allHeadersCompile();
    void theExampleBuildsAndPressesAPart();
    void whatIsMissingIsSaid_data();
    void whatIsMissingIsSaid();

private:
    QStringList filesOf(const QString& folder) const;
    QByteArray bytesOf(const QString& name) const;
    Outcome configure(const QString& build, const QStringList& more) const;

    const QString m_example = QString(KNEAD_RESOURCES) + "/examples/library";
    QTemporaryDir m_prefix;
    QTemporaryDir m_home;
};

void OutsideProjectTest::initTestCase()
{
    const Outcome outcome = installInto(m_prefix.path(), {"--component", "development"}, m_home.path());
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
}

/// Relative to the folder it is installed in.
QStringList OutsideProjectTest::filesOf(const QString& folder) const
{
    QStringList names;
    QDirIterator files(m_prefix.filePath(folder), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext())
        names << QDir(m_prefix.path()).relativeFilePath(files.next());
    names.sort();
    return names;
}

QByteArray OutsideProjectTest::bytesOf(const QString& name) const
{
    QFile opened(m_prefix.filePath(name));
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

/// As a person does, with the compiler that Knead was built with, and what that was to watch.
Outcome OutsideProjectTest::configure(const QString& build, const QStringList& more) const
{
    QString flags = buildSetting("CMAKE_CXX_FLAGS");
    if (const QByteArray sanitizers = buildSetting("KNEAD_SANITIZE"); !sanitizers.isEmpty())
        flags += " -fsanitize=" + sanitizers;
    if (buildSetting("KNEAD_COVERAGE") == "ON")
        flags += " --coverage";
    return outside("cmake",
                   QStringList{"-S", m_example, "-B", m_home.filePath(build), "-G", buildSetting("CMAKE_GENERATOR"),
                               "-DCMAKE_CXX_COMPILER=" + buildSetting("CMAKE_CXX_COMPILER"),
                               "-DCMAKE_CXX_FLAGS=" + flags, "-DCMAKE_PREFIX_PATH=" + m_prefix.path()} +
                       more,
                   m_home.path());
}

void OutsideProjectTest::nothingNamesTheFolderOfTheBuild()
{
    const bool isWhatPeopleUse = buildSetting("CMAKE_BUILD_TYPE") == "Release" &&
                                 buildSetting("KNEAD_SANITIZE").isEmpty() && buildSetting("KNEAD_COVERAGE") != "ON";
    const QByteArray sources = buildSetting("CMAKE_HOME_DIRECTORY");
    const QByteArray build = QFileInfo(buildFolder()).canonicalFilePath().toUtf8();
    QVERIFY(!sources.isEmpty() && !build.isEmpty());
    const QStringList files = filesOf("");
    QVERIFY(files.contains("lib/libknead_core.a") && files.contains("include/knead/io/importer.h") &&
            files.contains("lib/cmake/Knead/KneadConfig.cmake"));
    for (const QString& name : files) {
        if (name.endsWith(".a") && !isWhatPeopleUse)
            continue; // they say where lines are
        const QByteArray bytes = bytesOf(name);
        QVERIFY2(!bytes.contains(sources + '/') && !bytes.contains(build + '/'), qPrintable(name));
        QVERIFY2(!name.endsWith(".cmake") || !bytes.contains("Qt6"), qPrintable(name));
    }
}

/// Together, with nothing beside them but the compiler's own and Eigen.
void OutsideProjectTest::allHeadersCompile()
{
    const QString root = "include/knead/";
    const QStringList headers = filesOf(root);
    QVERIFY(headers.size() > 300);
    QFile source(m_home.filePath("all.cpp"));
    QVERIFY(source.open(QIODevice::WriteOnly));
    for (const QString& name : headers)
        source.write("#include \"" + name.mid(root.size()).toUtf8() + "\"\n");
    source.close();
    const QString eigen = QString(buildSetting("Eigen3_DIR")).replace("share/eigen3/cmake", "include/eigen3");
    const Outcome outcome = outside(buildSetting("CMAKE_CXX_COMPILER"),
                                    {"-std=c++20", "-fsyntax-only", "-Wall", "-Werror", "-I", m_prefix.filePath(root),
                                     "-isystem", eigen, source.fileName()},
                                    m_home.path());
    QVERIFY2(outcome.status == 0, outcome.errors.substr(0, 3000).c_str());
}

void OutsideProjectTest::theExampleBuildsAndPressesAPart()
{
    const Outcome configured = configure("build", {});
    QVERIFY2(configured.status == 0, configured.errors.c_str());
    const Outcome built = outside("cmake", {"--build", m_home.filePath("build")}, m_home.path());
    QVERIFY2(built.status == 0, (built.out + built.errors).c_str());
    const std::string bar = QString(KNEAD_RESOURCES).toStdString() + "/examples/bar.step";
    const Outcome ran =
        outside(m_home.filePath("build/press"), {QString::fromStdString(bar), "pressed.step"}, m_home.path());
    QVERIFY2(ran.status == 0, ran.errors.c_str());
    QVERIFY2(ran.out.ends_with("sound\n") && ran.out.starts_with("Bar: 6 faces"), ran.out.c_str());

    const Part before = importFile(bar).parts.front();
    const Model after = importFile(m_home.filePath("pressed.step").toStdString());
    QCOMPARE(after.parts.size(), std::size_t{1});
    const Part& pressed = after.parts.front();
    QCOMPARE(pressed.name, before.name);
    QVERIFY(pressed.color == before.color);
    QVERIFY(pressed.valid && pressed.watertight);
    QVERIFY(std::abs(pressed.volume / before.volume - 1) < 0.02);
    QVERIFY(pressed.box.sizes().y() > before.box.sizes().y() + 1e-3); // it went aside from under the ball
}

void OutsideProjectTest::whatIsMissingIsSaid_data()
{
    QTest::addColumn<QString>("package");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("of core") << "TBB"
                             << "Knead::core needs TBB, which is not here; on Debian: apt-get install libtbb-dev.";
    QTest::newRow("of io") << "assimp"
                           << "Knead::io needs assimp, which is not here; on Debian: apt-get install libassimp-dev.";
}

void OutsideProjectTest::whatIsMissingIsSaid()
{
    QFETCH(QString, package);
    QFETCH(QString, sentence);
    const Outcome outcome = configure("without " + package, {"-DCMAKE_DISABLE_FIND_PACKAGE_" + package + "=ON"});
    QVERIFY(outcome.status != 0);
    const QString said = QString::fromStdString(outcome.errors).simplified();
    QVERIFY2(said.contains(sentence), qPrintable(said));
}

QTEST_GUILESS_MAIN(OutsideProjectTest)
#include "outside_project_test.moc"
