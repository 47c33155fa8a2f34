#include "core/deformation/deformation.h"
#include "core/geometry/surface_distance.h"
#include "core/session/export_jobs.h"
#include "io/export/exporter.h"
#include "io/fields/field_reader.h"
#include "io/importer.h"
#include "support/colored_step.h"
#include "support/quadratic_tets.h"
#include "support/sample_fields.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>

#include <QtTest>

#include <QTemporaryDir>

#include <fstream>

using namespace knead;
using namespace knead::quadratic_tets;

namespace {

constexpr double millimetre = 1e-3;
constexpr double share = 1e-4; // of the size of a part, by which it may be off

/// A part, its mesh, and how it is pushed in CalculiX.
struct Problem3d {
    QString name;
    TopoDS_Shape shape;
    Mesh mesh;
    Loading loading;
};

std::function<bool(const Vec3&)> plane(Eigen::Index axis, double at)
{
    return [=](const Vec3& place) { return std::abs(place[axis] - at) < 1e-6; };
}

Problem3d bar()
{
    Blocks blocks;
    blocks.addBox({0, 0, 0}, {40, 10, 10}, {8, 2, 2});
    return {"bar",
            BRepPrimAPI_MakeBox(40, 10, 10).Shape(),
            std::move(blocks.mesh),
            {plane(0, 0), plane(0, 40), Vec3(0, 15, -50), 1000}};
}

Problem3d bracket()
{
    Blocks blocks;
    blocks.addBox({0, 0, 0}, {5, 20, 5}, {2, 4, 2});
    blocks.addBox({5, 0, 0}, {40, 20, 5}, {10, 4, 2});
    blocks.addBox({0, 0, 5}, {5, 20, 30}, {2, 4, 8});
    ShapeUpgrade_UnifySameDomain unify(
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(40, 20, 5).Shape(), BRepPrimAPI_MakeBox(5, 20, 30).Shape()).Shape());
    unify.Build();
    return {"bracket", unify.Shape(), std::move(blocks.mesh), {plane(0, 40), plane(2, 30), Vec3(20, 10, 0), 2000}};
}

Problem3d plate()
{
    const TopoDS_Shape whole = BRepPrimAPI_MakeBox(gp_Pnt(-30, -30, -2), gp_Pnt(30, 30, 2)).Shape();
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -3), gp_Dir(0, 0, 1)), 8, 6).Shape();
    return {"plate",
            BRepAlgoAPI_Cut(whole, hole).Shape(),
            plateWithHole(60, 8, 4, {32, 6, 2}),
            {plane(0, -30), plane(0, 30), Vec3(2000, 0, 150), 10000}};
}

/// What CalculiX found, and where that takes the skin.
struct Solved {
    Problem3d problem;
    std::string step;
    std::string results;
    std::vector<Vec3> displacements; ///< as its columns say [mm]
    Model model;

    double size() const { return model.parts.front().box.diagonal().norm(); } ///< [m]

    /// Places of the skin at rest and now, by the functions of the elements [m].
    std::vector<std::pair<Vec3, Vec3>> skin() const
    {
        std::vector<std::pair<Vec3, Vec3>> pairs;
        for (const SkinFace& face : skinOf(problem.mesh))
            for (const auto& [a, b] :
                 {std::pair(0.6, 0.2), {0.2, 0.6}, {0.2, 0.2}, {0.5, 0.5}, {1.0, 0.0}, {0.33, 0.33}}) {
                const Vec3 rest = within(face, problem.mesh.nodes, a, b);
                pairs.emplace_back(millimetre * rest, millimetre * (rest + within(face, displacements, a, b)));
            }
        return pairs;
    }
};

ExportedFile morphed(const Model& model, const std::shared_ptr<const DisplacementField>& field, double factor = 1)
{
    ExportJob job = exportJobOf(model, {}, {});
    job.parts.front().deformations = std::make_shared<const std::vector<Deformation>>(
        std::vector<Deformation>{FieldDeformation{.field = field, .factor = factor, .kept = {}}});
    return exportCad(FormatKind::Step, std::move(job), TaskControl::none());
}

/// Behind the head, which has the time in it.
std::string dataOf(const ExportedFile& file)
{
    return file.bytes.substr(file.bytes.find("DATA;"));
}

std::shared_ptr<const DisplacementField> fieldIn(const std::string& path, const FieldChoice& choice = {})
{
    return std::make_shared<const DisplacementField>(readField(path, choice, TaskControl::none()).field);
}

} // namespace

/// What CalculiX finds on quadratic tetrahedra, as smooth parts.
class MorphCalculixTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::map<QString, Solved> m_solved;

