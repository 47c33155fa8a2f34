#include "support/window_on_test.h"
#include "ui/language/language.h"
#include "ui/language/said.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <array>
#include <filesystem>
#include <fstream>

using namespace knead;

/// What is said of files, in the language of the window.
class WindowWordsTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void cleanup()
    {
        m_window.reset();
        speak("en");
    }

    /// As core puts them together.
    void whatIsSaidOfRunsIsSaidInEveryLanguage()
    {
        const Message body("Run", "the body");
        const Message remedy("Run", "Make the tools slower");
        const Message stopped = Message("Run", "The simulation was stopped at %1 s: %2 It went back to %3 s.");
        const std::vector<Message> sentences{
            stopped.with("0.5",
                         Message("Run", "objects of %1 moved at %2 m/s, and nothing in the scene makes them faster "
                                        "than %3 m/s. %4 or raise the damping ratio, then reset.")
                             .with("\"box\"", 800, 30, remedy),
                         "0.25"),
            stopped.with(11,
                         Message("Run", "a position is no longer a number. %1 or make the material softer, then reset.")
                             .with(Message("Run", "Lower gravity")),
                         22),
            stopped.with(
                11,
                Message("Run", "material of %1 was squashed flat or turned inside out. Press less far, raise Poisson's "
                               "ratio or the yield stress, or fill the part with a smaller spacing, then reset.")
                    .with(body),
                22),
            stopped.with(
                11,
                Message("Run", "%1 J came from nowhere, of %2 J in the scene: the steps no longer follow the material. "
                               "%3 or raise the damping ratio, then reset.")
                    .with(33, 44,
                          Message("Run", "Choose a shorter time step for mass scaling, which added %1 % to the mass")
                              .with(55)),
                22),
            stopped.with(11,
                         Message("Run", "the equations of %1 steps in a row could not be solved, though the last was "
                                        "only %2 s long. %3 or raise the damping ratio, then reset.")
                             .with(33, 44,
                                   Message("Run", "The tool \"%1\" is %2 mm deep in %3: let it begin outside and press "
                                                  "less far, make it slower")
                                       .with("block", 55, body)),
                         22),
            stopped.with(11,
                         Message("Run", "the chosen time step of %1 s is longer than the stable one of %2 s. Choose a "
                                        "shorter one, or a softer or more damped material.")
                             .with(33, 44),
                         22),
            Message("Run", "The tool \"%1\" begins %2 mm inside %3, which is pushed away with great force, in very "
                           "short steps. Let it begin outside.")
                .with("block", 11, body),
            Message("Run", "\"%1\" broke into %2 pieces, and a rigid body would weld them together where they are. "
                           "Keep it deformable, or reset before it becomes rigid.")
                .with("bar", 11),
            Message("Run",
                    "Energy is off by %1 % of all that went round. Choose a shorter time step, or make tools slower.")
                .with(11),
            Message("Balance", "%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic).")
                .with(Message("Balance", "The body")),
            Message("Run", "%1: explicit integration needs %2 steps per second, more than real time allows.")
                .with(Message("Run", "Implicit Euler"), Message("Number", "%1 million").with(11)),
        };
        const QRegularExpression numbers("[0-9.]*[0-9]");
        for (const Language& language : languages()) {
            speak(language.code);
            for (const Message& sentence : sentences) {
                const QString english = QString::fromStdString(sentence.english());
                const QString translated = said(sentence);
                if (QString(language.code) == "en") {
                    QCOMPARE(translated, english);
                    continue;
                }
                QVERIFY2(translated != english, qPrintable(english));
                for (const QRegularExpressionMatch& number : numbers.globalMatch(english))
                    QVERIFY2(translated.contains(number.captured()), qPrintable(translated));
                for (const char* part : {"simulation was", "the body", "Make the", "or raise"})
                    QVERIFY2(!translated.contains(part), qPrintable(translated));
            }
        }
        speak("de");
        QCOMPARE(said(sentences.front()),
                 QString::fromUtf8("Die Simulation wurde bei 0.5 s angehalten: Objekte von \"box\" bewegten sich mit "
                                   "800 m/s, und nichts in der Szene macht sie schneller als 30 m/s. Die Werkzeuge "
                                   "verlangsamen oder den Dämpfungsgrad erhöhen, dann zurücksetzen. Sie ging auf 0.25 "
                                   "s zurück."));
    }

    void whatIsSaidOfFilesIsPutTogetherInGerman()
    {
        speak("de");
        const Message borders =
            Message("Repair", "%1 in %2, %3 long in all; the largest opening is %4 across and flat")
                .with(Message("Repair", "%1 open edges").with(4), Message("Repair", "1 border"), "80 mm", "20 mm");
        QCOMPARE(said(Message("Import", "is not closed: %1. It is shown and cannot be filled.").with(borders)),
                 QString::fromUtf8("ist nicht geschlossen: 4 offene Kanten in 1 Rand, zusammen 80 mm lang; die größte "
                                   "Öffnung misst 20 mm und ist eben. Es wird gezeigt und kann nicht gefüllt werden."));
        QCOMPARE(said(Message::verbatim("whatever %1 ever said.").with("nobody")),
                 QString("whatever nobody ever said."));
    }

    void theImportReportFollowsTheLanguage()
    {
        QSettings().setValue("language", "de");
        show(m_services);
        const QTemporaryDir folder;
        const QString path = folder.filePath("box.stl");
        writeOpenBox(path);
        m_window->open(QStringList(path));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && !document().isEmpty(), patience);
        auto* remarks = find<QTextBrowser>("importRemarks");
        QTRY_VERIFY2(remarks->toPlainText().contains(QString::fromUtf8("ist keine geschlossene Fläche: ")),
                     qPrintable(remarks->toPlainText()));
        QVERIFY(remarks->toPlainText().contains("offene Kanten"));
        QVERIFY2(remarks->toPlainText().contains("1 Dreieck war doppelt da und wurde entfernt."),
                 qPrintable(remarks->toPlainText()));
        QVERIFY(find<QPlainTextEdit>("log")->toPlainText().contains("Warnung: "));
        picture("import-report-de");
        Preferences chosen = readPreferences();
        chosen.language = "fr";
        m_window->features().preferences->set(chosen);
        QTRY_VERIFY2(remarks->toPlainText().contains(QString::fromUtf8("n'est pas une surface fermée : ")),
                     qPrintable(remarks->toPlainText()));
        chosen.language = "en";
        m_window->features().preferences->set(chosen);
        QTRY_VERIFY(remarks->toPlainText().contains("is not a closed surface: "));
        QSettings().setValue("language", "en");
    }

    void materialsHaveNamesInEveryLanguage()
    {
        QSettings().setValue("language", "de");
        show(m_services);
        openExample("bar.step");
        auto* choice = find<QComboBox>("materialPreset");
        Preferences chosen = readPreferences();
        for (const auto& [language, name] :
             {std::pair("de", "Knetmasse"), std::pair("fr", "Pâte à modeler"), std::pair("en", "Plasticine")}) {
            chosen.language = language;
            m_window->features().preferences->set(chosen);
            QTRY_VERIFY2(choice->findText(QString::fromUtf8(name)) >= 0, name);
            choice->setCurrentText(QString::fromUtf8(name));
            emit choice->activated(choice->currentIndex());
            QTRY_COMPARE(choice->currentText(), QString::fromUtf8(name));
        }
        QSettings().setValue("language", "en");
    }

    void theExportReportFollowsTheLanguage()
    {
        QSettings().setValue("language", "de");
        show(m_services);
        const QTemporaryDir folder;
        const QString path = folder.filePath("box.stl");
        writeClosedBox(path);
        m_window->open(QStringList(path));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && !document().isEmpty(), patience);
        m_window->features().exports->exportTo(folder.filePath("box.step"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && shown().contains("Netz"), patience);
        QVERIFY2(shown().contains(QString::fromUtf8("es kam als Netz, das keine glatten Flächen hat.")),
                 qPrintable(shown()));
        picture("export-report-de");
        Preferences chosen = readPreferences();
        for (const auto& [language, words] :
             {std::pair("nl", "het kwam als net"), std::pair("en", "it came as a mesh, which has no smooth faces.")}) {
            chosen.language = language;
            m_window->features().preferences->set(chosen);
            QTRY_VERIFY2(shown().contains(words), qPrintable(shown()));
        }
        QSettings().setValue("language", "en");
    }

    /// As the writers put them together.
    void whatIsWrittenIsSaidInGerman()
    {
        speak("de");
        const Message degenerate("Export", "a face is degenerate");
        for (const Message& sentence :
             {Message("Export", "its surface passes through itself near %1; other programs may refuse that.")
                  .with("(10.2, 25, 23.8) mm"),
              Message("Export", "%1 of its faces could not be carried along: %2.").with(3, degenerate),
              Message("Export", "\"%1\": face %2 does not come as close to the skin as was aimed at, %3 mm; face %4 is "
                                "%5 mm off.")
                  .with("Deckel", 4, "0.01", 4, "0.02"),
              Message("Export",
                      "\"%1\": %2 faces, %3, do not come as close to the skin as was aimed at, %4 mm; face %5 "
                      "is %6 mm off.")
                  .with("Deckel", 3, "4, 7, 9", "0.01", 4, "0.02"),
              Message("Export", "\"%1\" is cracked but in one piece: %2 of its connections are broken, and its skin "
                                "spans the crack, stretched to %3 times its length there near %4.")
                  .with("Bar", 12, "2.5", "(1, 2, 3) mm"),
              Message("Export", "\"%1\": face %2 is made of flat triangles; its other faces are smooth.")
                  .with("Bar", 5),
              Message("Export", "\"%1\": faces %2 are made of flat triangles; its other faces are smooth.")
                  .with("Bar", "5, 7, 12"),
              Message("Export", "%1 faces were added: those that close in themselves came in two, which other programs "
                                "read more surely.")
                  .with(4),
              Message("Export", "read back from the file, its bent faces enclose a volume %1 % off that of the skin.")
                  .with("0.35"),
              Message("Export", "read back from the file, its bent faces are inside out."),
              Message("Export", "other programs may read it inside out, as it came back here.")}) {
            const QString inGerman = said(sentence);
            const QString english = QString::fromStdString(sentence.english());
            QVERIFY2(inGerman != english, qPrintable(english));
            const QRegularExpression numbers("[0-9.]*[0-9]");
            QStringList before;
            for (const QRegularExpressionMatch& found : numbers.globalMatch(english))
                before << found.captured();
            for (const QString& number : before)
                QVERIFY2(inGerman.contains(number), qPrintable(inGerman));
        }
        QVERIFY(said(Message("Export", "%1 of its faces could not be carried along: %2.").with(3, degenerate))
                    .contains("entartet"));
    }

    /// All that is said of files of which something is wrong, and of those that are refused.
    void nothingOfDamagedFilesStaysEnglish()
    {
        const QString corpus = qEnvironmentVariable("KNEAD_CORPUS");
        if (corpus.isEmpty())
            KNEAD_SKIP_WITHOUT("corpus", "Set KNEAD_CORPUS to the folder of example files.");
        std::vector<Message> all;
        std::size_t refused = 0;
        for (const QString& path : filesIn(corpus + "/bad"))
            try {
                const Model model = m_services.import({QFile::encodeName(path).toStdString()}, {}, TaskControl::none());
                addSentences(model, all);
            } catch (const Problem& problem) {
                all.push_back(problem.message());
                ++refused;
            }
        QVERIFY(refused > 5);
        QVERIFY(all.size() > refused + 5);
        for (const char* language : {"de", "fr", "nl"}) {
            speak(language);
            std::size_t translated = 0;
            for (const Message& sentence : all)
                translated += checkTranslated(sentence);
            QVERIFY(translated >= all.size());
            QVERIFY(!QTest::currentTestFailed());
        }
    }

