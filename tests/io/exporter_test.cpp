#include "core/skin/refilled.h"
#include "io/export/job_file.h"
#include "support/export_jobs.h"
#include "support/hard_parts.h"

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <GProp_GProps.hxx>
#include <QtTest>
#include <STEPControl_Reader.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <numeric>

using namespace knead;
using namespace export_jobs;

class ExporterTest : public QObject {
    Q_OBJECT
private slots:
    void untouchedPartsStayWhatTheyWere_data();
    void untouchedPartsStayWhatTheyWere();
    void bentPartsAreSmoothAndSound();
    void whatWasJustFilledAnewLeavesAsItIs();
    void facesThatStayAreKeptExactly();
    void namesColorsAndLayersOfAnyScriptSurvive();
    void unitsOfChoice();
    void smoothEdgesStaySmooth();
    void meshesBecomeSolidsOfFlatFaces();
    void facesFollowAFold();
    void facesFollowACrease();
    void aFaceThatIsFarOffIsFlatAlone();
    void facesThatAreFarOffAreFlatOnes();
    void surfacesThatPassThroughThemselvesAreNamed();
    void chordsBesideAnEdgeAreNoCrossing();
    void wallsThatTouchAtRestDoNotCross();
    void boredBallsAreReadByOthersToo();
    void igesKeepsNames();
    void facesThatAreNotFollowedAreNamed();
    void jobsAndReportsSurviveTheirWay();
    void nothingToExportIsRefused();
};

void ExporterTest::untouchedPartsStayWhatTheyWere_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("ending");
    QTest::newRow("STEP") << static_cast<int>(FormatKind::Step) << "step";
    QTest::newRow("IGES") << static_cast<int>(FormatKind::Iges) << "iges";
    QTest::newRow("BREP") << static_cast<int>(FormatKind::Brep) << "brep";
}

void ExporterTest::untouchedPartsStayWhatTheyWere()
{
    QFETCH(int, kind);
    QFETCH(QString, ending);
    const Model model = example("bracket.step");
    const ExportedFile file = exportCad(static_cast<FormatKind>(kind), jobOf(model, nullptr), TaskControl::none());
    QVERIFY(file.report.isSound());
    QCOMPARE(file.report.parts.size(), model.parts.size());
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        const PartExportReport& part = file.report.parts[i];
        QCOMPARE(part.facesAfter, static_cast<int>(model.parts[i].faces.size()));
        QCOMPARE(part.keptFaces, part.facesAfter);
        QCOMPARE(part.edgesAfter, model.parts[i].edges);
        QVERIFY(std::abs(part.volume - model.parts[i].volume) < 1e-6 * model.parts[i].volume);
        QVERIFY(part.samples > 100);
        QVERIFY(part.largestDeviation < 1e-9);
    }
    const Model back = readBack(file, qPrintable(ending));
    QCOMPARE(back.parts.size(), model.parts.size());
    QVERIFY((boxOf(back).min() - boxOf(model).min()).norm() < 1e-6);
}

void ExporterTest::bentPartsAreSmoothAndSound()
{
    for (const char* name : {"bar.step", "bracket.step", "handle.step"}) {
        const Model model = example(name);
        const maps::Bend bend(boxOf(model), 0.5 * std::numbers::pi);
        const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, &bend), TaskControl::none());
        for (const std::string& line : linesOf(file.report))
            qInfo("%s", line.c_str());
        QVERIFY(file.report.isSound());
        for (const PartExportReport& part : file.report.parts) {
            QCOMPARE(part.form, PartExportReport::Form::exact);
            QCOMPARE(part.facesAfter, part.facesBefore);
            QVERIFY(part.nameKept && part.colorsKept);
            QVERIFY(part.remarks.empty() || name != std::string("bar.step"));
            QVERIFY(part.largestDeviation > 0 && part.largestDeviation <= part.tolerance);
            QVERIFY(part.largestKink < 0.5 * std::numbers::pi / 180);
        }
        QVERIFY(name != std::string("handle.step") || file.report.parts.front().smoothEdges > 0);
        const std::size_t faces = std::accumulate(file.report.parts.begin(), file.report.parts.end(), std::size_t{0},
                                                  [](std::size_t sum, const PartExportReport& part) {
                                                      return sum + static_cast<std::size_t>(part.facesAfter);
                                                  });
        QVERIFY2(file.bytes.size() <= 20'000 * faces, qPrintable(QString::number(file.bytes.size() / faces)));
    }
}

