#include "io/importer.h"
#include "support/skip.h"

#include <QtTest>

#include <map>
#include <numeric>
#include <optional>

using namespace knead;

// Imports the damaged and hostile files that the table BAD.tsv describes. What is expected of each follows from what the
// table asks of a good program; where it leaves a choice, the choice is below.

namespace {

struct Expectation {
    std::optional<int> solids;      ///< nothing: the file is refused
    std::vector<std::string> words; ///< in the refusal, or in what the model says about itself and its parts
};

Expectation refused(std::vector<std::string> words)
{
    return {std::nullopt, std::move(words)};
}

Expectation imported(int solids, std::vector<std::string> words = {})
{
    return {solids, std::move(words)};
}

const std::map<std::string, Expectation>& expectations()
{
    static const std::map<std::string, Expectation> table{
        {"01_empty.step", refused({"is empty"})},
        {"02_one_byte.igs", refused({"none of STEP, IGES"})},
        {"03_random_64k.step", refused({"none of STEP, IGES"})},
        {"04_plain_text.step", refused({"this is a text"})},
        {"05_stl_named.step", imported(0, {"not a closed surface"})},
        {"06_step_named.igs", imported(1)},
        {"07_iges_named.stp", imported(1, {"6 separate faces were sewn"})},
        {"08_brep_named.step", imported(1)},
        {"09_zip_named.step", refused({"zip archive"})},
        {"10_gzip_named.step", refused({"gzip archive"})},
        {"11_utf16.step", refused({"UTF-16"})},
        {"12_utf8_bom_crlf.step", imported(1)},
        {"13_trunc_header.step", refused({"cut off"})},
        {"14_trunc_middle.step", refused({"cut off"})},
        {"15_trunc_before_end.step", refused({"cut off"})},
        {"16_dangling_refs.step", imported(0, {"4 of 6 faces", "open edges"})},
        {"17_type_mismatch.step", imported(0, {"#27", "wrong kind", "4 of 6 faces"})},
        {"18_self_reference.step", refused({"1 shape of the STEP file could not be read"})},
        {"19_duplicate_ids.step", refused({"1 shape of the STEP file could not be read"})},
        {"20_unknown_entities.step", refused({"1 shape of the STEP file could not be read"})},
        {"21_wrong_arg_counts.step", imported(0, {"3 of 6 faces", "open edges"})},
        {"22_no_solid_points_only.step", refused({"no solid and no surface"})},
        {"23_header_only.step", refused({"no shape"})},
        {"24_wrong_schema.step", imported(1, {"IFC4"})},
        {"25_nan_inf.step", refused({"\"NAN\" in place of a number"})},
        {"26_1e308.step", refused({"no finite size"})},
        {"27_far_away_1e9.step", refused({"farther than 100 km"})},
        {"28_tiny_1e-7.step", refused({"smaller than 0.1 um", "length unit"})},
        {"29_huge_1e9_m.step", refused({"farther than 100 km", "length unit"})},
        {"30_no_unit.step", imported(1, {"no length unit", "millimetres were taken"})},
        {"31_silly_unit.step", refused({"length unit"})},
        {"32_zero_height.step", refused({"has no volume"})},
        {"33_missing_face.step", imported(0, {"4 open edges in 1 border", "cannot be filled"})},
        {"34_inside_out.step", imported(1)},
        {"35_vertex_moved.step", refused({"28.6 mm apart"})},
        {"36_header_bomb_2.5MB.step", imported(1)},
        {"37_paren_bomb.step", refused({"nested"})},
        {"38_long_name_1MB.step", refused({"name", "longer than"})},
        {"39_assembly_ok_2x3.step", imported(9)},
        {"40_assembly_cycle.step", refused({"holds itself"})},
        {"41_assembly_bomb_2pow24.step", refused({"more than 100000 parts"})},
        {"42_assembly_deep_3000.step", imported(1)},
        {"43_latin1_name.step", imported(1)},
        {"44_bad_x2_escape.step", imported(1)},
        {"50_iges_broken_params.igs", refused({"in place of a number"})},
        {"51_iges_bad_pointers.igs", refused({"claims 99999999 values"})},
        {"52_iges_truncated.igs", refused({"cut off"})},
        {"53_iges_short_lines.igs", refused({"none of STEP, IGES"})},
        {"54_iges_bad_global.igs", refused({"999999999 letters"})},
        {"55_iges_huge_spline.igs", refused({"damaged"})},
        {"60_brep_truncated.brep", refused({"cut off"})},
        {"61_brep_bad_index.brep", refused({"damaged"})},
        {"62_brep_huge_count.brep", refused({"impossible number of Curves"})},
        {"63_brep_future_version.brep", refused({"version", "V99"})},
        {"64_brep_negative_counts.brep", refused({"impossible number of TShapes"})},
    };
    return table;
}

std::string allWords(const Model& model)
{
    std::vector<knead::Message> sentences = model.warnings;
    sentences.insert(sentences.end(), model.missing.begin(), model.missing.end());
    for (const Part& part : model.parts) {
        sentences.insert(sentences.end(), part.warnings.begin(), part.warnings.end());
        sentences.insert(sentences.end(), part.repairs.begin(), part.repairs.end());
    }
    return std::accumulate(
        sentences.begin(), sentences.end(), std::string(),
        [](const std::string& all, const knead::Message& one) { return all + one.english() + "\n"; });
}

} // namespace

class BadCorpusTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void fileIsImportedOrRefusedAsItShould_data();
    void fileIsImportedOrRefusedAsItShould();
    void everyFileIsExpected();

private:
    QString m_folder;
};

void BadCorpusTest::initTestCase()
{
    m_folder = qEnvironmentVariable("KNEAD_CORPUS");
    if (!m_folder.isEmpty())
        m_folder += "/bad";
}

void BadCorpusTest::fileIsImportedOrRefusedAsItShould_data()
{
    QTest::addColumn<std::string>("file");
    for (const auto& [file, expectation] : expectations())
        QTest::newRow(file.c_str()) << file;
}

void BadCorpusTest::fileIsImportedOrRefusedAsItShould()
{
    if (m_folder.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    QFETCH(std::string, file);
    const Expectation& expected = expectations().at(file);
    std::string words;
    try {
        const Model model = importFile(m_folder.toStdString() + "/" + file);
        words = allWords(model);
        QVERIFY2(expected.solids.has_value(), "a file that should be refused was imported");
        int solids = 0;
        double volume = 0;
        for (const Part& part : model.parts) {
            solids += part.solids;
            volume += part.volume;
            QCOMPARE(part.canBeFilled(), part.solids > 0);
        }
        QCOMPARE(solids, *expected.solids);
        QVERIFY(std::abs(volume - 1e-6 * solids) < 1e-12); // all of them are cubes of 10 mm
    } catch (const std::runtime_error& error) {
        words = error.what();
        QVERIFY2(!expected.solids.has_value(), words.c_str());
        QVERIFY2(words.starts_with(file + ": ") && words.ends_with('.'), words.c_str());
    }
    for (const std::string& word : expected.words)
        QVERIFY2(words.find(word) != std::string::npos, words.c_str());
}

void BadCorpusTest::everyFileIsExpected()
{
    if (m_folder.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    for (const QString& name : QDir(m_folder).entryList(QDir::Files)) {
        const std::string file = name.toStdString();
        const bool isKnown = file == "BAD.tsv" || expectations().contains(file);
        QVERIFY2(isKnown, file.c_str());
    }
}

QTEST_GUILESS_MAIN(BadCorpusTest)
#include "bad_corpus_test.moc"
