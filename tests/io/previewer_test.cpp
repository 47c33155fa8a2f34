#include "io/importer.h"
#include "io/previewer.h"
#include "support/skip.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace knead;

namespace {

std::string example(const std::string& name)
{
    return std::string(KNEAD_RESOURCES) + "/examples/" + name;
}

void addLeaves(const PartNode& node, const std::string& path, std::set<std::string>& leaves)
{
    for (const PartNode& child : node.children) {
        const std::string own = path.empty() ? child.name : path + "/" + child.name;
        if (child.children.empty())
            leaves.insert(own);
        addLeaves(child, own, leaves);
    }
}

std::set<std::string> leavesOf(const PartNode& root)
{
    std::set<std::string> leaves;
    addLeaves(root, {}, leaves);
    return leaves;
}

/// The leaf that a part belongs to. Several bodies of one product are numbered: "frame", "frame (2)"; solids and surfaces of one
/// product may be parts below it.
std::string leafOf(const std::string& path, const std::set<std::string>& leaves)
{
    for (std::string shorter = path; !shorter.empty(); shorter.pop_back())
        if (leaves.contains(shorter) &&
            (shorter == path || path[shorter.size()] == '/' || path.compare(shorter.size(), 2, " (") == 0))
            return shorter;
    return {};
}

} // namespace

class PreviewerTest : public QObject {
    Q_OBJECT
private slots:
    void anAssemblyIsSeenWithoutItsShapes()
    {
        const FilePreview preview = previewFile(example("bracket.step"));
        const Model model = importFile(example("bracket.step"));
        QCOMPARE(preview.format, model.format);
        QCOMPARE(preview.parts, model.parts.size());
        std::size_t faces = 0;
        std::set<std::string> paths;
        for (const Part& part : model.parts) {
            paths.insert(part.path);
            faces += part.faces.size();
        }
        QCOMPARE(leavesOf(preview.tree), paths);
        QVERIFY(preview.solids > 0 && preview.solids <= model.parts.size());
        QVERIFY(preview.faces > 0 && preview.faces <= faces);
        QCOMPARE(preview.size, static_cast<std::uint64_t>(QFileInfo(example("bracket.step").c_str()).size()));
    }

    void whatIsNoPartIsRefusedAsByTheImporter()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("no.step");
        QFile file(path);
        QVERIFY(file.open(QFile::WriteOnly));
        file.write("this is no part");
        file.close();
        QVERIFY_EXCEPTION_THROWN(previewFile(path.toStdString()), std::runtime_error);
    }

    /// The names that a person picks in the preview must be those that the importer gives.
    void pathsAreThoseOfTheImport_data()
    {
        QTest::addColumn<QString>("path");
        if (qEnvironmentVariableIsEmpty("KNEAD_CORPUS")) {
            QTest::newRow("no corpus") << QString();
            return;
        }
        const QDir folder(qEnvironmentVariable("KNEAD_CORPUS") + "/open");
        for (const QFileInfo& file : folder.entryInfoList({"*.step", "*.stp"}, QDir::Files))
            if (file.size() < 1'000'000) // the others take long and show no more
                QTest::newRow(qPrintable(file.fileName())) << file.filePath();
    }

    void pathsAreThoseOfTheImport()
    {
        QFETCH(QString, path);
        if (path.isEmpty())
            KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
        const std::set<std::string> leaves = leavesOf(previewFile(path.toStdString()).tree);
        std::set<std::string> met;
        for (const Part& part : importFile(path.toStdString()).parts) {
            const std::string leaf = leafOf(part.path, leaves);
            QVERIFY2(!leaf.empty(), part.path.c_str());
            met.insert(leaf);
        }
        for (const std::string& leaf : leaves)
            QVERIFY2(met.contains(leaf), leaf.c_str());
    }
};

QTEST_GUILESS_MAIN(PreviewerTest)
#include "previewer_test.moc"
