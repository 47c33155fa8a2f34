#include "core/geometry/mass_properties.h"
#include "core/skin/new_filling.h"
#include "core/skin/torn_parts.h"
#include "io/export/job_file.h"
#include "support/export_jobs.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace knead;
using namespace export_jobs;

namespace {

/// The bar, cracked from above through a part of its height, its two halves turned away from each other by an angle: the crack
/// gapes, and what is below it bends. @param depth of the crack, as a share of the height
ExportJob crackedBar(const Model& model, double depth, double angle, double cells)
{
    const Box box = boxOf(model);
    const maps::Identity still;
    ExportJob job = jobOf(model, &still, cells);
    PartToExport& bar = job.parts.front();
    const Aggregate& aggregate = *bar.aggregate;
    const double middle = box.center().x() + 0.0004;
    const double root = box.max().z() - depth * box.sizes().z();
    const auto isRight = [&](const Vec3& at) { return at.x() > middle ? 1.0 : 0.0; };
    auto broken = std::make_shared<std::vector<BrokenConnection>>();
    const auto across = brokenAcross(aggregate, isRight);
    for (const ConnectionId& one : *across)
        if (aggregate.lattice.position(one.lower).z() > root)
            broken->push_back({one});
    bar.broken = broken;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
        const Vec3 X = aggregate.lattice.position(i);
        // Above the root each half turns as a whole; below, the turn is spread over the length.
        const double spread = std::clamp((X.x() - middle) / 0.02, -1.0, 1.0);
        const double share = X.z() > root ? (isRight(X) > 0 ? 1 : -1) : spread;
        bar.displacements[i] = Vec3(share * angle * std::max(0.0, X.z() - root), 0, 0);
    }
    return job;
}

/// Written as STEP they are sound, have smooth faces, and are together what the part was.
void checkSmoothPieces(const Model& model, const ExportJob& job)
{
    const ExportedFile file = exportCad(FormatKind::Step, jobFromBytes(jobToBytes(job)), TaskControl::none());
    QVERIFY(file.report.isSound());
    double rest = 0;
    for (const PartExportReport& part : file.report.parts) {
        QVERIFY2(part.form == PartExportReport::Form::exact, part.reason.english().c_str());
        QVERIFY(part.closed && part.valid && part.freeEdges == 0);
        QVERIFY2(part.largestDeviation <= part.tolerance, qPrintable(QString::number(part.largestDeviation)));
        QVERIFY2(std::abs(part.volumeError()) < 1e-3, qPrintable(QString::number(part.volumeError())));
        // The ends of the bar have five of its faces and where they were cut, its middle four and both cuts.
        QCOMPARE(part.facesAfter, 6);
        rest += part.restVolume;
    }
    QVERIFY2(std::abs(rest / model.parts.front().volume - 1) < 1e-4,
             qPrintable(QString::number(rest / model.parts.front().volume - 1)));
}

} // namespace

/// Bodies that have come apart, or are about to, as STEP.
class BrokenExportTest : public QObject {
    Q_OBJECT

private slots:
    void tornPartsComeAsClosedPieces();
    void piecesThatAKnifeCutKeepTheirFaces();
    void piecesOfABodyThatWasFilledAnewKeepTheirFaces();
    void piecesThatWereFilledAnewKeepTheirFaces();
    void crumbsAreWrittenWithWhatTheyCameOff();
    void crackedPartsInOnePieceSaySo();
    void partsThatAKnifeIsInKeepTheirFaces();
    void partsThatGapeWhereTheyToreAreFlat();
    void crackedPartsThatAreFoldedSayWhyTheyAreFlat();
    void piecesThatPassThroughThemselvesAreNotSound();
};

