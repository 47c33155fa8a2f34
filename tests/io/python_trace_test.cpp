#include "io/trace/python_trace.h"

#include "io/trace/python_text.h"
#include "support/sample_project.h"

#include <QRegularExpression>
#include <QtTest>

#include <bit>
#include <cstdlib>

using namespace knead;
namespace py = python_text;

namespace {

const PythonTraceChoices saved{.projectPath = "/home/ann/a \"b\".knead",
                               .presets = {{"clay", "", "", sample::material(2)}}};

RecordedCommand at(std::uint64_t step, Command command)
{
    return {step, std::move(command)};
}

RecordedCommand goingTo(std::uint64_t step, double x)
{
    return at(step, SetManipulatorMotion{0, GoTo{{Vec3(x, 0, 0), Quaternion::Identity()}}});
}

/// Of a session with a tool, after its beginning.
std::unique_ptr<SessionTrace> traceWithTool()
{
    std::unique_ptr<SessionTrace> trace = pythonTrace(sample::project(), 0, saved);
    trace->take();
    return trace;
}

} // namespace

class PythonTraceTest : public QObject {
    Q_OBJECT

private slots:
    void numbersComeBackWithTheSameBits()
    {
        for (const double number :
             {0.0, -0.0, sample::third, sample::tiny, -sample::huge, 0.1, 1e5, 123456789.0, 5e-324}) {
            const std::string text = py::number(number);
            QCOMPARE(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)),
                     std::bit_cast<std::uint64_t>(number));
        }
        QCOMPARE(py::number(std::numeric_limits<double>::infinity()), std::string("float(\"inf\")"));
        QCOMPARE(py::tuple(Vec3(0.1, -0.0, 2)), std::string("(0.1, -0.0, 2)"));
    }

    void textsAreThoseOfPython()
    {
        QCOMPARE(py::text("a \"b\"\n\\"), std::string("\"a \\\"b\\\"\\n\\\\\""));
        QCOMPARE(py::path("/a/\xff.step"), std::string("b\"\\x2f\\x61\\x2f\\xff\\x2e\\x73\\x74\\x65\\x70\""));
        QCOMPARE(py::text("a\u2028b\u2029"), std::string("\"a\\u2028b\\u2029\""));
        QCOMPARE(py::path("/a\u2029b"), std::string("\"/a\\u2029b\""));
        QCOMPARE(py::literal("[\"a\u2028\"]"), std::string("[\"a\\u2028\"]"));
        QCOMPARE(py::list({3, 7, 8, 9, 10, 12, 13}), std::string("[3, *range(7, 11), 12, 13]"));
        QCOMPARE(py::literal("{\"true\": true, \"a\": [false, null, 1e-05], \"b\": \"\\\"true\\\" \\\\\"}"),
                 std::string("{\"true\": True, \"a\": [False, None, 1e-05], \"b\": \"\\\"true\\\" \\\\\"}"));
    }

    void variablesAreNames()
    {
        py::Names names;
        QCOMPARE(names.add("Block 1", "tool"), std::string("block_1"));
        QCOMPARE(names.add("block-1", "tool"), std::string("block_1_2"));
        QCOMPARE(names.add("Fuß", "tool"), std::string("fu"));
        QCOMPARE(names.add("立方体", "body"), std::string("body"));
        QCOMPARE(names.add("2 cm", "tool"), std::string("tool_2_cm"));
        QCOMPARE(names.add("for", "tool"), std::string("for_2"));
        QCOMPARE(names.add("sim", "tool"), std::string("sim_2"));
    }

    /// Each is a call, in order, with all that it says.
    void everyCommandIsTold()
    {
        const Project project = sample::project();
        const std::string text = pythonTraceOf(project, 1, saved);
        const QString all = QString::fromStdString(text);
        const auto begin = all.indexOf("sim.step_to(");
        const QStringList calls = all.mid(begin).split('\n').filter(
            QRegularExpression("^(?!sim\\.step_to|tool_parts)\\w+( = \\w+)?\\.\\w+\\("));
        QCOMPARE(static_cast<std::size_t>(calls.size()) + 1, project.entries[1].commands.size()); // the first at step 0
        const QStringList wanted{
            "sim.set_material(knead.Material(\"clay\"))",
            "sim.set_body_kind(\"glue\")",
            "sim.renormalize(1, objects=[5], duration=0.3333333333333333)",
            "sim.set_gravity((-0.0, 5e-324, -1.7976931348623157e+308))",
            "sim.set_floor(-0.1, friction=0.2, adhesion=3333.333333333333)",
            "sim.set_floor(None, friction=0.3)",
            "turning = sim.add_tool(\"wedge\", (0.01, 0.3333333333333333, 0.3), ",
            "part_2 = sim.carry_out({\"command\": \"add-manipulator\", ",
            "part_2.remove()",
            "part.go_to((",
            "part.follow([(0, (",
            "turning.reshape(\"box\", (1, 2, 3), friction=0.1, speed_limit=0.3)",
            "sim.carry_out({\"command\": \"reshape-manipulator\", ",
            "part.place((",
            " = sim.fix(0, ",
            "grip_a.release()",
            "sim.set_integrator(\"implicit-euler\")",
            "sim.set_pace(\"rough\")",
            "sim.carry_out({\"command\": \"move-fixture\", \"fixture\": 2, ",
            "sim.reset()",
            "sim.keep()",
            "turning.rename(\"left jaw\")",
            "grip_a.rename(\"Fuß\")",
            " = sim.carry_out({\"command\": \"add-fixture\", ",
            "turning_2.move((0, 0, 0), (1, 2, 0.3333333333333333), (0, 0, 5e-324))",
            "sim.carry_out({\"command\": \"add-load\", ",
            "sim.carry_out({\"command\": \"set-load\", ",
            "sim.carry_out({\"command\": \"remove-load\", ",
            "sim.settle(0.3333333333333333)",
            "sim.refill(1, spacing=0.3333333333333333)",
            "sim.cut((0.3333333333333333, -0.0, 1.7976931348623157e+308), (0, 5e-324, 0.3333333333333333), body=1)",
            "sim.carry_out({\"command\": \"set-part-look\", "};
        qsizetype from = begin;
        for (const QString& call : wanted) {
            const qsizetype place = all.indexOf(call, from);
            QVERIFY2(place >= from, qPrintable(call + "\nis not after\n" + all.mid(from, 300)));
            from = place;
        }
        QVERIFY(all.endsWith("  # Push with Block \"1\"\n\n"));
    }

    void theSceneIsToldBefore()
    {
        const std::string text = pythonTrace(sample::project(), 0, saved)->take();
        for (const char* part :
             {"model = knead.read(\"/home/ann/a \\\"b\\\".knead\")\n",
              "fel = knead.fill(model.parts[1], spacing=0.005, material=knead.Material(", ".kind = \"rigid\"\n",
              ".velocity = (1, 0.3333333333333333, 0)\n", ".structural_friction = 0.25\n",
              ".add_region(knead.Material(", "[*range(1, 4), 8], name=\"soft\")\n", "published=True",
              "gravity=(0, -0.0, -9.81), floor=-0.3333333333333333, floor_friction=0.7", "glued=True",
              "mass_scaling_time_step=2e-04", "vicinity=\"median-partition\"", "foot = sim.fix(1, ",
              "tool_parts = knead.tool_parts(\"/home/ann/a \\\"b\\\".knead\")\n"})
            QVERIFY2(text.find(part) != std::string::npos, (part + ("\nis not in\n" + text)).c_str());
    }

    void whatComesOftenIsATable()
    {
        const auto trace = traceWithTool();
        trace->add(std::vector{goingTo(3, 0.1), goingTo(3, 0.2)}, {});
        QCOMPARE(trace->take(), std::string());
        QCOMPARE(trace->ending(7), std::string("sim.step_to(3)\nblock.go_to((0.1, 0, 0), (1, 0, 0, 0))\n"
                                               "block.go_to((0.2, 0, 0), (1, 0, 0, 0))\nsim.step_to(7)\n"));
        trace->add(std::vector{goingTo(8, 0.3)}, {});
        QCOMPARE(trace->take(),
                 std::string("for step, act, *how in [\n    (3, block.go_to, (0.1, 0, 0), (1, 0, 0, 0)),\n"
                             "    (3, block.go_to, (0.2, 0, 0), (1, 0, 0, 0)),\n"
                             "    (8, block.go_to, (0.3, 0, 0), (1, 0, 0, 0)),\n"));
        trace->add(std::vector{at(9, SetManipulatorMotion{0, HoldStill{}}), at(20, KeepMoment{})}, "A drag");
        QCOMPARE(trace->take(), std::string("    (9, block.hold),\n]:\n    sim.step_to(step)\n    act(*how)\n"
                                            "sim.step_to(20)\nsim.keep()  # A drag\n\n"));
        QCOMPARE(trace->ending(20), std::string());
    }

    void namesEndNoComment()
    {
        const auto trace = traceWithTool();
        trace->add(std::vector{at(0, KeepMoment{})}, "a\nb\u2028c\u2029d");
        QCOMPARE(trace->take(), std::string("sim.keep()  # a b c d\n\n"));
    }

    /// Undone: what was there before goes on another way.
    void aCopyGoesOnOnItsOwn()
    {
        const auto trace = traceWithTool();
        trace->add(std::vector{goingTo(1, 0.1)}, {});
        const auto copy = trace->copy();
        trace->add(std::vector{at(2, AddManipulator{sample::manipulator("ball", HoldStill{})}), at(5, Reset{})}, {});
        copy->add(std::vector{at(4, AddManipulator{sample::manipulator("ball", HoldStill{})})}, {});
        QVERIFY(trace->take().ends_with("sim.step_to(5)\nsim.reset()\n"));
        QCOMPARE(trace->ending(2), std::string("sim.step_to(2)\n")); // counted from there
        const std::string other = copy->take();
        QVERIFY2(other.starts_with("sim.step_to(1)\nblock.go_to(") &&
                     other.find("sim.step_to(4)\nball = sim.add_tool(") != std::string::npos,
                 other.c_str());
    }

    void partsThatNoFileHasNeedASavedProject()
    {
        QVERIFY_THROWS_EXCEPTION(Problem, pythonTrace(sample::project(), 0, {}));
        const auto trace = traceWithTool();
        const Manipulator foreign = sample::partManipulator(sample::toolPart(0.07)); // the project does not have it
        QVERIFY_THROWS_EXCEPTION(Problem, trace->add(std::vector{at(0, AddManipulator{foreign})}, {}));
    }
};

QTEST_GUILESS_MAIN(PythonTraceTest)
#include "python_trace_test.moc"
