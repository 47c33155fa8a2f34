// Qt's macro is a name of TBB's, too, and comes with the precompiled headers.
#pragma push_macro("emit")
#undef emit
#include "support/thread_limit.h"
#pragma pop_macro("emit")
// Hours of a hand at random, in pieces: what was done is undone, saved, exported, and comes to the same bits again.
#include "app/cad_program.h"
#include "io/importer.h"
#include "io/material_library.h"
#include "support/deep.h"
#include "support/soak_piece.h"

#include <QTemporaryDir>
#include <QtTest>

#include <malloc.h>
#include <unistd.h>

using namespace knead;
using namespace knead::soak;

namespace {

/// Memory of this process, without what was given back already [bytes].
double resident()
{
    malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    double all = 0;
    double inUse = 0;
    file >> all >> inUse;
    return inUse * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// What is allocated, whatever the rest of the process takes [bytes].
double allocated()
{
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Of the line that fits points best.
double slopeOf(const std::vector<std::pair<double, double>>& points)
{
    double x = 0;
    double y = 0;
    for (const auto& [px, py] : points) {
        x += px / static_cast<double>(points.size());
        y += py / static_cast<double>(points.size());
    }
    double both = 0;
    double square = 0;
    for (const auto& [px, py] : points) {
        both += (px - x) * (py - y);
        square += (px - x) * (px - x);
    }
    return square > 0 ? both / square : 0;
}

std::uint64_t numberFrom(const char* name, std::uint64_t otherwise)
{
    bool isOne = false;
    const auto number = static_cast<std::uint64_t>(qEnvironmentVariable(name).toULongLong(&isOne));
    return isOne ? number : otherwise;
}

void say(const Piece& piece, const Outcome& outcome, double seconds)
{
    std::string text = "seed " + std::to_string(piece.seed);
    const auto add = [&text](const std::string& name, double value) {
        char number[32];
        std::snprintf(number, sizeof number, "%.4g", value);
        text += "; " + name + " " + number;
    };
    add("simulated [s]", outcome.simulated);
    add("took [s]", seconds);
    add("entries", static_cast<double>(outcome.entries));
    add("commands", static_cast<double>(outcome.commands));
    for (const auto& [name, value] : outcome.findings.most)
        add(name, value);
    for (const auto& [name, count] : outcome.findings.counts)
        add(name, count);
    qInfo("%s; resident %.1f MB, allocated %.1f MB", text.c_str(), 1e-6 * resident(), 1e-6 * allocated());
    for (const std::string& fault : outcome.findings.faults)
        qInfo("FAULT in seed %d: %s", static_cast<int>(piece.seed), fault.c_str());
}

} // namespace

class SoakTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
        for (const char* name : {"bar.step", "bracket.step", "grip.step", "handle.step", "lump.step", "plate.step"})
            m_workshop.models.push_back(
                std::make_shared<const Model>(importFile(std::string(KNEAD_RESOURCES) + "/examples/" + name)));
        for (const MaterialPreset& preset : readMaterials(KNEAD_RESOURCES "/materials/materials.json"))
            m_workshop.materials.insert(m_workshop.materials.end(), preset.material.youngsModulus < 3e6 ? 12 : 1,
                                        preset.material); // stiff ones take long
    }

    void aHandAtRandomBreaksNothing()
    {
        const std::uint64_t first = numberFrom("KNEAD_SOAK_FIRST", 1);
        const std::uint64_t pieces = numberFrom("KNEAD_SOAK_PIECES", loadOf(2, 8));
        const auto duration = static_cast<double>(numberFrom("KNEAD_SOAK_SECONDS", loadOf(2, 30)));
        const bool isWhole = qEnvironmentVariableIsSet("KNEAD_SOAK_SECONDS"); // by ./dev soak
        const std::uint64_t again = loadOf(2, 4);                             // every so manieth piece is done twice
        const QString folder = qEnvironmentVariable("KNEAD_SOAK_KEEP", m_folder.path());
        double simulated = 0;
        std::size_t faults = 0;
        std::vector<std::pair<double, double>> memory; // [s], [bytes]
        for (std::uint64_t seed = first; seed < first + pieces; ++seed) {
            Piece piece{.seed = seed,
                        .duration = duration,
                        .mostGestures = isWhole ? static_cast<int>(12 * duration) : loadOf(25, 200),
                        .objects = isWhole ? 300.0 : loadOf(120.0, 300.0),
                        .folder = folder.toStdString()};
            qInfo("piece of seed %d", static_cast<int>(seed));
            QElapsedTimer timer;
            timer.start();
            Outcome outcome = onThreads(1, [&] { return carryOut(m_workshop, piece); });
            const double seconds = 1e-3 * static_cast<double>(timer.elapsed());
            if (seed % again == 0) {
                piece.writesCad = false;
                const Outcome other = onThreads(3, [&] { return carryOut(m_workshop, piece); });
                if (other.digest != outcome.digest)
                    outcome.findings.fault("the same hand came to other bits on three threads");
            }
            say(piece, outcome, seconds);
            simulated += outcome.simulated;
            faults += outcome.findings.faults.size();
            memory.emplace_back(simulated, resident());
        }
        const std::vector<std::pair<double, double>> half(
            memory.begin() + static_cast<std::ptrdiff_t>(memory.size() / 2), memory.end());
        const double growth = 3600e-6 * slopeOf(half); // [MB/h]
        qInfo("soak: %.2f hours simulated in %d pieces, %d faults, memory grows by %.2f MB an hour", simulated / 3600,
              static_cast<int>(pieces), static_cast<int>(faults), growth);
        QCOMPARE(faults, std::size_t{0});
        if (half.size() >= 20)
            QVERIFY2(growth < 10, qPrintable(QString::number(growth)));
    }

private:
    QTemporaryDir m_folder;
    Workshop m_workshop;
};

QTEST_GUILESS_MAIN(SoakTest)

#include "soak_test.moc"