/// Its objects have not moved since, and yet the part is not what was opened; however many former shapes there are.
void ExporterTest::whatWasJustFilledAnewLeavesAsItIs()
{
    const Model model = example("bar.step");
    const maps::Bend bend(boxOf(model), 0.25 * std::numbers::pi);
    ExportJob job = jobOf(model, &bend);
    PartToExport& part = job.parts.front();
    const double spacing = part.aggregate->lattice.spacing;
    std::shared_ptr<const ShapeFitting> fitting;
    part.aggregate = refilled(part.part.mesh, part.aggregate, part.displacements, {.spacing = spacing}, fitting, {});
    part.displacements.assign(part.aggregate->size(), Vec3::Zero());
    auto later = std::make_shared<Aggregate>(*part.aggregate);
    later->former = std::make_shared<const FormerShape>(part.aggregate, part.displacements);
    std::vector<Box> boxes;
    for (const std::shared_ptr<const Aggregate>& filling : {part.aggregate, std::shared_ptr<const Aggregate>(later)}) {
        part.aggregate = filling;
        const ExportJob arrived = jobFromBytes(jobToBytes(job));
        QCOMPARE(arrived.parts[0].aggregate->former->stages(), filling->former->stages());
        const ExportedFile file = exportCad(FormatKind::Step, arrived, TaskControl::none());
        QVERIFY(file.report.isSound());
        QCOMPARE(file.report.parts.front().form, PartExportReport::Form::exact);
        QCOMPARE(file.report.parts.front().keptFaces, 0);
        boxes.push_back(boxOf(readBack(file, "step")));
    }
    std::vector<Vec3> bent = model.parts[0].mesh.vertices;
    bend.evaluate(model.parts[0].mesh.vertices, bent);
    Box box;
    for (const Vec3& place : bent)
        box.extend(place);
    for (const Box& found : boxes)
        QVERIFY((found.min() - box.min()).norm() < 0.1 * spacing && (found.max() - box.max()).norm() < 0.1 * spacing);
}

/// A dent at one end of the bar does not reach the other.
void ExporterTest::facesThatStayAreKeptExactly()
{
    const Model model = example("bar.step");
    const Box box = boxOf(model);
    const maps::Dent dent(box.max(), -0.1 * box.sizes().cwiseMin(Vec3::Constant(0.02)), 0.05 * box.diagonal().norm());
    ExportJob job = jobOf(model, &dent);
    for (Vec3& displacement : job.parts.front().displacements)
        if (displacement.norm() < 1e-7)
            displacement.setZero();
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    QVERIFY(file.report.isSound());
    const PartExportReport& part = file.report.parts.front();
    QVERIFY2(part.keptFaces >= 1 && part.keptFaces < part.facesAfter, qPrintable(QString::number(part.keptFaces)));
}