private:
    static QStringList filesIn(const QString& folder)
    {
        QStringList paths;
        for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files, QDir::Name))
            paths << file.filePath();
        return paths;
    }

    static void addSentences(const Model& model, std::vector<Message>& all)
    {
        const auto add = [&](const std::vector<Message>& some) { all.insert(all.end(), some.begin(), some.end()); };
        add(model.warnings);
        add(model.missing);
        if (model.unitRemark)
            all.push_back(model.unitRemark->sentence);
        for (const Part& part : model.parts) {
            add(part.warnings);
            add(part.repairs);
        }
    }

    /// Whether all that is not the same in every language is known in the one spoken now.
    /// @return how many texts in it are
    static std::size_t checkTranslated(const Message& message)
    {
        std::size_t count = 0;
        if (!message.subject().empty()) {
            const QString text = QCoreApplication::translate(message.subject().c_str(), message.text().c_str());
            if (text == QString::fromStdString(message.text()))
                QTest::qFail(message.text().c_str(), __FILE__, __LINE__);
            ++count;
        }
        for (const Message& argument : message.arguments())
            count += checkTranslated(argument);
        return count;
    }

    QString shown()
    {
        QStringList lines{find<QLabel>("exportSummary")->text()};
        auto* tree = find<QTreeWidget>("exportedParts");
        for (QTreeWidgetItemIterator item(tree); *item != nullptr; ++item)
            lines << (*item)->text(0);
        return lines.join('\n');
    }

    /// In millimetres, without its lid, one triangle twice.
    static void writeOpenBox(const QString& path)
    {
        std::vector<Corners> triangles = walls;
        triangles.push_back(walls.back());
        write(path, triangles);
    }

    static void writeClosedBox(const QString& path)
    {
        std::vector<Corners> triangles = walls;
        triangles.insert(triangles.end(), {{4, 5, 6}, {4, 6, 7}});
        write(path, triangles);
    }

    using Corners = std::array<int, 3>;
    inline static const std::vector<Corners> walls{{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                                                   {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

    static void write(const QString& path, const std::vector<Corners>& triangles)
    {
        std::ofstream out(path.toStdString());
        const double p[8][3] = {{0, 0, 0},  {20, 0, 0},  {20, 20, 0},  {0, 20, 0},
                                {0, 0, 20}, {20, 0, 20}, {20, 20, 20}, {0, 20, 20}};
        out << "solid box\n";
        for (const Corners& corners : triangles) {
            out << "facet normal 0 0 0\nouter loop\n";
            for (const int c : corners)
                out << "vertex " << p[c][0] << ' ' << p[c][1] << ' ' << p[c][2] << '\n';
            out << "endloop\nendfacet\n";
        }
        out << "endsolid box\n";
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowWordsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_words_test.moc"
