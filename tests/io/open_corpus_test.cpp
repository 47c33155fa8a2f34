#include "core/aggregate/fill.h"
#include "core/geometry/mass_properties.h"
#include "io/importer.h"
#include "support/skip.h"

#include <QtTest>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

using namespace knead;

// Reads the CAD files that the table OPEN.tsv describes, and compares what is found with it. The table was made with
// OpenCASCADE too, but with another program; where the two differ for a good reason, the reason is below.

namespace {

/// The quick integration that the table used is off by 1.3 % on this thread and by 0.16 % on faces cut by long splines;
/// adaptive integration and the limit of finer and finer triangles agree on the values here.
const std::map<std::string, double> correctedVolume{{"o21_build123d_m6_screw.step", 336.736},
                                                    {"o26_soarm_handle.step", 69665.4}}; // [mm^3]

/// Its faces overlap by up to 0.06 mm: the volume is not known better than to a percent.
const std::set<std::string> uncertainVolume{"o24_axom_boxed_sphere_cm.step"};

constexpr int cellsAcross = 20;

struct Totals {
    int solids = 0;
    int shells = 0;
    int faces = 0;
    double volume = 0; ///< [m^3]
    Box box;           ///< [m]
    double maxTolerance = 0;
};

Totals totalsOf(const Model& model)
{
    Totals totals;
    for (const Part& part : model.parts) {
        totals.solids += part.solids;
        totals.shells += part.shells;
        totals.faces += static_cast<int>(part.faces.size());
        totals.volume += part.volume;
        totals.box.extend(part.box);
        totals.maxTolerance = std::max(totals.maxTolerance, part.maxTolerance);
    }
    return totals;
}

std::string expectedUnit(const QString& unit)
{
    static const std::map<QString, std::string> units{{"millimetre", "mm"}, {"mm", "mm"},   {"inch", "inch"},
                                                      {"in", "inch"},       {"metre", "m"}, {"m", "m"},
                                                      {"centimetre", "cm"}, {"-", ""}};
    return units.at(unit.toLower());
}

std::string expectedFormat(const QString& format)
{
    return format == "OCC BREP" ? "BREP" : format.toStdString();
}

/// Coarse, but no coarser than a wall is thick.
double spacingFor(const Part& part)
{
    const double wall = 2 * part.volume / part.area;
    return std::min(spacingForCellsAcross(part.mesh, cellsAcross), wall);
}

bool isClose(double value, double expected, double relative)
{
    return std::abs(value - expected) <= relative * std::abs(expected);
}

} // namespace

class OpenCorpusTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void fileIsReadAsTheTableSays_data();
    void fileIsReadAsTheTableSays();

private:
    void compareWithTable(const Model& model, const QStringList& row) const;
    void checkClosedParts(const Model& model, const std::string& file) const;
    QString cell(const QStringList& row, const QString& column) const
    {
        return row.value(static_cast<int>(m_columns.indexOf(column)));
    }

    QString m_folder;
    QStringList m_columns;
    QList<QStringList> m_rows;
};

void OpenCorpusTest::initTestCase()
{
    m_folder = qEnvironmentVariable("KNEAD_CORPUS");
    if (m_folder.isEmpty())
        return;
    m_folder += "/open";
    QFile table(m_folder + "/OPEN.tsv");
    QVERIFY2(table.open(QIODevice::ReadOnly | QIODevice::Text), "KNEAD_CORPUS has no open/OPEN.tsv");
    m_columns = QString::fromUtf8(table.readLine()).trimmed().split('\t');
    while (!table.atEnd())
        m_rows.append(QString::fromUtf8(table.readLine()).split('\t'));
    QVERIFY(!m_rows.isEmpty());
}

void OpenCorpusTest::fileIsReadAsTheTableSays_data()
{
    QTest::addColumn<QStringList>("row");
    for (const QStringList& row : m_rows)
        QTest::newRow(qPrintable(cell(row, "file").section('/', -1))) << row;
    if (m_rows.isEmpty())
        QTest::newRow("no corpus") << QStringList();
}

void OpenCorpusTest::fileIsReadAsTheTableSays()
{
    QFETCH(QStringList, row);
    if (row.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    const QString file = cell(row, "file").section('/', -1);
    const Model model = importFile((m_folder + "/" + file).toStdString(), {.heal = false}); // the table has no repairs
    compareWithTable(model, row);
    if (!QTest::currentTestFailed())
        checkClosedParts(model, file.toStdString());
}

void OpenCorpusTest::compareWithTable(const Model& model, const QStringList& row) const
{
    const Totals totals = totalsOf(model);
    const std::string file = cell(row, "file").section('/', -1).toStdString();
    QCOMPARE(model.format, expectedFormat(cell(row, "format")));
    QCOMPARE(model.unit, expectedUnit(cell(row, "units")));
    QCOMPARE(totals.solids, cell(row, "solids").toInt());
    QCOMPARE(totals.shells, cell(row, "shells").toInt());
    QCOMPARE(totals.faces, cell(row, "faces").toInt());
    QVERIFY(isClose(1e3 * totals.maxTolerance, cell(row, "max_tolerance").toDouble(), 1e-4));

    const auto corrected = correctedVolume.find(file);
    const double volume = corrected != correctedVolume.end() ? corrected->second : cell(row, "volume_mm3").toDouble();
    QVERIFY2(isClose(1e9 * totals.volume, volume, 1e-3), qPrintable(QString::number(1e9 * totals.volume)));

    // The table has the box of control points, which is the box of the part or somewhat larger.
    const QStringList sides = cell(row, "bbox_mm").split(" x ");
    for (int i = 0; i < 3; ++i)
        QVERIFY2(1e3 * totals.box.sizes()[i] <= sides.value(i).toDouble() * 1.0001, qPrintable(cell(row, "bbox_mm")));
}

void OpenCorpusTest::checkClosedParts(const Model& model, const std::string& file) const
{
    for (const Part& part : model.parts) {
        if (part.solids > 0)
            QVERIFY2(part.canBeFilled(), part.path.c_str());
        if (!part.canBeFilled())
            continue;
        const MassProperties properties = massProperties(part.mesh);
        const double slack = 2e-3 * part.box.diagonal().norm(); // of the triangles
        QVERIFY2((properties.box.min() - part.box.min()).cwiseAbs().maxCoeff() <= slack, part.path.c_str());
        QVERIFY2((properties.box.max() - part.box.max()).cwiseAbs().maxCoeff() <= slack, part.path.c_str());

        if (uncertainVolume.contains(file))
            continue;
        QVERIFY2(isClose(properties.volume, part.volume, 1e-3), part.path.c_str());
        const Aggregate aggregate = fill(part.mesh, {.spacing = spacingFor(part)});
        QVERIFY2(isClose(aggregate.filledVolume, part.volume, 1e-3), part.path.c_str());
    }
}

QTEST_GUILESS_MAIN(OpenCorpusTest)
#include "open_corpus_test.moc"