void BrokenExportTest::tornPartsComeAsClosedPieces()
{
    const Model model = example("bar.step");
    const maps::Identity still;
    const Box box = boxOf(model);
    Eigen::Index along = 0;
    const double length = box.sizes().maxCoeff(&along);
    const auto shattered = [&](const Vec3& at) { // in five pieces
        return std::floor(5 * (at[along] - box.min()[along]) / length + 0.3 * std::sin(300 * at[(along + 1) % 3]));
    };
    const auto severed = [&](const Vec3& at) { return at[along] < box.center()[along] + 0.001 ? 0.0 : 1.0; };
    struct Case {
        std::function<double(const Vec3&)> side;
        std::size_t pieces;
    };
    for (const Case& one : {Case{severed, 2}, Case{shattered, 5}}) {
        ExportJob job = jobOf(model, &still);
        PartToExport& whole = job.parts.front();
        whole.broken = brokenAcross(*whole.aggregate, one.side);
        for (ObjectIndex i = 0; i < whole.displacements.size(); ++i) // apart from each other
            whole.displacements[i] = 0.01 * one.side(whole.aggregate->lattice.position(i)) * Vec3::Unit(along);
        job = withPieces(std::move(job), 6000, TaskControl::none());
        QVERIFY2(job.parts.size() >= one.pieces, qPrintable(QString::number(job.parts.size())));
        const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
        QVERIFY(file.report.isSound());
        double volume = 0;
        for (const PartExportReport& part : file.report.parts) {
            QVERIFY(part.closed && part.valid && part.freeEdges == 0);
            volume += part.volume;
        }
        QVERIFY2(std::abs(volume / model.parts.front().volume - 1) < 0.01, qPrintable(QString::number(volume)));
    }
}

/// Cut along a plane, along a curved surface, and twice; the pieces bent and moved apart.
void BrokenExportTest::piecesThatAKnifeCutKeepTheirFaces()
{
    const Model model = example("bar.step");
    const maps::Identity still;
    const Box box = boxOf(model);
    const Vec3 center = box.center();
    using Height = std::function<double(const Vec3&)>;
    const Height plane = [&](const Vec3& at) { return (at - center).dot(Vec3(1, 0.3, 0.2).normalized()) - 0.0007; };
    const Height curved = [&](const Vec3& at) {
        const double y = at.y() - center.y();
        return at.x() - center.x() - 20 * y * y - 0.1 * (at.z() - center.z());
    };
    const Height left = [&](const Vec3& at) { return at.x() - center.x() + 0.021; };
    const Height right = [&](const Vec3& at) { return at.x() - center.x() - 0.0213; };
    for (const std::vector<Height>& cuts : {std::vector{plane}, std::vector{curved}, std::vector{left, right}}) {
        ExportJob job = jobOf(model, &still);
        PartToExport& whole = job.parts.front();
        const Lattice& lattice = whole.aggregate->lattice;
        auto broken = std::make_shared<std::vector<BrokenConnection>>();
        for (const Height& height : cuts) {
            const auto across =
                brokenAcross(*whole.aggregate, [&](const Vec3& at) { return height(at) < 0 ? 0.0 : 1.0; });
            for (const BrokenConnection& one : *across) {
                const Vec3 lower = lattice.position(one.lower);
                const Vec3 way = lattice.direction(static_cast<int>(one.direction));
                double low = 0;
                double high = 1;
                for (int n = 0; n < 50; ++n) {
                    const double middle = 0.5 * (low + high);
                    ((height(lower + middle * way) < 0) == (height(lower) < 0) ? low : high) = middle;
                }
                broken->push_back({one, std::clamp(low, 1e-6, 1 - 1e-6)});
            }
        }
        whole.broken = broken;
        for (ObjectIndex i = 0; i < whole.displacements.size(); ++i) { // apart from each other, and bent
            const Vec3 at = lattice.position(i);
            const auto piece =
                static_cast<double>(std::ranges::count_if(cuts, [&](const Height& height) { return height(at) >= 0; }));
            whole.displacements[i] =
                Vec3(0.01 * piece, 0, 3 * (at.x() - center.x()) * (at.x() - center.x()) * (piece > 0 ? 1 : -1));
        }
        job = withPieces(std::move(job), 6000, TaskControl::none(), true);
        QCOMPARE(job.parts.size(), cuts.size() + 1);
        checkSmoothPieces(model, job);
        if (QTest::currentTestFailed())
            return;
    }
}

