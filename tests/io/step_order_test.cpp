#include "io/formats/step/step_order.h"

#include <QtTest>

using namespace knead;

namespace {

const std::string head = "ISO-10303-21;\nDATA;\n#1 = PRODUCT('#9;','',$);\n#2 = CONTEXT(#1);\n#3 = CONTEXT(#1);\n";
const std::string tail = "ENDSEC;\nEND-ISO-10303-21;\n";

/// A colored body, as OpenCASCADE writes it.
std::string style(int number, int context, const std::string& color)
{
    const auto at = [&](int offset) { return '#' + std::to_string(number + offset); };
    return at(0) + " = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(\n    " + at(1) + "),#" +
           std::to_string(context) + ");\n" + at(1) + " = STYLED_ITEM('a;''#" + std::to_string(context) + "',(" +
           at(2) + "),#1);\n" + at(2) + " = COLOUR_RGB('" + color + "',1.);\n";
}

const std::string layer = " = PRESENTATION_LAYER_ASSIGNMENT('top','visible',(#1,#2));\n";

} // namespace

class StepOrderTest : public QObject {
    Q_OBJECT

private slots:
    void anyOrderBecomesOne()
    {
        const std::string one = head + style(4, 2, "red") + style(7, 3, "blue") + "#10" + layer + tail;
        QCOMPARE(withStylesInOrder(head + style(4, 3, "blue") + style(7, 2, "red") + "#10" + layer + tail),
                 withStylesInOrder(one));
        QCOMPARE(withStylesInOrder(withStylesInOrder(one)), withStylesInOrder(one));
    }

    void nothingIsLost()
    {
        const std::string text = withStylesInOrder(head + style(4, 3, "blue") + style(7, 2, "red") + tail);
        QVERIFY(text.starts_with(head) && text.ends_with(tail));
        for (const char* part : {"#4 = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#5),#2);\n",
                                 "#5 = STYLED_ITEM('a;''#2',(#6),#1);\n", "#6 = COLOUR_RGB('red',1.);\n",
                                 "#8 = STYLED_ITEM('a;''#3',(#9),#1);\n", "#9 = COLOUR_RGB('blue',1.);\n"})
            QVERIFY2(text.find(part) != std::string::npos, text.c_str());
    }

    void sharedColorsAreWrittenOnce()
    {
        const std::string second = "#7 = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#8),#2);\n"
                                   "#8 = STYLED_ITEM('',(#6),#1);\n";
        const std::string text = withStylesInOrder(head + style(4, 3, "blue") + second + tail);
        QVERIFY2(text.find("#5 = STYLED_ITEM('',(#6),#1);\n#6 = COLOUR_RGB('blue',1.);\n#7 = MECH") !=
                     std::string::npos,
                 text.c_str());
        QVERIFY2(text.find("#8 = STYLED_ITEM('a;''#3',(#6),#1);\n") != std::string::npos, text.c_str());
    }

    void filesWithoutColorsStayAsTheyAre()
    {
        for (const std::string& text : {std::string(), head, head + tail, std::string("nothing")})
            QCOMPARE(withStylesInOrder(text), text);
    }
};

QTEST_GUILESS_MAIN(StepOrderTest)
#include "step_order_test.moc"
