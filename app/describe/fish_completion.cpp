#include "app/describe/completions.h"

#include <sstream>

namespace knead {

namespace {

std::string fishQuoted(const std::string& text)
{
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\')
            result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result + '\'';
}

std::string fishValue(const ValueWords& value)
{
    switch (value.kind) {
    case ValueWords::Kind::none:
        return {};
    case ValueWords::Kind::text:
        return " -x";
    case ValueWords::Kind::file:
        return " -r -F";
    case ValueWords::Kind::folder:
        return " -x -a '(__fish_complete_directories)'";
    case ValueWords::Kind::choice:
        break;
    }
    std::string words;
    for (const std::string& choice : value.choices)
        words += (words.empty() ? "" : " ") + choice;
    return " -x -a " + fishQuoted(words);
}

/// @param condition where it may stand
void addFishOption(std::ostream& out, const OptionWords& option, const std::string& condition)
{
    if (option.isPositional())
        return; // files are offered in any case
    out << "complete -c knead -n " << fishQuoted(condition);
    for (const std::string& name : option.names)
        name.starts_with("--") ? out << " -l " << name.substr(2) : out << " -s " << name.substr(1);
    out << fishValue(option.value) << " -d " << fishQuoted(option.help) << '\n';
}

} // namespace

std::string fishCompletionOf(const CommandWords& program)
{
    std::ostringstream out;
    out << "# Completions of knead for fish, made from its command line.\n\n";
    for (const OptionWords& option : program.options)
        addFishOption(out, option, "__fish_use_subcommand");
    for (const CommandWords& command : program.commands)
        out << "complete -c knead -n __fish_use_subcommand -a " << command.name << " -d " << fishQuoted(command.help)
            << '\n';
    for (const CommandWords& command : program.commands)
        for (const OptionWords& option : command.options)
            addFishOption(out, option, "__fish_seen_subcommand_from " + command.name);
    return out.str();
}

} // namespace knead