void ExporterTest::namesColorsAndLayersOfAnyScriptSurvive()
{
    Model model = example("bracket.step");
    model.parts[0].name = "Würfel 立方体 'a' \"b\"";
    model.parts[1].name = "μέρος, часть & <c>";
    model.parts[0].color = Color{0.1F, 0.6F, 0.3F};
    model.parts[0].faces[3].color = Color{0.9F, 0.2F, 0.1F};
    model.parts[0].faces[1].name = "Auflagefläche 取付面 'A'";
    model.parts[0].faces[2].name = model.parts[0].faces[5].name = "bore";
    model.parts[1].faces[0].name = "bore";
    model.parts[1].layer = "слой 2";
    model.tree = {"root",
                  std::nullopt,
                  {{"Сборка 組立", std::nullopt, {{model.parts[0].name, 0, {}}, {model.parts[1].name, 1, {}}}}}};
    const maps::Bend bend(boxOf(model), 0.1 * std::numbers::pi);
    for (const SmoothMap* map : {static_cast<const SmoothMap*>(nullptr), static_cast<const SmoothMap*>(&bend)}) {
        const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, map), TaskControl::none());
        for (const PartExportReport& part : file.report.parts)
            QVERIFY2(part.nameKept && part.colorsKept && part.remarks.empty(), part.name.c_str());
        const Model back = readBack(file, "step");
        QCOMPARE(back.parts.size(), std::size_t{2});
        for (std::size_t p = 0; p < 2; ++p)
            for (std::size_t f = 0; f < model.parts[p].faces.size(); ++f)
                QCOMPARE(back.parts[p].faces[f].name, model.parts[p].faces[f].name);
    }
    // IGES has no names of faces, and that is said.
    const ExportedFile iges = exportCad(FormatKind::Iges, jobOf(model, nullptr), TaskControl::none());
    QCOMPARE(iges.report.parts.front().remarks.front().english(),
             std::string("not all names of its faces were found again."));
    const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, nullptr), TaskControl::none());
    const Model back = readBack(file, "step");
    QCOMPARE(back.parts[0].name, model.parts[0].name);
    QCOMPARE(back.parts[1].name, model.parts[1].name);
    QCOMPARE(back.parts[1].layer, model.parts[1].layer);
    QCOMPARE(back.tree.children.front().name, std::string("Сборка 組立"));
    QVERIFY(back.parts[0].faces[3].color.has_value());
    QVERIFY(std::abs(back.parts[0].faces[3].color->r - 0.9F) < 0.01F);
}

void ExporterTest::unitsOfChoice()
{
    const Model model = example("bar.step");
    for (const char* unit : {"mm", "cm", "m", "inch", "ft"}) {
        ExportJob job = jobOf(model, nullptr);
        job.options.unit = unit;
        job.options.useAp214 = true;
        const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
        QCOMPARE(file.report.unit, std::string(unit));
        QCOMPARE(file.report.format, std::string("STEP AP214"));
        const Model back = readBack(file, "step");
        QVERIFY(std::abs(back.parts.front().volume - model.parts.front().volume) < 1e-6 * model.parts.front().volume);
    }
    ExportJob job = jobOf(model, nullptr);
    job.options.unit = "furlong";
    QVERIFY_EXCEPTION_THROWN(exportCad(FormatKind::Step, job, TaskControl::none()), std::runtime_error);
}

/// The normals of triangles that share a vertex on an edge between two faces that met smoothly.
void ExporterTest::smoothEdgesStaySmooth()
{
    const Model model = example("handle.step"); // a lathed grip: its faces meet smoothly
    const maps::Bend bend(boxOf(model), 0.3);
    const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, &bend), TaskControl::none());
    const Model back = readBack(file, "step");
    const auto sharpest = [](const Model& of) { // angle between faces along their common triangles' edges
        double most = 0;
        const TriangleMesh& mesh = of.parts.front().mesh;
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> owner;
        const auto normal = [&](std::size_t t) {
            const auto& c = mesh.triangles[t];
            return (mesh.vertices[c[1]] - mesh.vertices[c[0]])
                .cross(mesh.vertices[c[2]] - mesh.vertices[c[0]])
                .normalized();
        };
        std::vector<double> angles;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = mesh.triangles[t][i];
                const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
                const auto other = owner.find({b, a});
                if (other != owner.end() && mesh.faceOfTriangle[t] != mesh.faceOfTriangle[other->second])
                    angles.push_back(std::acos(std::clamp(normal(t).dot(normal(other->second)), -1.0, 1.0)));
                owner[{a, b}] = t;
            }
        std::sort(angles.begin(), angles.end());
        for (const double angle : angles)
            if (angle < 0.3) // those that are smooth, up to the triangles
                most = std::max(most, angle);
        return std::pair(most, angles.size());
    };
    const auto [before, beforeCount] = sharpest(model);
    const auto [after, afterCount] = sharpest(back);
    QVERIFY(beforeCount > 10 && afterCount > 10);
    QVERIFY2(after < before + 0.5 / 180 * std::numbers::pi, qPrintable(QString("%1 %2").arg(before).arg(after)));
}

