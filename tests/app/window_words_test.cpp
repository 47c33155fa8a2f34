#include "support/window_on_test.h"
#include "ui/language/language.h"
#include "ui/language/words_of_files.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTextBrowser>
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
            QSKIP("The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void cleanup()
    {
        m_window.reset();
        speak("en");
    }

    void everySentenceIsSaidInEveryLanguage()
    {
        QVERIFY(sentencesOfFiles().size() > 70);
        for (const Language& language : languages()) {
            speak(language.code);
            for (const QString& sentence : sentencesOfFiles()) {
                const QString english = sentence.contains("%6")   ? sentence.arg("11", "22", "33", "44", "55", "66")
                                        : sentence.contains("%5") ? sentence.arg("11", "22", "33", "44", "55")
                                        : sentence.contains("%4") ? sentence.arg("11", "22", "33", "44")
                                        : sentence.contains("%3") ? sentence.arg("11", "22", "33")
                                        : sentence.contains("%2") ? sentence.arg("11", "22")
                                        : sentence.contains("%1") ? sentence.arg("11")
                                                                  : sentence;
                const QString said = inWords(english.toStdString());
                if (QString(language.code) == "en") {
                    QCOMPARE(said, english);
                    continue;
                }
                QVERIFY2(said != english || !english.contains(' '), qPrintable(english));
                for (const char* value : {"11", "22", "33", "44", "55", "66"})
                    QVERIFY2(said.contains(value) == english.contains(value), qPrintable(said));
            }
        }
        speak("de");
        QCOMPARE(inWords("whatever nobody ever said."), QString("whatever nobody ever said."));
        QCOMPARE(
            inWords("The simulation was stopped at 0.5 s: objects moved at 800 m/s. Make the tools slower or raise the "
                    "damping ratio, then reset. It went back to 0.25 s."),
            QString::fromUtf8(
                "Die Simulation wurde bei 0.5 s angehalten: Objekte bewegten sich mit 800 m/s. Die Werkzeuge "
                "verlangsamen oder den Dämpfungsgrad erhöhen, dann zurücksetzen. Sie ging auf 0.25 s zurück."));
        QCOMPARE(inWords("is not closed: 4 open edges in 1 border, 80 mm long in all; the largest opening is 20 mm "
                         "across and flat. It is shown and cannot be filled."),
                 QString::fromUtf8("ist nicht geschlossen: 4 offene Kanten in 1 Rand, zusammen 80 mm lang; die größte "
                                   "Öffnung misst 20 mm und ist eben. Es wird gezeigt und kann nicht gefüllt werden."));
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
        for (const char* sentence :
             {"its surface passes through itself near (10.2, 25, 23.8) mm; other programs may refuse that.",
              "3 of its faces could not be carried along: a face is degenerate.",
              "\"Deckel\": face 4 does not come as close to the skin as was aimed at, 0.01 mm; face 4 is 0.02 mm off.",
              "\"Deckel\": 3 faces, 4, 7, 9, do not come as close to the skin as was aimed at, 0.01 mm; face 4 is 0.02 "
              "mm "
              "off.",
              "\"Bar\" is cracked but in one piece: 12 of its connections are broken, and its skin spans the crack, "
              "stretched to 2.5 times its length there near (1, 2, 3) mm.",
              "\"Bar\": face 5 is made of flat triangles; its other faces are smooth.",
              "\"Bar\": faces 5, 7, 12 are made of flat triangles; its other faces are smooth.",
              "4 faces were added: those that close in themselves came in two, which other programs read more surely.",
              "read back from the file, its bent faces enclose a volume 0.35 % off that of the skin.",
              "read back from the file, its bent faces are inside out.",
              "other programs may read it inside out, as it came back here."}) {
            const QString said = inWords(sentence);
            QVERIFY2(said != sentence, sentence);
            const QRegularExpression numbers("[0-9.]*[0-9]");
            QStringList before;
            for (const QRegularExpressionMatch& found : numbers.globalMatch(sentence))
                before << found.captured();
            for (const QString& number : before)
                QVERIFY2(said.contains(number), qPrintable(said));
        }
        QVERIFY(inWords("3 of its faces could not be carried along: a face is degenerate.").contains("entartet"));
    }

    /// All that is said of files of which something is wrong.
    void nothingOfDamagedFilesStaysEnglish()
    {
        const QString corpus = qEnvironmentVariable("KNEAD_CORPUS");
        if (corpus.isEmpty())
            QSKIP("Set KNEAD_CORPUS to the folder of example files.");
        speak("de");
        int said = 0;
        for (const char* name :
             {"12_utf8_bom_crlf.step", "16_dangling_refs.step", "17_type_mismatch.step", "20_unknown_entities.step",
              "21_wrong_arg_counts.step", "24_wrong_schema.step", "27_far_away_1e9.step", "28_tiny_1e-7.step",
              "29_huge_1e9_m.step", "30_no_unit.step", "31_silly_unit.step", "32_zero_height.step",
              "33_missing_face.step", "34_inside_out.step", "35_vertex_moved.step", "50_iges_broken_params.igs"}) {
            const QString path = corpus + "/bad/" + name;
            if (!QFile::exists(path))
                continue;
            Model model;
            try {
                model = m_services.import({QFile::encodeName(path).toStdString()}, {}, TaskControl::none());
            } catch (const std::exception&) {
                continue; // nothing is read of it
            }
            std::vector<std::string> all = model.warnings;
            all.insert(all.end(), model.missing.begin(), model.missing.end());
            if (model.unitRemark)
                all.push_back(model.unitRemark->sentence);
            for (const Part& part : model.parts) {
                all.insert(all.end(), part.warnings.begin(), part.warnings.end());
                all.insert(all.end(), part.repairs.begin(), part.repairs.end());
            }
            for (const std::string& sentence : all) {
                ++said;
                QVERIFY2(inWords(sentence) != QString::fromStdString(sentence), sentence.c_str());
            }
        }
        QVERIFY(said > 5);
    }

private:
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
