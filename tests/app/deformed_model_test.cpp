#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/deform_in_child.h"
#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "io/importer.h"
#include "support/shapes.h"

#include <QtTest>

#include <QDir>
#include <QTemporaryDir>

#include <cmath>

using namespace knead;

namespace {

using Deformations = std::shared_ptr<const std::vector<Deformation>>;

constexpr double millimetre = 1e-3;

/// Twice as long along z, from the floor.
Deformations stretched(double factor = 2)
{
    return std::make_shared<const std::vector<Deformation>>(
        std::vector<Deformation>{NumberDeformation{.kind = NumberKind::stretch,
                                                   .axis = Vec3::UnitZ(),
                                                   .side = Vec3::UnitX(),
                                                   .from = 0,
                                                   .to = 200 * millimetre,
                                                   .factor = factor}});
}

/// x + 2 z^2 / 100 mm and the like: what a quadratic field makes of a place.
Vec3 carriedByField(const Vec3& place)
{
    const double curvature = 2 / (100 * millimetre);
    return place + Vec3(curvature * place.z() * place.z(), 0, 0.1 * place.x());
}

Deformations byField()
{
    auto field = std::make_shared<DisplacementField>();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 4; ++k) {
                const Vec3 node = 30 * millimetre * Vec3(i - 1, j - 1, k - 1);
                field->nodes.push_back(node);
                field->displacements.push_back(carriedByField(node) - node);
            }
    return std::make_shared<const std::vector<Deformation>>(
        std::vector<Deformation>{FieldDeformation{.field = std::move(field), .kept = {}}});
}

/// The bracket, its bushing, which is hidden, and a block that is a mesh.
Model assembly()
{
    Model model = importFile(KNEAD_RESOURCES "/examples/bracket.step");
    model.parts.at(1).visible = false;
    model.parts.at(1).layer = "fittings";
    Part block;
    block.name = "Block";
    block.path = "Block";
    block.color = Color{0.1F, 0.6F, 0.2F};
    block.mesh = shapes::moved(shapes::box(10 * millimetre * Vec3(1, 2, 3)),
                               {.position = 15 * millimetre * Vec3::UnitZ(), .rotation = Quaternion::Identity()});
    block.box = massProperties(block.mesh).box;
    block.volume = massProperties(block.mesh).volume;
    block.watertight = block.valid = true;
    model.tree.children.push_back({block.name, model.parts.size(), {}});
    model.parts.push_back(std::move(block));
    return model;
}

std::string outline(const PartNode& node)
{
    std::string text = node.name + (node.part ? "=" + std::to_string(*node.part) : "") + "(";
    for (const PartNode& child : node.children)
        text += outline(child);
    return text + ")";
}

bool isSame(const Part& a, const Part& b)
{
    return a.mesh.vertices == b.mesh.vertices && a.exact->bytes == b.exact->bytes && a.exact->number == b.exact->number;
}

class CancelledAt final : public TaskControl {
public:
    explicit CancelledAt(double fraction)
        : m_fraction(fraction)
    {
    }
    void report(double fraction, std::string_view) override { m_last = fraction; }
    bool isCancelled() const override { return m_last >= m_fraction; }

private:
    double m_fraction;
    double m_last = 0;
};

} // namespace

class DeformedModelTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_temporary;
    Model m_model;