void ExporterTest::meshesBecomeSolidsOfFlatFaces()
{
    Model model = example("bar.step");
    const std::size_t triangles = model.parts.front().mesh.triangles.size();
    model.parts.front().exact.reset();
    const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, nullptr), TaskControl::none());
    QVERIFY(file.report.isSound());
    const PartExportReport& part = file.report.parts.front();
    QCOMPARE(part.form, PartExportReport::Form::faceted);
    QVERIFY(!part.reason.empty());
    QCOMPARE(triangles, std::size_t{12});
    QCOMPARE(part.facesAfter, 6); // triangles in a plane are one face
    QCOMPARE(part.edgesAfter, 12);
    QVERIFY(part.closed && part.valid);
}

bool isFoldSaid(const PartExportReport& part)
{
    return std::ranges::any_of(part.remarks, [](const knead::Message& remark) {
        return remark.english().find("its material is folded over itself near (") != std::string::npos;
    });
}

/// Turned inside out in its middle, and bent, so that no face of it stays flat.
class FoldMap final : public maps::PointMap {
public:
    explicit FoldMap(const Box& box)
        : m_box(box)
    {
    }
    double featureSize() const override { return 0.1 * m_box.sizes().maxCoeff(); }

protected:
    Vec3 place(const Vec3& point) const override
    {
        Eigen::Index along = 0;
        const double length = m_box.sizes().maxCoeff(&along);
        const double t = (point[along] - m_box.center()[along]) / length;
        Vec3 moved = point;
        moved[along] -= 2 * length * t * std::exp(-40 * t * t);
        moved[(along + 1) % 3] += 0.2 * length * t * t;
        moved[(along + 2) % 3] += 0.2 * length * t * t;
        return moved;
    }

private:
    Box m_box;
};

/// Its faces are no worse there than flat ones would be, and where it is folded is said.
void ExporterTest::facesFollowAFold()
{
    const Model model = example("bar.step");
    const FoldMap fold(boxOf(model));
    const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, &fold, 40), TaskControl::none());
    const PartExportReport& part = file.report.parts.front();
    for (const knead::Message& remark : part.remarks)
        qInfo("%s", remark.english().c_str());
    QVERIFY2(part.form == PartExportReport::Form::exact, part.reason.english().c_str());
    QVERIFY(part.closed && part.valid && part.facesAfter == part.facesBefore);
    QVERIFY(isFoldSaid(part));
}

/// A groove across the top of a body whose sides nearly touch.
class CreaseMap final : public maps::PointMap {
public:
    /// @param width of the groove, by the length of the box
    explicit CreaseMap(const Box& box, double width = 0.006)
        : m_box(box)
        , m_width(width * box.sizes().x())
    {
    }
    double featureSize() const override { return 0.5 * m_width; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const Vec3 size = m_box.sizes();
        const double x = (point.x() - m_box.center().x()) / m_width;
        const double up = (point.z() - m_box.min().z()) / size.z();
        return point - Vec3(0, 0, 0.4 * size.z() * up * up * std::exp(-x * x));
    }

private:
    Box m_box;
    double m_width; ///< [m]
};

/// What lies on itself is no fold that faces could not follow.
void ExporterTest::facesFollowACrease()
{
    const Model model = example("bar.step");
    ExportJob job = jobOf(model, nullptr);
    job.parts.front().map = std::make_shared<CreaseMap>(boxOf(model));
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    const PartExportReport& part = file.report.parts.front();
    QVERIFY2(part.form == PartExportReport::Form::exact, part.reason.english().c_str());
    QVERIFY(part.isSound() && part.facesAfter == part.facesBefore);
    QVERIFY(part.maxTolerance < part.tolerance); // edges follow the groove, too
    QVERIFY(isFoldSaid(part) && !part.crossesItself);
}

/// Waves in the middle of the top of a body, too short for a smooth surface to follow.
class WavesMap final : public maps::PointMap {
public:
    explicit WavesMap(const Box& box)
        : m_box(box)
    {
    }
    double featureSize() const override { return 0.05 * m_box.sizes().x(); }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const Vec3 share = (point - m_box.center()).cwiseQuotient(m_box.sizes()); // -.5 .. .5
        const double inside = bump(2.5 * share.x()) * bump(2.5 * share.y()) * bump(share.z() - 0.5);
        const double waves = std::sin(4001 * share.x()) * std::sin(977 * share.y());
        return point +
               Vec3(0, 0.02 * m_box.sizes().y() * share.x() * share.x(), 0.0118 * m_box.sizes().z() * inside * waves);
    }