private slots:
    void initTestCase()
    {
        for (Problem3d& problem : std::vector{bar(), bracket(), plate()}) {
            Solved solved;
            solved.step = m_folder.filePath(problem.name + ".step").toStdString();
            writeColoredStep(solved.step, problem.name.toStdString(), problem.shape);
            solved.model = importFile(solved.step);
            solved.results = solve(m_folder.path(), problem.name, inputOf(problem.mesh, problem.loading));
            solved.displacements = displacementsIn(solved.results, problem.mesh.nodes.size());
            solved.problem = std::move(problem);
            m_solved.emplace(solved.problem.name, std::move(solved));
        }
    }

    void aPartComesBackWhereTheFieldTakesIt_data()
    {
        QTest::addColumn<QString>("name");
        for (const auto& [name, solved] : m_solved)
            QTest::newRow(qPrintable(name)) << name;
    }

    void aPartComesBackWhereTheFieldTakesIt()
    {
        QFETCH(QString, name);
        const Solved& solved = m_solved.at(name);
        const Part& before = solved.model.parts.front();
        const double allowed = share * solved.size();
        const auto field = fieldIn(solved.results);
        QCOMPARE(field->nodes.size(), solved.problem.mesh.nodes.size());

        const std::shared_ptr<const SmoothMap> map = mapOf(Deformation(FieldDeformation{.field = field, .kept = {}}));
        double moved = 0;
        double mapError = 0;
        for (const auto& [rest, now] : solved.skin()) {
            moved = std::max(moved, (now - rest).norm());
            mapError = std::max(mapError, (map->at(rest) - now).norm());
        }
        QVERIFY(moved > 0.02 * solved.size());
        qInfo("%s: moved by %.3g of its size; map off by %.3g", qPrintable(name), moved / solved.size(),
              mapError / solved.size());
        QVERIFY2(mapError < allowed, qPrintable(QString::number(mapError / solved.size())));

        const ExportedFile file = morphed(solved.model, field);
        QVERIFY(file.report.isSound());
        const std::string path = m_folder.filePath(name + "-now.step").toStdString();
        std::ofstream(path, std::ios::binary) << file.bytes;
        ImportOptions fine;
        fine.linearDeflection = 0.05 * allowed;
        fine.angularDeflection = 0.1;
        const Model model = importFile(path, fine);
        QCOMPARE(model.parts.size(), std::size_t(1));
        const Part& after = model.parts.front();
        const SurfaceDistance surface(after.mesh);
        double partError = 0;
        for (const auto& [rest, now] : solved.skin())
            partError = std::max(partError, surface.nearest(now).distance);
        qInfo("%s: part off by %.3g of its size", qPrintable(name), partError / solved.size());
        QVERIFY2(partError < allowed, qPrintable(QString::number(partError / solved.size())));

        QCOMPARE(after.name, before.name);
        QVERIFY(after.color == before.color && after.watertight && after.valid);
        QCOMPARE(after.faces.size(), before.faces.size());
        for (std::size_t f = 0; f < before.faces.size(); ++f)
            QVERIFY(after.faces[f].color == before.faces[f].color);
        QVERIFY(std::ranges::any_of(after.faces, [](const PartFace& face) { return face.color.has_value(); }));
    }

    /// The other way and back again is nearly where it was: the compensation of a small field.
    void aNegativeFactorGoesTheOtherWay()
    {
        const Solved& solved = m_solved.at("bar");
        const auto field = fieldIn(solved.results);
        const auto map = mapOf(Deformation(FieldDeformation{.field = field, .factor = 1, .kept = {}}));
        const auto back = mapOf(Deformation(FieldDeformation{.field = field, .factor = -1, .kept = {}}));
        for (const auto& [rest, now] : solved.skin())
            QVERIFY((back->at(rest) + map->at(rest) - 2 * rest).norm() < 1e-12);
    }

    void everyFormatGivesTheSameFile_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("content");
        const Solved& solved = m_solved.at("bar");
        const samples::Sample sample{solved.problem.mesh.nodes, solved.displacements};
        const auto row = [](const char* file, const std::string& content) {
            QTest::newRow(file) << file << QByteArray::fromStdString(content);
        };
        row("text.vtk", samples::legacyVtk(sample, "UNSTRUCTURED_GRID", false, false));
        row("bytes.vtk", samples::legacyVtk(sample, "UNSTRUCTURED_GRID", true, true));
        row("appended.vtu", samples::xmlVtk(sample, {.format = "appended"}));
        row("text.msh", samples::gmsh({sample}, false, false));
        row("bytes.msh", samples::gmsh({sample}, true, true));
        row("report.rpt", samples::report({sample}));
        row("table.csv", samples::table(sample, "X [mm],Y [mm],Z [mm],DX [mm],DY [mm],DZ [mm]\n",
                                        [](std::size_t, const Vec3& place, const Vec3& way) {
                                            return samples::triple(place, ",") + "," + samples::triple(way, ",");
                                        }));
    }

    void everyFormatGivesTheSameFile()
    {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        const Solved& solved = m_solved.at("bar");
        const QString path = m_folder.filePath(file);
        write(path, content.toStdString());
        static const std::string expected = dataOf(morphed(solved.model, fieldIn(solved.results)));
        QVERIFY(dataOf(morphed(solved.model, fieldIn(path.toStdString(), {.step = {}, .name = {}, .unit = "mm"}))) ==
                expected);
    }
};

QTEST_GUILESS_MAIN(MorphCalculixTest)
#include "morph_calculix_test.moc"
