#include "core/model/joined_model.h"

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

    void whatDiffersIsLeftOpen() { QVERIFY(joined({modelOf("a", "mm"), modelOf("b", "inch")}).unit.empty()); }
};

QTEST_GUILESS_MAIN(JoinedModelTest)
#include "joined_model_test.moc"