/// Bent, filled anew as it was then, cut along a plane, and the pieces moved apart.
void BrokenExportTest::piecesOfABodyThatWasFilledAnewKeepTheirFaces()
{
    const Model model = example("bar.step");
    const Vec3 center = boxOf(model).center();
    const auto bent = [&](const Vec3& at) { return Vec3(0, 0, 3 * (at.x() - center.x()) * (at.x() - center.x())); };
    const auto height = [&](const Vec3& at) { return (at - center).dot(Vec3(1, 0.3, 0.2).normalized()) - 0.0007; };
    const maps::Identity still;
    ExportJob job = jobOf(model, &still);
    PartToExport& whole = job.parts.front();
    for (ObjectIndex i = 0; i < whole.displacements.size(); ++i)
        whole.displacements[i] = bent(whole.aggregate->lattice.position(i));
    std::shared_ptr<const ShapeFitting> fitting;
    whole.aggregate = refilled(whole.part.mesh, whole.aggregate, whole.displacements,
                               {.spacing = whole.aggregate->lattice.spacing}, fitting);
    const Lattice& lattice = whole.aggregate->lattice;
    auto broken = std::make_shared<std::vector<BrokenConnection>>();
    const auto across = brokenAcross(*whole.aggregate, [&](const Vec3& at) { return height(at) < 0 ? 0.0 : 1.0; });
    for (const BrokenConnection& one : *across) {
        const double low = height(lattice.position(one.lower));
        const double high = height(lattice.position(one.lower) + lattice.direction(static_cast<int>(one.direction)));
        broken->push_back({one, std::clamp(low / (low - high), 1e-6, 1 - 1e-6)});
    }
    whole.broken = broken;
    whole.displacements.assign(lattice.size(), Vec3::Zero());
    for (ObjectIndex i = 0; i < lattice.size(); ++i)
        whole.displacements[i].x() = height(lattice.position(i)) < 0 ? 0 : 0.01;
    job = withPieces(std::move(job), 6000, TaskControl::none(), true);
    QCOMPARE(job.parts.size(), std::size_t{2});
    checkSmoothPieces(model, job);
    if (QTest::currentTestFailed())
        return;
}

/// Cut along a plane, moved apart, bent and filled anew piece by piece, and bent on.
void BrokenExportTest::piecesThatWereFilledAnewKeepTheirFaces()
{
    const Model model = example("bar.step");
    const Vec3 center = boxOf(model).center();
    const auto height = [&](const Vec3& at) { return (at - center).dot(Vec3(1, 0.3, 0.2).normalized()) - 0.0007; };
    const maps::Identity still;
    ExportJob cut = jobOf(model, &still);
    PartToExport& whole = cut.parts.front();
    const Lattice& lattice = whole.aggregate->lattice;
    std::vector<BrokenConnection> broken;
    const auto across = brokenAcross(*whole.aggregate, [&](const Vec3& at) { return height(at) < 0 ? 0.0 : 1.0; });
    for (const BrokenConnection& one : *across) {
        const double low = height(lattice.position(one.lower));
        const double high = height(lattice.position(one.lower) + lattice.direction(static_cast<int>(one.direction)));
        broken.push_back({one, std::clamp(low / (low - high), 1e-6, 1 - 1e-6)});
    }
    for (ObjectIndex i = 0; i < lattice.size(); ++i) {
        const Vec3 at = lattice.position(i);
        const double side = height(at) < 0 ? 0 : 1;
        whole.displacements[i] = Vec3(0.01 * side, 0, 2 * (at.x() - center.x()) * (at.x() - center.x()));
    }
    KnownFittings fittings;
    const NewFilling filling =
        newFilling({whole.part.mesh, whole.aggregate, whole.displacements, broken, {}}, lattice.spacing, fittings);
    QCOMPARE(filling.pieces, 2U);
    QVERIFY(filling.aggregate->former->isInPieces());
    QVERIFY(std::abs(filling.aggregate->meshVolume / model.parts.front().volume - 1) < 1e-3);
    whole.aggregate = filling.aggregate;
    whole.displacements.resize(filling.aggregate->size());
    for (ObjectIndex i = 0; i < filling.aggregate->size(); ++i) {
        const Vec3 here = filling.places.at(i);
        const Vec3 on = here + Vec3(0, filling.pieceOfNew[i] == 0 ? 0 : 0.002, (here.x() - center.x()) * 0.1);
        whole.displacements[i] = on - filling.aggregate->lattice.position(i);
    }
    for (const bool isCad : {true, false}) {
        ExportJob job = withPieces(cut, 6000, TaskControl::none(), isCad);
        QCOMPARE(job.parts.size(), std::size_t{2});
        if (!isCad) {
            double volume = 0;
            for (const PartToExport& part : job.parts) {
                QVERIFY(isWatertight(part.part.mesh));
                volume += massProperties(part.part.mesh).volume;
            }
            QVERIFY2(std::abs(volume / model.parts.front().volume - 1) < 1e-3,
                     qPrintable(QString::number(volume / model.parts.front().volume - 1)));
            continue;
        }
        checkSmoothPieces(model, job);
        if (QTest::currentTestFailed())
            return;
    }
}