private:
    /// 1 at 0, and 0 from 1 on.
    static double bump(double x) { return std::abs(x) < 1 ? std::pow(1 - x * x, 3) : 0; }

    Box m_box;
};

/// One face that cannot be followed costs no other its smoothness.
void ExporterTest::aFaceThatIsFarOffIsFlatAlone()
{
    const Model model = example("bar.step");
    ExportJob job = jobOf(model, nullptr);
    job.parts.front().map = std::make_shared<WavesMap>(boxOf(model));
    job.parts.front().part.faces[0].color = Color{1, 0, 0};
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    const PartExportReport& part = file.report.parts.front();
    QVERIFY2(part.form == PartExportReport::Form::exact, part.reason.english().c_str());
    QCOMPARE(part.flatFaces, 1);
    QVERIFY(part.valid && part.closed && part.freeEdges == 0 && part.colorsKept);
    QVERIFY(part.largestDeviation <= part.tolerance);
    QVERIFY(part.largestFlatDeviation > 0 && part.largestFlatDeviation <= part.flatTolerance);
    QVERIFY(part.facesAfter > 100);
    const auto said = std::ranges::find_if(part.remarks, [](const knead::Message& remark) {
        return remark.english().find(" is made of flat triangles; its other faces are smooth.") != std::string::npos;
    });
    QVERIFY(said != part.remarks.end());
    QVERIFY2(part.reason.english().find("mm off the skin where") != std::string::npos, part.reason.english().c_str());
    QVERIFY(part.isSound());
    // Five of the six are one face still.
    const Model back = readBack(file, "step");
    std::map<std::uint32_t, int> triangles;
    for (const std::uint32_t face : back.parts.front().mesh.faceOfTriangle)
        ++triangles[face];
    const auto whole = std::ranges::count_if(triangles, [](const auto& face) { return face.second > 1; });
    QVERIFY2(whole >= 4 && whole <= 6, qPrintable(QString::number(whole)));
}

/// Faces that miss what they stand for by more than a nuance are no result, sound as the solid may be.
void ExporterTest::facesThatAreFarOffAreFlatOnes()
{
    const Model model = example("bar.step");
    ExportJob job = jobOf(model, nullptr);
    job.parts.front().map = std::make_shared<CreaseMap>(boxOf(model), 0.0003);
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    const PartExportReport& part = file.report.parts.front();
    QCOMPARE(part.form, PartExportReport::Form::faceted);
    QVERIFY2(part.reason.english().find("mm off the skin where") != std::string::npos, part.reason.english().c_str());
}

/// The bar's ends are bent past each other, through one another: its faces follow, and no one is told that they are sound.
void ExporterTest::surfacesThatPassThroughThemselvesAreNamed()
{
    const Model model = example("bar.step");
    const maps::Bend bend(boxOf(model), 2.3 * std::numbers::pi);
    const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, &bend, 60), TaskControl::none());
    const PartExportReport& part = file.report.parts.front();
    QVERIFY2(part.form == PartExportReport::Form::exact, part.reason.english().c_str());
    QVERIFY(part.closed && part.valid && part.freeEdges == 0 && part.isFit());
    QVERIFY(part.crossesItself && !part.isSound());
    QCOMPARE(part.remarks.size(), std::size_t{1});
    QVERIFY2(part.remarks.front().english().find("passes through itself near (") != std::string::npos,
             part.remarks.front().english().c_str());
}

/// The chords of a wavy wall and of the plane above it overlap beside their edge, as deep as they leave the curve.
void ExporterTest::chordsBesideAnEdgeAreNoCrossing()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("blob.brep").toStdString();
    QVERIFY(BRepTools::Write(hard_shapes::pushed(hard_shapes::blob(7, 1.5), 6), path.c_str()));
    const Model model = importFile(path);
    for (const auto& [angle, cells] : {std::pair(0.05, 10.0), std::pair(0.6, 16.0)}) {
        const maps::Bend bend(boxOf(model), angle * std::numbers::pi);
        const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, &bend, cells), TaskControl::none());
        QVERIFY(!file.report.parts.front().crossesItself && file.report.isSound());
    }
}

