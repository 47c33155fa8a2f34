#include "fuzz/targets.h"
#include "io/project/command_json.h"
#include "support/sample_project.h"

namespace knead::fuzz {

namespace {

const ToolPartTable& tools()
{
    static const ToolPartTable table = [] {
        ToolPartTable all;
        commandsToJson(sample::commands(sample::toolPart(0.02)), all);
        return all;
    }();
    return table;
}

std::vector<RecordedCommand> commandsIn(const std::string& text)
{
    std::size_t longList = 1'000'000;
    return commandsFromJson(text, "commands", tools(), longList);
}

std::string textOf(const std::vector<RecordedCommand>& commands)
{
    ToolPartTable all = tools();
    return commandsToJson(commands, all);
}

std::vector<std::string> commandTexts()
{
    std::vector<RecordedCommand> all;
    for (const RecordedCommand& command : sample::commands(sample::toolPart(0.02)))
        all.push_back(command);
    ToolPartTable known;
    std::vector<std::string> texts{commandsToJson(all, known)};
    for (const RecordedCommand& command : all) {
        ToolPartTable one;
        texts.push_back(commandsToJson(std::vector<RecordedCommand>{command}, one));
    }
    return texts;
}

bool readCommands(std::string_view bytes)
{
    return isTaken([&] { requireSameBack(commandsIn(std::string(bytes)), textOf, commandsIn); });
}

} // namespace

Target commandsTarget()
{
    return {commandTexts, readCommands};
}

} // namespace knead::fuzz
