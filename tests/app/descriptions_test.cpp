#include "support/outside_program.h"

#include <QtTest>

using namespace workshop;

/// Manual pages and completions, as troff and the shells take them.
class DescriptionsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyCommandOfTheHelpHasItsPage();
    void pagesNameEveryOption();
    void troffTakesEveryPage();
    void bashOffers_data();
    void bashOffers();
    void fishOffers_data();
    void fishOffers();
    void zshTakesItsFunction();
    void hiddenCommandsStayHidden();

private:
    QString file(const QString& name) const { return m_folder.filePath(name); }
    std::string textOf(const QString& name) const;
    QStringList commandsOfTheHelp() const;

    QTemporaryDir m_folder;
};

void DescriptionsTest::initTestCase()
{
    const Outcome outcome = runKnead({"describe", m_folder.path()});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QCOMPARE(outcome.out + outcome.errors, std::string());
}

std::string DescriptionsTest::textOf(const QString& name) const
{
    QFile opened(file(name));
    return opened.open(QIODevice::ReadOnly) ? opened.readAll().toStdString() : std::string();
}

/// The words that begin lines below "Subcommands:".
QStringList DescriptionsTest::commandsOfTheHelp() const
{
    const QString help = QString::fromStdString(runKnead({"--help"}).out);
    QStringList names;
    for (const QString& line : help.mid(help.indexOf("Subcommands:")).split('\n').mid(1))
        if (line.startsWith("  ") && line.size() > 2 && line[2] != ' ')
            names << line.trimmed().section(' ', 0, 0);
    return names;
}

void DescriptionsTest::everyCommandOfTheHelpHasItsPage()
{
    const QStringList commands = commandsOfTheHelp();
    QVERIFY(commands.contains("info"));
    QStringList pages{"knead.1"};
    for (const QString& command : commands)
        pages << "knead-" + command + ".1";
    pages.sort();
    QCOMPARE(QDir(file("man")).entryList(QDir::Files, QDir::Name), pages);
    for (const QString& command : commands)
        QVERIFY2(textOf("man/knead.1").find("\\fB" + command.toStdString() + "\\fR") != std::string::npos,
                 qPrintable(command));
}

void DescriptionsTest::pagesNameEveryOption()
{
    for (const QString& command : commandsOfTheHelp()) {
        const QString help = QString::fromStdString(runKnead({command, "--help"}).out);
        const std::string page = textOf("man/knead-" + command + ".1");
        QRegularExpressionMatchIterator options =
            QRegularExpression("^  (?:-\\w,)?(--[\\w-]+)", QRegularExpression::MultilineOption).globalMatch(help);
        QVERIFY(options.hasNext());
        while (options.hasNext()) {
            const QString option = options.next().captured(1);
            QVERIFY2(page.find("\\fB" + QString(option).replace("-", "\\-").toStdString() + "\\fR") !=
                         std::string::npos,
                     qPrintable(command + ' ' + option));
        }
    }
}

void DescriptionsTest::troffTakesEveryPage()
{
    KNEAD_NEEDS_PROGRAM("groff");
    for (const QString& page : QDir(file("man")).entryList(QDir::Files)) {
        const Outcome outcome =
            outside("groff", {"-man", "-Tutf8", "-ww", "-rLL=70n", file("man/" + page)}, m_folder.path());
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.errors.empty(), outcome.errors.c_str());
    }
    const Outcome sweep = outside("groff", {"-man", "-Tascii", "-P-c", file("man/knead-sweep.1")}, m_folder.path());
    QVERIFY2(sweep.out.find("--slurm-option=--partition=long") != std::string::npos, sweep.out.c_str());
}

