#include "io/project/command_json.h"
#include "support/same_values.h"
#include "support/sample_project.h"

#include <nlohmann/json.hpp>

#include <QtTest>

#include <cmath>
#include <limits>
#include <set>

using namespace knead;
using namespace std::string_literals;

namespace {

std::size_t plenty = 1'000'000'000;

std::vector<RecordedCommand> thereAndBack(const std::vector<RecordedCommand>& commands)
{
    ToolPartTable tools;
    const std::string text = commandsToJson(commands, tools);
    return commandsFromJson(text, "test", tools, plenty);
}

/// What reading a text says; empty when it does not complain.
std::string complaint(const std::string& text)
{
    try {
        commandsFromJson(text, "commands", {}, plenty);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

RecordedCommand gravity(const Vec3& gravity)
{
    return {7, SetGravity{gravity}};
}

} // namespace

class CommandJsonTest : public QObject {
    Q_OBJECT
private slots:
    void everyCommandComesBackToTheLastBit()
    {
        const std::vector<RecordedCommand> commands = sample::commands(sample::toolPart(0.02));
        std::set<std::size_t> kinds;
        for (const RecordedCommand& command : commands)
            kinds.insert(command.command.index());
        QCOMPARE(kinds.size(), std::variant_size_v<Command>); // the sample has all of them
        QVERIFY(same::values(thereAndBack(commands), commands));
        QVERIFY(thereAndBack({}).empty());
    }

    void anyDoubleComesBackToTheLastBit()
    {
        fuzz::Random random(11);
        std::vector<RecordedCommand> commands;
        for (int i = 0; i < 20'000; ++i) {
            Vec3 numbers;
            for (double& number : numbers) {
                number = std::bit_cast<double>(random.next());
                if (std::isnan(number)) // one kind of those is enough
                    number = std::numeric_limits<double>::quiet_NaN();
            }
            commands.push_back(gravity(numbers));
        }
        constexpr double infinity = std::numeric_limits<double>::infinity();
        commands.push_back(gravity(Vec3(infinity, -infinity, -0.0)));
        commands.push_back(gravity(Vec3(9007199254740993.0, 1e22, 123456789012345678.0)));
        QVERIFY(same::values(thereAndBack(commands), commands));
    }

    void anyListOfObjectsComesBack()
    {
        fuzz::Random random(12);
        std::vector<RecordedCommand> commands;
        for (int i = 0; i < 2000; ++i) {
            Renormalize command;
            std::uint32_t object = 0;
            for (std::size_t n = random.below(40); n > 0; --n)
                command.objects.push_back(object += random.chance(70) ? 1U : static_cast<std::uint32_t>(random.next()));
            commands.push_back({0, command});
        }
        commands.push_back({0, Renormalize{0, {0xfffffffeU, 0xffffffffU, 0}}});
        QVERIFY(same::values(thereAndBack(commands), commands));
    }

    void textsOfAnyKindComeBack()
    {
        Fixture fixture{.name = "tab\t quote\" back\\ zero\0 Ümläut 立方体"s};
        const std::vector<RecordedCommand> commands{{0, AddFixture{fixture}}};
        QVERIFY(same::values(thereAndBack(commands), commands));
        fixture.name = "broken \xff utf"; // becomes what can be read, not what cannot
        QCOMPARE(thereAndBack({{0, AddFixture{fixture}}}).size(), std::size_t{1});
    }

    /// As documented: one on a line, SI units with the unit in the key.
    void otherProgramsCanReadThem()
    {
        ToolPartTable tools;
        const std::string text =
            commandsToJson(std::vector<RecordedCommand>{gravity(Vec3(0, 0, -9.81)), gravity(Vec3(0, 0, 0))}, tools);
        QCOMPARE(std::count(text.begin(), text.end(), '\n'), 1);
        const auto json = nlohmann::json::parse(text);
        QCOMPARE(json.at(0).at("step").get<int>(), 7);
        QCOMPARE(json.at(0).at("command").get<std::string>(), std::string("set-gravity"));
        QCOMPARE(json.at(0).at("gravity_m_s2").at(2).get<double>(), -9.81);
    }

    void whatIsWrongIsNamed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* text, const char* words) { QTest::newRow(words) << text << words; };
        row("[{\"step\": 1,\n \"command\" \"x\"}]", "commands: line 2, column 14: ");
        row("{}", "commands: the file must be a list");
        row("[{}]", "commands: [0] must have the key \"step\"");
        row(R"([{"step": 1.5, "command": "set-gravity", "gravity_m_s2": [0, 0, 0]}])",
            "commands: [0].step must be a whole");
        row(R"([{"step": 1, "command": "dance"}])",
            "commands: [0].command must be one of those that this program knows");
        row(R"([{"step": 1, "command": "set-gravity"}])", "commands: [0] must have the key \"gravity_m_s2\"");
        row(R"([{"step": 1, "command": "set-gravity", "gravity_m_s2": [0, 1]}])",
            "commands: [0].gravity_m_s2 must hold 3 numbers");
        row(R"([{"step": 1, "command": "set-gravity", "gravity_m_s2": [0, 1, "fast"]}])",
            "commands: [0].gravity_m_s2[2] must be one of infinity, -infinity, nan");
        row(R"([{"step": 1, "command": "renormalize", "body": 0, "objects": [[5, 2]], "duration_s": 0}])",
            "commands: [0].objects[0] must hold the first and the last");
        row(R"([{"step": 1, "command": "renormalize", "body": 0, "objects": [[0, 4294967295]], "duration_s": 0}])",
            "commands: [0].objects[0] makes a list longer than any");
        row(R"([{"step": 1, "command": "remove-manipulator", "tool": -1}])",
            "commands: [0].tool must be a whole number");
    }

    void whatIsWrongIsNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, words);
        const QString sentence = QString::fromStdString(complaint(text.toStdString()));
        QVERIFY2(sentence.startsWith(words), qPrintable(sentence));
        QVERIFY2(sentence.endsWith('.'), qPrintable(sentence));
    }

    /// Else it could not be written again.
    void aLoadHasAnAreaForEachObject()
    {
        ToolPartTable tools;
        std::string text = commandsToJson(std::vector<RecordedCommand>{{0, AddLoad{sample::load("pull")}}}, tools);
        QCOMPARE(complaint(text), std::string());
        const std::string carried = "\"carried\": [";
        text.insert(text.find(carried) + carried.size(), R"({"share_m2": 1, "area_m2": [0, 0, 1]}, )");
        QVERIFY(complaint(text).find("carried must have one item for each object") != std::string::npos);
    }

    void aToolPartThatIsNotThereIsNamed()
    {
        ToolPartTable tools;
        const std::string text = commandsToJson(sample::commands(sample::toolPart(0.01)), tools);
        QVERIFY(QString::fromStdString(complaint(text)).contains("tool_part must be the number of a tool part"));
    }
};

QTEST_GUILESS_MAIN(CommandJsonTest)
#include "command_json_test.moc"