void BrokenExportTest::crumbsAreWrittenWithWhatTheyCameOff()
{
    const Model model = example("bar.step");
    const Box box = boxOf(model);
    const maps::Identity still;
    for (const bool isSevered : {false, true}) {
        ExportJob job = jobOf(model, &still);
        PartToExport& whole = job.parts.front();
        const Lattice& lattice = whole.aggregate->lattice;
        const Vec3 inRight = box.center() + Vec3(box.sizes().x() / 4, 0, 0);
        ObjectIndex crumb = 0;
        for (ObjectIndex i = 0; i < lattice.size(); ++i)
            if ((lattice.position(i) - inRight).norm() < (lattice.position(crumb) - inRight).norm())
                crumb = i;
        const Vec3 off = lattice.position(crumb);
        whole.broken = brokenAcross(*whole.aggregate, [&](const Vec3& at) {
            return (at - off).norm() < 1e-9 ? 2.0 : isSevered && at.x() < box.center().x() + 0.0004 ? 1.0 : 0.0;
        });
        job = withPieces(std::move(job), 6000, TaskControl::none());
        QCOMPARE(job.parts.size(), std::size_t{isSevered ? 2U : 1U});
        const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
        QVERIFY(file.report.isSound());
        std::size_t said = 0;
        for (const PartExportReport& part : file.report.parts)
            for (const knead::Message& remark : part.remarks)
                said += remark.english().starts_with("pieces too small") &&
                                remark.english().ends_with("objects in them: 1.")
                            ? 1
                            : 0;
        QCOMPARE(said, std::size_t{1});
    }
}

void BrokenExportTest::crackedPartsInOnePieceSaySo()
{
    const Model model = example("bar.step");
    ExportJob job = withPieces(crackedBar(model, 0.5, 0.01, 40), 6000, TaskControl::none());
    QCOMPARE(job.parts.size(), std::size_t{1});
    const PartToExport& bar = job.parts.front();
    // By brute force: how far the ends of broken connections are apart.
    double most = 0;
    for (const ConnectionId& one : *bar.broken) {
        const Lattice& lattice = bar.aggregate->lattice;
        const Vec3 here = lattice.position(one.lower);
        const Vec3 rest = lattice.direction(static_cast<int>(one.direction));
        const Vec3 there = here + rest;
        ObjectIndex upper = 0;
        for (ObjectIndex i = 0; i < lattice.size(); ++i)
            if ((lattice.position(i) - there).norm() < 1e-9)
                upper = i;
        most = std::max(most,
                        (there + bar.displacements[upper] - here - bar.displacements[one.lower]).norm() / rest.norm());
    }
    const ExportedFile file = exportCad(FormatKind::Step, jobFromBytes(jobToBytes(job)), TaskControl::none());
    const PartExportReport& report = file.report.parts.front();
    for (const std::string& line : linesOf(file.report))
        qInfo("%s", line.c_str());
    QVERIFY(!report.remarks.empty());
    const QString remark = QString::fromStdString(report.remarks.front().english());
    QVERIFY(remark.startsWith("\"Bar\" is cracked but in one piece: " + QString::number(bar.broken->size()) +
                              " of its connections are broken"));
    QVERIFY2(remark.contains("stretched to " + QString::asprintf("%.3g", most) + " times"), qPrintable(remark));
    QVERIFY(most > 1.02);
    QCOMPARE(report.form, PartExportReport::Form::exact);
    QVERIFY(report.closed && report.valid);
}

/// A knife is half way through a bar, whose halves are bent apart: its faces and the sides of the cut are smooth.
void BrokenExportTest::partsThatAKnifeIsInKeepTheirFaces()
{
    const Model model = example("bar.step");
    ExportJob job = crackedBar(model, 0.5, 0.1, 40);
    PartToExport& whole = job.parts.front();
    const double middle = boxOf(model).center().x() + 0.0004;
    const double root = boxOf(model).center().z();
    for (ObjectIndex i = 0; i < whole.aggregate->size(); ++i) { // smoothly, and more and more to the mouth
        const Vec3 X = whole.aggregate->lattice.position(i);
        const double part = 0.001 * std::pow(std::max(0.0, X.z() - root) / 0.01, 3);
        whole.displacements[i] = Vec3(X.x() > middle ? part : -part, 0, 0);
    }
    auto cut = std::make_shared<std::vector<BrokenConnection>>(*whole.broken);
    for (BrokenConnection& one : *cut)
        one.cutAt = (middle - whole.aggregate->lattice.position(one.lower).x()) /
                    whole.aggregate->lattice.direction(static_cast<int>(one.direction)).x();
    whole.broken = cut;
    job = withPieces(std::move(job), 6000, TaskControl::none(), true);
    QCOMPARE(job.parts.size(), std::size_t{1});
    QVERIFY(job.parts.front().slit != nullptr);
    QVERIFY(job.parts.front().slit->hasTip);
    const ExportedFile file = exportCad(FormatKind::Step, jobFromBytes(jobToBytes(job)), TaskControl::none());
    for (const std::string& line : linesOf(file.report))
        qInfo("%s", line.c_str());
    const PartExportReport& report = file.report.parts.front();
    QVERIFY2(report.form == PartExportReport::Form::exact, report.reason.english().c_str());
    QVERIFY(report.closed && report.valid && report.freeEdges == 0);
    QVERIFY2(report.largestDeviation <= report.tolerance, qPrintable(QString::number(report.largestDeviation)));
    QVERIFY2(std::abs(report.volumeError()) < 5e-4, qPrintable(QString::number(report.volumeError())));
    QCOMPARE(report.facesBefore, 6);
    QCOMPARE(report.restVolume, model.parts.front().volume);
    // Two ends, both halves of its four sides, and both sides of the cut.
    QCOMPARE(report.facesAfter, 12);
}

