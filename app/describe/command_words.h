#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace knead {

/// What is taken after a command, or after the name of an option.
struct ValueWords {
    enum class Kind { none, text, file, folder, choice };

    Kind kind = Kind::none;
    std::string name;                   ///< "FOLDER"; empty: it says nothing that the choices do not
    std::vector<std::string> choices{}; ///< of Kind::choice
};

/// An option or an argument of the command line, as its help names it.
struct OptionWords {
    std::vector<std::string> names{}; ///< "-o", "--output"; empty: it is known by its place
    ValueWords value;
    std::string group{}; ///< the title that it stands below in the help
    std::string help{};
    std::string preset{}; ///< its value where nothing is said; empty: none
    bool isRequired = false;
    bool isRepeated = false;

    bool isPositional() const { return names.empty(); }
};

/// A command with all that a person may know of it: what the help leaves out is left out.
struct CommandWords {
    std::string name; ///< "info"; of the program: "knead"
    std::string help;
    std::string footer;
    std::vector<OptionWords> options{}; ///< in the order of the help
    std::vector<CommandWords> commands{};
};

/// What the parser of the command line says of a program or one of its commands. Manual pages and completions are made from it.
CommandWords wordsOf(const CLI::App& command);

} // namespace knead
