#include "app/describe/completions.h"

#include <sstream>

namespace knead {

namespace {

std::string bashOptionNames(const CommandWords& command)
{
    std::string names;
    for (const OptionWords& option : command.options)
        for (const std::string& name : option.names)
            names += (names.empty() ? "" : " ") + name;
    return names;
}

std::string bashCommandNames(const CommandWords& program)
{
    std::string names;
    for (const CommandWords& command : program.commands)
        names += (names.empty() ? "" : " ") + command.name;
    return names;
}

/// What is offered for a value; empty: what is offered where no option stands before, files.
std::string bashOffer(const ValueWords& value)
{
    switch (value.kind) {
    case ValueWords::Kind::none:
    case ValueWords::Kind::file:
        return {};
    case ValueWords::Kind::folder:
        return "_knead_offer -d";
    case ValueWords::Kind::text:
        return ":";
    case ValueWords::Kind::choice:
        break;
    }
    std::string words;
    for (const std::string& choice : value.choices)
        words += (words.empty() ? "" : " ") + choice;
    return "_knead_offer -W '" + words + "'";
}

/// Cases for what stands before the word: "run:--out) _knead_offer -d; return ;;".
void addBashValues(std::ostream& out, const CommandWords& command)
{
    for (const OptionWords& option : command.options)
        for (const std::string& name : option.names)
            if (const std::string offer = bashOffer(option.value); !offer.empty())
                out << "        " << command.name << ':' << name << ") " << offer << "; return ;;\n";
}

} // namespace

std::string bashCompletionOf(const CommandWords& program)
{
    std::ostringstream out;
    out << "# Completions of knead for bash, made from its command line.\n\n"
           "_knead_offer()\n{\n"
           "    mapfile -t COMPREPLY < <(compgen \"$@\" -- \"${COMP_WORDS[COMP_CWORD]}\")\n}\n\n"
           "_knead()\n{\n"
           "    local command= options='"
        << bashOptionNames(program)
        << "' word=${COMP_WORDS[COMP_CWORD]}\n"
           "    ((COMP_CWORD > 1)) && command=${COMP_WORDS[1]}\n"
           "    case $command:${COMP_WORDS[COMP_CWORD - 1]} in\n";
    for (const CommandWords& command : program.commands)
        addBashValues(out, command);
    out << "    esac\n    case $command in\n";
    for (const CommandWords& command : program.commands)
        out << "        " << command.name << ") options='" << bashOptionNames(command) << "' ;;\n";
    out << "    esac\n"
           "    if [[ $word == -* ]]; then\n"
           "        _knead_offer -W \"$options\"\n"
           "    elif ((COMP_CWORD == 1)); then\n"
           "        compopt -o filenames 2>/dev/null\n"
           "        _knead_offer -f -W '"
        << bashCommandNames(program)
        << "'\n"
           "    else\n"
           "        compopt -o filenames 2>/dev/null\n"
           "        _knead_offer -f\n"
           "    fi\n}\n\n"
           "complete -F _knead knead\n";
    return out.str();
}

} // namespace knead