void BrokenExportTest::partsThatGapeWhereTheyToreAreFlat()
{
    const Model model = example("bar.step");
    for (const bool isCad : {true, false}) {
        const ExportJob job = withPieces(crackedBar(model, 0.5, 0.1, 40), 6000, TaskControl::none(), isCad);
        QCOMPARE(job.parts.size(), std::size_t{1});
        const PartToExport& bar = job.parts.front();
        QVERIFY(bar.slit == nullptr);
        QVERIFY(isWatertight(bar.part.mesh));
        QCOMPARE(bar.part.name, model.parts.front().name);
        QVERIFY2(bar.remarks.front().english().find("but in one piece: it gapes by") != std::string::npos,
                 bar.remarks.front().english().c_str());
    }
}

void BrokenExportTest::crackedPartsThatAreFoldedSayWhyTheyAreFlat()
{
    const Model model = example("bar.step");
    // The halves have gone into each other.
    ExportJob job = withPieces(crackedBar(model, 0.5, -0.9, 16), 6000, TaskControl::none());
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    const PartExportReport& report = file.report.parts.front();
    QCOMPARE(report.form, PartExportReport::Form::faceted);
    QVERIFY2(report.reason.english().find("folded") != std::string::npos, report.reason.english().c_str());
    QVERIFY2(report.remarks.front().english().find("is cracked") != std::string::npos,
             report.remarks.front().english().c_str());
}

/// A roll of more than a turn, the end of which is in its beginning.
class Roll final : public maps::PointMap {
public:
    explicit Roll(const Box& box)
        : m_box(box)
    {
    }
    double featureSize() const override { return 0.05 * m_box.sizes().x(); }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const Vec3 share = (point - m_box.min()).cwiseQuotient(m_box.sizes());
        const double turn = 7.5 * share.x();
        const double radius = (0.18 + 0.03 * share.x() - 0.125 * share.z()) * m_box.sizes().x();
        return {radius * std::sin(turn), point.y(), -radius * std::cos(turn)};
    }

private:
    Box m_box;
};

/// Rolled up by more than a turn, without its tip; and the same as a part that came as a mesh.
void BrokenExportTest::piecesThatPassThroughThemselvesAreNotSound()
{
    Model model = example("bar.step");
    const Box box = boxOf(model);
    const Roll roll(box);
    constexpr double cells = 28;
    ExportJob job = jobOf(model, &roll, cells);
    const double tip = box.min().x() + 0.1 * box.sizes().x();
    job.parts.front().broken =
        brokenAcross(*job.parts.front().aggregate, [&](const Vec3& at) { return at.x() < tip ? 1.0 : 0.0; });
    model.parts.front().exact.reset();
    for (const ExportJob& each :
         {withPieces(std::move(job), 800, TaskControl::none()), jobOf(model, &roll, cells / 2)}) {
        const ExportReport report = exportCad(FormatKind::Step, each, TaskControl::none()).report;
        std::size_t crossing = 0;
        for (const PartExportReport& part : report.parts) {
            QCOMPARE(part.form, PartExportReport::Form::faceted);
            QVERIFY(part.crossesItself == part.fold.has_value() && part.isSound() != part.crossesItself);
            crossing += part.crossesItself ? 1 : 0;
        }
        QCOMPARE(crossing, std::size_t{1});
    }
}

QTEST_GUILESS_MAIN(BrokenExportTest)
#include "broken_export_test.moc"