/// A cavity whose bottom is level with the shoulder around the stem below it: walls that meet along a line at rest meet there after
/// it, too, and their triangles reach through each other by rounding.
void ExporterTest::wallsThatTouchAtRestDoNotCross()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("piston.brep").toStdString();
    const auto drum = [](double from, double radius, double height) {
        return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, from), gp_Dir(0, 0, 1)), radius, height).Shape();
    };
    const auto shellOf = [](const TopoDS_Shape& solid) { return TopExp_Explorer(solid, TopAbs_SHELL).Current(); };
    TopoDS_Solid piston;
    const BRep_Builder builder;
    builder.MakeSolid(piston);
    builder.Add(piston, shellOf(BRepAlgoAPI_Fuse(drum(0, 37.5, 127), drum(-20, 16, 20)).Shape()));
    builder.Add(piston, shellOf(drum(0, 16, 50)).Reversed());
    QVERIFY(BRepTools::Write(piston, path.c_str()));
    const Model model = importFile(path);
    QVERIFY(model.parts.size() == 1 && model.parts.front().canBeFilled());
    for (const double angle : {0.05, 0.2}) {
        const maps::Bend bend(boxOf(model), angle * std::numbers::pi);
        const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, &bend), TaskControl::none());
        QVERIFY(!file.report.parts.front().crossesItself);
        QVERIFY(file.report.isSound());
    }
}

/// OpenCASCADE takes what is in the hole for the face; so its faces come in two.
void ExporterTest::boredBallsAreReadByOthersToo()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("ball.brep").toStdString();
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0.1, 0.3)), 1.5, 16).Shape();
    QVERIFY(BRepTools::Write(hard_shapes::cut(BRepPrimAPI_MakeSphere(5).Shape(), drill), path.c_str()));
    const Model model = importFile(path);
    const maps::Bend bend(boxOf(model), 0.2 * std::numbers::pi);
    const ExportedFile file = exportCad(FormatKind::Step, jobOf(model, &bend), TaskControl::none());
    QVERIFY(file.report.isSound());
    const std::string written = folder.filePath("ball.step").toStdString();
    std::ofstream(written, std::ios::binary) << file.bytes;
    STEPControl_Reader other;
    QCOMPARE(other.ReadFile(written.c_str()), IFSelect_RetDone);
    other.TransferRoots();
    GProp_GProps properties;
    BRepGProp::VolumeProperties(other.OneShape(), properties, 1e-5);
    QVERIFY(std::abs(1e-9 * properties.Mass() / file.report.parts.front().volume - 1) < 1e-3);
}

void ExporterTest::igesKeepsNames()
{
    Model model = example("bracket.step");
    model.parts[0].name = "Left angle bracket, the long one";
    model.parts[1].name = "Bushing 2 (bronze)";
    for (std::size_t i = 0; i < 2; ++i) {
        PartNode& node = model.tree.children.size() == 2 ? model.tree.children[i] : model.tree.children[0].children[i];
        QCOMPARE(node.part, std::optional(i));
        node.name = model.parts[i].name;
    }
    const ExportedFile file = exportCad(FormatKind::Iges, jobOf(model, nullptr), TaskControl::none());
    const Model back = readBack(file, "iges");
    QCOMPARE(back.parts.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(QString::fromStdString(back.parts[i].name), QString::fromStdString(model.parts[i].name));
        QVERIFY(std::abs(back.parts[i].volume - model.parts[i].volume) < 1e-6 * model.parts[i].volume);
        QVERIFY(file.report.parts[i].nameKept);
    }
}

/// More waves along a body than splines of a reasonable size can follow.
class RippleMap final : public maps::PointMap {
public:
    RippleMap(const Box& box, double height)
        : m_length(box.sizes().x() / 400)
        , m_height(height)
    {
    }
    double featureSize() const override { return 0.25 * m_length; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        return point + Vec3(0, 0, m_height * std::sin(2 * std::numbers::pi * point.x() / m_length));
    }

private:
    double m_length; ///< of a wave [m]
    double m_height; ///< [m]
};

