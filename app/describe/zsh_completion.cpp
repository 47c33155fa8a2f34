#include "app/describe/completions.h"

#include <sstream>
#include <string_view>

namespace knead {

namespace {

/// Within apostrophes, and with these characters escaped for the function that reads it.
std::string zshQuoted(const std::string& text, std::string_view special)
{
    std::string result;
    for (const char c : text) {
        if (special.find(c) != std::string_view::npos)
            result += '\\';
        result += c == '\'' ? "'\\''" : c == '\n' ? " " : std::string(1, c);
    }
    return result;
}

/// ":folder:_files -/", as _arguments has it; empty: it takes none.
std::string zshValue(const ValueWords& value)
{
    const std::string begin = ':' + zshQuoted(value.name.empty() ? "value" : value.name, ":\\") + ':';
    switch (value.kind) {
    case ValueWords::Kind::none:
        return {};
    case ValueWords::Kind::text:
        return begin + ' ';
    case ValueWords::Kind::file:
        return begin + "_files";
    case ValueWords::Kind::folder:
        return begin + "_files -/";
    case ValueWords::Kind::choice:
        break;
    }
    std::string words;
    for (const std::string& choice : value.choices)
        words += (words.empty() ? "" : " ") + choice;
    return begin + '(' + words + ')';
}

/// One specification per name; another name of an option that was given is not offered again.
void addZshOption(std::ostream& out, const OptionWords& option)
{
    if (option.isPositional()) {
        out << " \\\n                '" << (option.isRepeated ? "*" : "") << (option.isRequired ? "" : ":")
            << zshValue(option.value) << '\'';
        return;
    }
    std::string others;
    for (const std::string& name : option.names)
        others += (others.empty() ? "" : " ") + name;
    for (const std::string& name : option.names)
        out << " \\\n                '" << (option.isRepeated ? "*" : '(' + others + ')') << name << '['
            << zshQuoted(option.help, "[]\\") << ']' << zshValue(option.value) << '\'';
}

} // namespace

std::string zshCompletionOf(const CommandWords& program)
{
    std::ostringstream out;
    out << "#compdef knead\n# Completions of knead for zsh, made from its command line.\n\n"
           "_knead()\n{\n"
           "    local curcontext=$curcontext state line\n"
           "    typeset -A opt_args\n"
           "    local -a commands=(\n";
    for (const CommandWords& command : program.commands)
        out << "        '" << command.name << ':' << zshQuoted(command.help, "\\") << "'\n";
    out << "    )\n    _arguments -C";
    for (const OptionWords& option : program.options)
        if (!option.isPositional())
            addZshOption(out, option);
    out << " \\\n                '1: :->first' '*:: :->others'\n"
           "    case $state in\n"
           "        first) _alternative 'commands:command:{_describe command commands}' 'files:file:_files' ;;\n"
           "        others)\n"
           "            case $words[1] in\n";
    for (const CommandWords& command : program.commands) {
        out << "            " << command.name << ")\n                _arguments";
        for (const OptionWords& option : command.options)
            addZshOption(out, option);
        out << "\n                ;;\n";
    }
    out << "            *) _files ;;\n            esac\n            ;;\n    esac\n}\n\n_knead \"$@\"\n";
    return out.str();
}

} // namespace knead
