#include "core/model/part_tree.h"

#include <QtTest>

#include <string>
#include <vector>

using namespace knead;

namespace {

Part part(const std::string& path)
{
    Part result;
    result.path = path;
    result.name = path.substr(path.rfind('/') + 1);
    return result;
}

PartNode treeOf(const std::vector<Part>& parts)
{
    std::vector<const Part*> pointers;
    for (const Part& one : parts)
        pointers.push_back(&one);
    return treeOfPaths(pointers);
}

/// "[a 0, b [c 1]]" for the children of a node.
std::string written(const PartNode& node)
{
    std::string text = "[";
    for (const PartNode& child : node.children) {
        text.append(text.size() > 1 ? ", " : "").append(child.name).append(" ");
        text.append(child.part ? std::to_string(*child.part) : written(child));
    }
    return text + "]";
}

void collectPaths(const PartNode& node, const std::string& above, std::vector<std::string>& paths)
{
    for (const PartNode& child : node.children) {
        const std::string path = above.empty() ? child.name : above + "/" + child.name;
        if (child.part)
            paths.push_back(path);
        collectPaths(child, path, paths);
    }
}

} // namespace

class PartTreeTest : public QObject {
    Q_OBJECT

private slots:
    void pathsBecomeAssemblies_data();
    void pathsBecomeAssemblies();
    void namesMayHaveSlashes();
    void pathsOfTheTreeAreThoseOfTheParts();
    void prunedTreesKeepWhatIsLeft();
    void bodiesKnowTheirFormerPaths();
    void instancesOfOneNameStayApart();
    void productsAreTakenOver();
};

void PartTreeTest::pathsBecomeAssemblies_data()
{
    QTest::addColumn<QStringList>("paths");
    QTest::addColumn<QString>("tree");
    QTest::newRow("nothing") << QStringList{} << "[]";
    QTest::newRow("one part") << QStringList{"bar"} << "[bar 0]";
    QTest::newRow("side by side") << QStringList{"a", "b", "a"} << "[a 0, b 1, a 2]";
    QTest::newRow("an assembly") << QStringList{"box/lid", "box/wall"} << "[box [lid 0, wall 1]]";
    QTest::newRow("deep") << QStringList{"a/b/c/x", "a/b/y", "a/z"} << "[a [b [c [x 0], y 1], z 2]]";
    QTest::newRow("an assembly and a part of one name") << QStringList{"a", "a/b", "a"} << "[a 0, a [b 1], a 2]";
    // What is not beside each other stays in the order of the parts.
    QTest::newRow("interrupted") << QStringList{"a/x", "b/y", "a/z"} << "[a [x 0], b [y 1], a [z 2]]";
}

void PartTreeTest::pathsBecomeAssemblies()
{
    QFETCH(QStringList, paths);
    QFETCH(QString, tree);
    std::vector<Part> parts;
    for (const QString& path : paths)
        parts.push_back(part(path.toStdString()));
    QCOMPARE(QString::fromStdString(written(treeOf(parts))), tree);
}

void PartTreeTest::namesMayHaveSlashes()
{
    Part screw = part("box/screw");
    screw.name = "screw M3/8";
    screw.path = "box/screw M3/8";
    Part alone = part("a");
    alone.name = alone.path = "1/2 inch";
    QCOMPARE(written(treeOf({screw, alone})), std::string("[box [screw M3/8 0], 1/2 inch 1]"));
}

void PartTreeTest::pathsOfTheTreeAreThoseOfTheParts()
{
    const std::vector<std::string> wanted{"m/a/x", "m/a/y", "m/b/x", "c", "m/b/z", "m/d"};
    std::vector<Part> parts;
    for (const std::string& path : wanted)
        parts.push_back(part(path));
    std::vector<std::string> found;
    collectPaths(treeOf(parts), {}, found);
    QCOMPARE(found, wanted);
}

void PartTreeTest::prunedTreesKeepWhatIsLeft()
{
    const PartNode tree = treeOf({part("m/a/x"), part("m/a/y"), part("m/b/x"), part("c")});
    QCOMPARE(written(prunedTree(tree, {true, true, true, true})), written(tree));
    QCOMPARE(written(prunedTree(tree, {false, true, false, true})), std::string("[m [a [y 0]], c 1]"));
    QCOMPARE(written(prunedTree(tree, {false, false, true, false})), std::string("[m [b [x 0]]]"));
    QCOMPARE(written(prunedTree(tree, {false, false, false, false})), std::string("[]"));
}

void PartTreeTest::bodiesKnowTheirFormerPaths()
{
    Part body = part("machine/remote/lid");
    QCOMPARE(formerPath(body), std::string("machine/remote/lid"));
    body.bodyOf = "remote (2)";
    QCOMPARE(formerPath(body), std::string("machine/remote (2)"));
    Part alone = part("remote/lid");
    alone.bodyOf = "remote";
    QCOMPARE(formerPath(alone), std::string("remote"));
    const PartNode tree = treeOf({body, alone, part("c")});
    QVERIFY(tree.children[0].children[0].holdsBodies && tree.children[1].holdsBodies && !tree.holdsBodies);
}

void PartTreeTest::instancesOfOneNameStayApart()
{
    std::vector<Part> parts{part("m/remote/lid"), part("m/remote/base"), part("m/remote/lid"), part("m/remote/base")};
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].bodyOf = i % 2 == 0 ? "remote" : "remote (2)";
    QCOMPARE(written(treeOf(parts)), std::string("[m [remote [lid 0, base 1], remote [lid 2, base 3]]]"));
}

void PartTreeTest::productsAreTakenOver()
{
    PartNode from = treeOf({part("m/bolt"), part("m/bolt"), part("m/nut")});
    from.children[0].product = "machine";
    from.children[0].children[0].product = "M3";
    from.children[0].children[1].product = "M4";
    from.children[0].children[2].partNumber = "P-7";
    PartNode to = treeOf({part("m/nut"), part("m/bolt"), part("m/bolt"), part("m/bolt"), part("else")});
    takeProducts(from, to);
    const std::vector<PartNode>& nodes = to.children[0].children;
    QCOMPARE(to.children[0].product, std::string("machine"));
    QCOMPARE(nodes[0].partNumber, std::string("P-7"));
    QCOMPARE(nodes[1].product, std::string("M3"));
    QCOMPARE(nodes[2].product, std::string("M4"));
    QVERIFY(nodes[3].product.empty() && to.children[1].product.empty());
}

QTEST_APPLESS_MAIN(PartTreeTest)
#include "part_tree_test.moc"
