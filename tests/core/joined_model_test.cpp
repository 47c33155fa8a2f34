#include "core/model/joined_model.h"

#include "core/model/added_model.h"
#include "core/model/part_tree.h"

#include <QtTest>

using namespace knead;

namespace {

Model modelOf(const std::string& name, const std::string& unit)
{
    Model model;
    model.file = "/home/ann/" + name + ".step";
    model.format = "STEP AP214";
    model.unit = unit;
    model.warnings = {Message::verbatim(name + " is odd.")};
    model.parts.resize(2);
    model.parts[0].path = "pin";
    model.parts[1].path = "frame/nut";
    model.tree = {name, std::nullopt, {{"pin", 0, {}}, {"frame", std::nullopt, {{"nut", 1, {}}}}}};
    return model;
}

} // namespace

class JoinedModelTest : public QObject {
    Q_OBJECT
private slots:
    void oneModelStaysAsItIs()
    {
        const Model model = joined({modelOf("a", "mm")});
        QCOMPARE(model.tree.name, std::string("a"));
        QCOMPARE(model.parts[0].path, std::string("pin"));
    }

    void eachFileIsANodeAndKeepsItsParts()
    {
        Model doubtful = modelOf("b", "mm");
        doubtful.unitRemark = UnitRemark{Message::verbatim("b is large."), "mm"};
        doubtful.missing = {Message::verbatim("\"lid\" was left out.")};
        const Model model = joined({modelOf("a", "mm"), doubtful});
        QCOMPARE(model.format, std::string("STEP AP214"));
        QCOMPARE(model.unit, std::string("mm"));
        QCOMPARE(model.parts.size(), std::size_t{4});
        QCOMPARE(model.parts[3].path, std::string("b/frame/nut"));
        QCOMPARE(model.tree.children.size(), std::size_t{2});
        QCOMPARE(model.tree.children[1].children[1].children[0].part.value(), std::size_t{3});
        QCOMPARE(model.warnings.size(), std::size_t{3}); // the doubt is one
        QCOMPARE(model.warnings[2].english(), std::string("b is large. Open that file alone to correct it."));
        QVERIFY(!model.unitRemark);
        QCOMPARE(model.missing.size(), std::size_t{1});
    }

    /// Parts that were there keep their numbers and paths; the same file twice has another name.
    void addedPartsComeBehindTheOthers()
    {
        Model once = withAdded(modelOf("a", "mm"), modelOf("b", "inch"));
        QCOMPARE(once.parts.size(), std::size_t{4});
        QCOMPARE(once.parts[0].path, std::string("pin"));
        QCOMPARE(once.parts[3].path, std::string("b/frame/nut"));
        QCOMPARE(once.tree.children.size(), std::size_t{3});
        QCOMPARE(once.tree.children[2].children[1].children[0].part.value(), std::size_t{3});
        QCOMPARE(once.unit, std::string("mm"));
        QCOMPARE(once.warnings.size(), std::size_t{2});
        for (const char* name : {"b", "pin"}) // a child of the root, and a part
            QCOMPARE(withAdded(once, modelOf(name, "mm")).parts[4].path, std::string(name) + " 2/pin");
        QCOMPARE(withAdded(once, modelOf("frame", "mm")).tree.children[3].name, std::string("frame 2"));
    }

    /// Pieces of hidden parts are hidden, added ones as their file says, whatever was hidden before.
    void whatIsHiddenStaysSo()
    {
        const Model before = modelOf("a", "mm");
        Model after = before;
        after.parts.emplace_back().path = "frame/nut/nut (2)"; // a piece
        after.parts.back().visible = false;                    // as its file had it; a person may show it
        after = withAdded(std::move(after), modelOf("pin", "mm"));
        after.parts[4].visible = false;
        QCOMPARE(stillHidden({}, before, after), (std::set<std::size_t>{4}));
        QCOMPARE(stillHidden({0, 1}, before, after), (std::set<std::size_t>{0, 1, 2, 4}));
        Model twins = modelOf("a", "mm");
        twins.parts[0].path = twins.parts[1].path = "bolt"; // two of one name, of which the second is broken
        Model broken = twins;
        broken.parts.emplace_back().path = "bolt/bolt (2)";
        QCOMPARE(stillHidden({1}, twins, broken), (std::set<std::size_t>{1, 2}));
    }

    void whatDiffersIsLeftOpen() { QVERIFY(joined({modelOf("a", "mm"), modelOf("b", "inch")}).unit.empty()); }
};

QTEST_GUILESS_MAIN(JoinedModelTest)
#include "joined_model_test.moc"