/// What is typed after "knead", and what is offered then.
void DescriptionsTest::bashOffers_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("offered");
    QTest::newRow("a command") << "conv"
                               << "convert";
    QTest::newRow("commands and folders with one beginning") << "re"
                                                             << "recipe replay results";
    QTest::newRow("files in place of commands") << "par"
                                                << "part.step";
    QTest::newRow("options of the program") << "--vers"
                                            << "--version";
    QTest::newRow("options of a command") << "run --th"
                                          << "--threads";
    QTest::newRow("short options") << "recipe -"
                                   << "--help --output -h -o";
    QTest::newRow("files") << "info p"
                           << "part.step";
    QTest::newRow("files for a file") << "run --csv p"
                                      << "part.step";
    QTest::newRow("folders for a folder") << "run --out ''"
                                          << "results";
    QTest::newRow("choices") << "sweep --engine s"
                             << "slurm";
    QTest::newRow("all choices") << "sweep --engine ''"
                                 << "local slurm";
    QTest::newRow("nothing for a number") << "run --threads ''"
                                          << "";
}

void DescriptionsTest::bashOffers()
{
    QFETCH(QString, typed);
    QFETCH(QString, offered);
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("results"));
    QVERIFY(QFile(folder.filePath("part.step")).open(QIODevice::WriteOnly));
    const QString script = QString("source '%1'; COMP_WORDS=(knead %2); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _knead; "
                                   "printf '%s\\n' \"${COMPREPLY[@]}\"")
                               .arg(file("completions/knead"), typed);
    const Outcome outcome = outside("bash", {"--norc", "-c", script}, folder.path());
    QVERIFY2(outcome.errors.empty(), outcome.errors.c_str());
    QStringList words = QString::fromStdString(outcome.out).split('\n', Qt::SkipEmptyParts);
    words.sort();
    QCOMPARE(words.join(' '), offered);
}

void DescriptionsTest::fishOffers_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QStringList>("offered");
    QTest::newRow("a command") << "conv" << QStringList{"convert"};
    QTest::newRow("options of a command") << "run --thr" << QStringList{"--threads"};
    QTest::newRow("choices") << "sweep --engine " << QStringList{"local", "slurm"};
    QTest::newRow("nothing for a number") << "run --threads " << QStringList{};
}

void DescriptionsTest::fishOffers()
{
    KNEAD_NEEDS_PROGRAM("fish");
    QFETCH(QString, typed);
    QFETCH(QStringList, offered);
    const QTemporaryDir folder;
    const QString script = QString("source '%1'; complete -C 'knead %2'").arg(file("completions/knead.fish"), typed);
    const Outcome outcome = outside("fish", {"--no-config", "-c", script}, folder.path());
    QVERIFY2(outcome.errors.empty(), outcome.errors.c_str());
    QStringList words;
    for (const QString& line : QString::fromStdString(outcome.out).split('\n', Qt::SkipEmptyParts))
        words << line.section('\t', 0, 0);
    words.sort();
    QCOMPARE(words, offered);
}

/// Its function is asked with arguments in place of a terminal: each _arguments gets specifications that it can read.
void DescriptionsTest::zshTakesItsFunction()
{
    KNEAD_NEEDS_PROGRAM("zsh");
    const Outcome read = outside("zsh", {"-f", "-n", file("completions/_knead")}, m_folder.path());
    QVERIFY2(read.status == 0 && read.errors.empty(), read.errors.c_str());
    const QString script = QString("_arguments() { print -rl -- \"$@\"; [[ $1 != -C ]] || state=others }; "
                                   "_alternative() { }; words=(sweep); source '%1'")
                               .arg(file("completions/_knead"));
    const Outcome run = outside("zsh", {"-f", "-c", script}, m_folder.path());
    QVERIFY2(run.errors.empty(), run.errors.c_str());
    const QStringList specifications = QString::fromStdString(run.out).split('\n');
    QVERIFY2(specifications.contains("*:: :->others"), run.out.c_str());
    QVERIFY2(
        !specifications.filter(QRegularExpression("^\\(--engine\\)--engine\\[.*\\]:.*:\\(local slurm\\)$")).empty(),
        run.out.c_str());
}

void DescriptionsTest::hiddenCommandsStayHidden()
{
    for (const char* name : {"completions/knead", "completions/_knead", "completions/knead.fish", "man/knead.1"})
        for (const char* hidden : {"sweep-point", "sweep\\-point", "compensate-recipe", "--end-with-parent"})
            QVERIFY2(textOf(name).find(hidden) == std::string::npos, name);
}

QTEST_GUILESS_MAIN(DescriptionsTest)
#include "descriptions_test.moc"