/// Faces that are a little off stay smooth; the report has one number for how far, names them, and calls nothing sound.
void ExporterTest::facesThatAreNotFollowedAreNamed()
{
    const Model model = example("bar.step");
    ExportJob job = jobOf(model, nullptr);
    job.parts.front().map = std::make_shared<RippleMap>(boxOf(model), 5e-5);
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    const PartExportReport& part = file.report.parts.front();
    QVERIFY2(part.form == PartExportReport::Form::exact, part.reason.english().c_str());
    QVERIFY(part.valid && part.closed && part.largestDeviation > part.tolerance && part.largestDeviation < 2e-4);
    QVERIFY(!part.isFit() && !part.isSound());
    const auto named = std::find_if(part.remarks.begin(), part.remarks.end(), [&](const knead::Message& remark) {
        return remark.english().starts_with("\"" + part.name + "\": ") &&
               remark.english().find("aimed at") != std::string::npos;
    });
    QVERIFY(named != part.remarks.end());
    const QString off = QString::asprintf("is %.3g mm off", 1e3 * part.largestDeviation);
    QVERIFY2(named->english().find(off.toStdString()) != std::string::npos, named->english().c_str());
}

void ExporterTest::jobsAndReportsSurviveTheirWay()
{
    const Model model = example("bracket.step");
    const maps::Bend bend(boxOf(model), 0.4);
    ExportJob job = jobOf(model, &bend);
    job.options = {.unit = "inch", .tolerance = 1e-5, .useAp214 = true, .isText = true};
    job.parts[0].reason = knead::Message("Export", "because of %1").with(knead::Message("Export", "that"));
    job.parts[0].remarks = {knead::Message("Export", "%1 remarks").with(2),
                            knead::Message::verbatim("and another one")};
    const ExportJob arrived = jobFromBytes(jobToBytes(job));
    QCOMPARE(arrived.options.unit, job.options.unit);
    QCOMPARE(arrived.options.tolerance, job.options.tolerance);
    QVERIFY(arrived.options.useAp214);
    QCOMPARE(arrived.parts.size(), job.parts.size());
    QCOMPARE(arrived.parts[0].reason, job.parts[0].reason);
    QCOMPARE(arrived.parts[0].remarks, job.parts[0].remarks);
    QCOMPARE(arrived.parts[1].density, job.parts[1].density);
    QVERIFY(arrived.parts[0].displacements == job.parts[0].displacements);
    QVERIFY(arrived.parts[0].aggregate->lattice.nodes == job.parts[0].aggregate->lattice.nodes);
    QCOMPARE(arrived.parts[0].part.name, job.parts[0].part.name);
    QCOMPARE(*arrived.parts[1].part.exact->bytes, *job.parts[1].part.exact->bytes);
    const std::string bytes = jobToBytes(job);
    for (std::size_t length = 0; length < bytes.size(); length += bytes.size() / 50)
        QVERIFY_EXCEPTION_THROWN(jobFromBytes(std::string_view(bytes).substr(0, length)), std::runtime_error);

    ExportReport report = exportCad(FormatKind::Step, arrived, TaskControl::none()).report;
    report.file = "/home/ann/out.step";
    report.warnings = {knead::Message::verbatim("one"), knead::Message("Export", "number %1").with(2)};
    const ExportReport handed = exportedFromBytes(exportedToBytes({"STEP", report})).report;
    QCOMPARE(handed.warnings, report.warnings);
    QCOMPARE(linesOf(handed), linesOf(report));
    const ExportReport back = reportFromJson(reportToJson(report));
    QCOMPARE(back.warnings.back(), knead::Message::verbatim("number 2"));
    QCOMPARE(reportToJson(back), reportToJson(report));
    QCOMPARE(linesOf(back), linesOf(report));
}

void ExporterTest::nothingToExportIsRefused()
{
    QVERIFY_EXCEPTION_THROWN(exportCad(FormatKind::Step, {}, TaskControl::none()), std::runtime_error);
}

QTEST_GUILESS_MAIN(ExporterTest)
#include "exporter_test.moc"