private slots:
    void initTestCase()
    {
        setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
        qputenv("TMPDIR", m_temporary.path().toLocal8Bit());
        m_model = assembly();
    }

    /// Nothing is left behind, however it ended.
    void cleanup() { QVERIFY(QDir(m_temporary.path()).isEmpty()); }

    void namesColorsTreeAndFacesStay()
    {
        const DeformedModel now = deformedModel(m_model, stretched(), {}, writeAndReadInChildren, TaskControl::none());
        QCOMPARE(outline(now.model.tree), outline(m_model.tree));
        QCOMPARE(now.model.parts.size(), m_model.parts.size());
        QCOMPARE(now.model.file, m_model.file);
        for (std::size_t p = 0; p < m_model.parts.size(); ++p) {
            const Part& before = m_model.parts[p];
            const Part& after = now.model.parts[p];
            QCOMPARE(after.name, before.name);
            QCOMPARE(after.path, before.path);
            QCOMPARE(after.layer, before.layer);
            QCOMPARE(after.visible, before.visible);
            QCOMPARE(after.exact.has_value(), before.exact.has_value());
            QCOMPARE(after.faces.size(), before.faces.size());
            QVERIFY(after.color == before.color);
            for (std::size_t f = 0; f < before.faces.size(); ++f)
                QVERIFY(after.faces[f].color == before.faces[f].color);
            QVERIFY(after.watertight && after.valid);
            QVERIFY2(std::abs(after.volume / before.volume - 2) < 1e-4, after.name.c_str());
            QVERIFY(std::abs(after.box.max().z() - 2 * before.box.max().z()) < 1e-4 * before.box.max().z());
        }
        QCOMPARE(now.report.parts.size(), std::size_t(2));
        QVERIFY(now.report.isSound());
    }

    void onlyWhatIsMeantIsDeformed()
    {
        const DeformedModel now =
            deformedModel(m_model, stretched(), {false, true, false}, writeAndReadInChildren, TaskControl::none());
        QVERIFY(isSame(now.model.parts[0], m_model.parts[0]));
        QVERIFY(now.model.parts[2].mesh.vertices == m_model.parts[2].mesh.vertices);
        QVERIFY(std::abs(now.model.parts[1].volume / m_model.parts[1].volume - 2) < 1e-4);
        QCOMPARE(outline(now.model.tree), outline(m_model.tree));
    }

    /// A mesh needs no file, and no process.
    void aMeshIsCarriedByItsTriangles()
    {
        const WriteAndRead none = [](ExportJob, TaskControl&) -> WrittenModel { throw std::logic_error("not needed"); };
        const DeformedModel now = deformedModel(m_model, byField(), {false, false, true}, none, TaskControl::none());
        const Part& block = now.model.parts[2];
        QVERIFY(isWatertight(block.mesh));
        QVERIFY(block.mesh.triangles.size() > 100);
        for (const Vec3& corner : m_model.parts[2].mesh.vertices) {
            double nearest = INFINITY;
            for (const Vec3& vertex : block.mesh.vertices)
                nearest = std::min(nearest, (vertex - carriedByField(corner)).norm());
            QVERIFY(nearest < 1e-9);
        }
        QVERIFY(block.box.contains(carriedByField(m_model.parts[2].mesh.vertices.back())));
        QCOMPARE(block.volume, massProperties(block.mesh).volume);
        QVERIFY(block.area > 0);
    }

    void oneDeformationFollowsTheOther()
    {
        auto both = std::make_shared<std::vector<Deformation>>(*stretched());
        both->push_back(byField()->front());
        const DeformedModel now =
            deformedModel(m_model, both, {false, true, false}, writeAndReadInChildren, TaskControl::none());
        Box expected;
        for (Vec3 vertex : m_model.parts[1].mesh.vertices) {
            vertex.z() *= 2;
            expected.extend(carriedByField(vertex));
        }
        const double slack = 2e-3 * expected.diagonal().norm();
        QVERIFY((now.model.parts[1].box.min() - expected.min()).norm() < slack);
        QVERIFY((now.model.parts[1].box.max() - expected.max()).norm() < slack);
    }

    void cancellingLeavesNothing_data()
    {
        QTest::addColumn<double>("fraction");
        QTest::newRow("at once") << 0.0;
        QTest::newRow("while writing") << 0.4;
        QTest::newRow("while reading") << 0.85;
    }

    void cancellingLeavesNothing()
    {
        QFETCH(double, fraction);
        CancelledAt control(fraction);
        QVERIFY_EXCEPTION_THROWN(deformedModel(m_model, stretched(), {}, writeAndReadInChildren, control), Cancelled);
    }

    void whatIsNoMapIsASentence()
    {
        try {
            deformedModel(m_model, stretched(-1), {}, writeAndReadInChildren, TaskControl::none());
            QFAIL("It was deformed.");
        } catch (const Problem& problem) {
            QVERIFY2(QString(problem.what()).endsWith('.'), problem.what());
        }
    }

    /// A file in which parts are missing changes nothing.
    void partsThatDoNotComeBackAreSaid()
    {
        const WriteAndRead loses = [](ExportJob job, TaskControl& control) {
            WrittenModel written = writeAndReadInChildren(std::move(job), control);
            written.model.parts.pop_back();
            return written;
        };
        try {
            deformedModel(m_model, stretched(), {}, loses, TaskControl::none());
            QFAIL("It was deformed.");
        } catch (const Problem& problem) {
            QVERIFY2(QString(problem.what()).contains("1 of 2 parts"), problem.what());
        }
    }
};

QTEST_GUILESS_MAIN(DeformedModelTest)
#include "deformed_model_test.moc"
