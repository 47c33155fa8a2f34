#include "app/describe/man_page.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace knead {

namespace {

/// A text that troff prints as it is.
std::string asTroff(std::string_view text)
{
    std::string result;
    bool isLineBegin = true;
    for (const char c : text) {
        if (isLineBegin && c == '.')
            result += "\\&";
        switch (c) {
        case '\\':
            result += "\\e";
            break;
        case '-':
            result += "\\-";
            break;
        case '\'':
            result += "\\(aq";
            break;
        case '^':
            result += "\\(ha";
            break;
        case '~':
            result += "\\(ti";
            break;
        case '`':
            result += "\\(ga";
            break;
        default:
            result += c;
        }
        isLineBegin = c == '\n';
    }
    return result;
}

std::string bold(const std::string& text)
{
    return "\\fB" + asTroff(text) + "\\fR";
}

std::string italic(const std::string& text)
{
    return "\\fI" + asTroff(text) + "\\fR";
}

std::string titleOf(std::string name)
{
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
    return asTroff(name);
}

std::string endedWithStop(std::string sentence)
{
    if (!sentence.empty() && sentence.back() != '.')
        sentence += '.';
    return sentence;
}

/// Its first line as such stand in lists of pages: without a stop, and without a capital where that is no abbreviation.
std::string summaryOf(const CommandWords& command)
{
    std::string line = command.help.substr(0, command.help.find('\n'));
    if (line.ends_with('.'))
        line.pop_back();
    if (line.size() > 1 && std::isupper(static_cast<unsigned char>(line[1])) == 0)
        line[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(line[0])));
    return line;
}

std::string pageBegin(const std::string& name, const std::string& summary, const std::string& version)
{
    return ".TH " + titleOf(name) + " 1 \"\" \"Knead " + version + "\" \"Knead\"\n.SH NAME\n" + asTroff(name) +
           " \\- " + asTroff(summary) + '\n';
}

/// How a person writes it: "-o, --output FOLDER", or "FILE".
std::string writtenAs(const OptionWords& option)
{
    if (option.isPositional())
        return italic(option.value.name);
    std::string text;
    for (const std::string& name : option.names)
        text += (text.empty() ? "" : ", ") + bold(name);
    std::string values;
    for (const std::string& choice : option.value.choices)
        values += (values.empty() ? "" : "|") + bold(choice);
    if (values.empty() && !option.value.name.empty())
        values = italic(option.value.name);
    return values.empty() ? text : text + ' ' + values;
}

std::string paragraphOf(const OptionWords& option)
{
    std::string text = ".TP\n" + writtenAs(option) + '\n' + asTroff(endedWithStop(option.help)) + '\n';
    if (!option.preset.empty())
        text += "Without it: " + bold(option.preset) + ".\n";
    if (option.isRequired && !option.isPositional())
        text += "It has to be given.\n";
    return text;
}

std::string usageOf(const std::string& name, const CommandWords& command)
{
    std::string usage = bold(name);
    for (const OptionWords& option : command.options)
        if (!option.isPositional() && option.isRequired)
            usage += ' ' + writtenAs(option);
    usage += " [" + italic("OPTION") + "]...";
    for (const OptionWords& option : command.options)
        if (option.isPositional()) {
            const std::string word = writtenAs(option) + (option.isRepeated ? "..." : "");
            usage += option.isRequired ? ' ' + word : " [" + word + ']';
        }
    return usage + '\n';
}

std::string argumentsOf(const CommandWords& command)
{
    std::string text;
    for (const OptionWords& option : command.options)
        if (option.isPositional())
            text += paragraphOf(option);
    return text.empty() ? text : ".SH ARGUMENTS\n" + text;
}

/// Under the titles that the help has, if there are several.
std::string optionsOf(const CommandWords& command)
{
    std::vector<std::string> groups;
    for (const OptionWords& option : command.options)
        if (!option.isPositional() && std::ranges::find(groups, option.group) == groups.end())
            groups.push_back(option.group);
    std::string text = groups.empty() ? "" : ".SH OPTIONS\n";
    for (const std::string& group : groups) {
        if (groups.size() > 1)
            text += ".SS " + asTroff(group) + '\n';
        for (const OptionWords& option : command.options)
            if (!option.isPositional() && option.group == group)
                text += paragraphOf(option);
    }
    return text;
}

/// What the help ends with; what it says of the exit status is a section that all manual pages have.
std::string endOf(const CommandWords& command)
{
    constexpr std::string_view exitStatus = "Exit status: ";
    if (command.footer.empty())
        return {};
    return command.footer.starts_with(exitStatus)
               ? ".SH EXIT STATUS\n" + asTroff(command.footer.substr(exitStatus.size())) + '\n'
               : ".SH NOTES\n" + asTroff(command.footer) + '\n';
}

} // namespace

std::string manPageOf(const CommandWords& program, const std::string& version)
{
    std::string page = pageBegin(program.name, summaryOf(program), version);
    page += ".SH SYNOPSIS\n" + usageOf(program.name, program) + ".br\n" + bold(program.name) + ' ' + italic("COMMAND") +
            " ...\n";
    page += ".SH DESCRIPTION\n" + asTroff(program.help) + '\n';
    page += argumentsOf(program) + optionsOf(program) + ".SH COMMANDS\n";
    for (const CommandWords& command : program.commands)
        page += ".TP\n" + bold(command.name) + '\n' + asTroff(endedWithStop(command.help)) + "\nSee " +
                bold(program.name + '-' + command.name) + "(1).\n";
    return page + endOf(program);
}

std::string manPageOf(const CommandWords& program, const CommandWords& command, const std::string& version)
{
    std::string page = pageBegin(program.name + '-' + command.name, summaryOf(command), version);
    page += ".SH SYNOPSIS\n" + usageOf(program.name + ' ' + command.name, command);
    page += ".SH DESCRIPTION\n" + asTroff(endedWithStop(command.help)) + '\n';
    page += argumentsOf(command) + optionsOf(command) + endOf(command);
    return page + ".SH SEE ALSO\n" + bold(program.name) + "(1)\n";
}

} // namespace knead
