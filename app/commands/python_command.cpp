#include "app/commands/python_command.h"

#include "app/complaint.h"
#include "app/exit_status.h"

#include <CLI/CLI.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

namespace {

struct PythonOptions {
    std::string script;
    std::vector<std::string> arguments;
};

fs::path ownProgram()
{
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored);
}

/// Where the module lies that belongs to a program: beside it, as in a build tree, else as it is installed in a folder above.
/// @return the folder that Python has to know; empty: it is in neither
fs::path folderWithModule(const fs::path& program)
{
    std::error_code ignored;
    for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
        for (const char* place : {"python", KNEAD_PYTHON_FOLDER})
            if (fs::exists(folder / place / "knead/__init__.py", ignored))
                return folder / place;
    return {};
}

/// That of the system, which the module is made for, or the one that a person says.
std::string pythonOfSystem()
{
    if (const char* chosen = std::getenv("KNEAD_PYTHON"))
        return chosen;
    constexpr const char* usual = "/usr/bin/python3";
    return access(usual, X_OK) == 0 ? usual : "python3";
}

/// Python goes through its own folders after these, so that one that it knows anyway is not put before others.
void letPythonFind(const fs::path& folder)
{
    if (folder == "/usr/lib/python3/dist-packages")
        return;
    const char* known = std::getenv("PYTHONPATH");
    const std::string path = folder.string() + (known != nullptr && *known != 0 ? ':' + std::string(known) : "");
    setenv("PYTHONPATH", path.c_str(), 1);
}

/// Python takes the place of this program: signals, the terminal and the exit status are its own.
int run(const PythonOptions& options)
{
    const fs::path program = ownProgram();
    const fs::path folder = folderWithModule(program);
    if (folder.empty())
        return complain("the module for Python is not there: this program was built without it, for which pybind11 "
                        "and Python's headers are needed.",
                        exit_status::wrongUse);
    letPythonFind(folder);
    setenv("KNEAD_PROGRAM", program.c_str(), 0); // for what the module has done by the program
    std::string python = pythonOfSystem();
    std::string script = options.script;
    std::vector<std::string> arguments = options.arguments;
    std::vector<char*> all{python.data(), script.data()};
    for (std::string& argument : arguments)
        all.push_back(argument.data());
    all.push_back(nullptr);
    execvp(python.c_str(), all.data());
    return complain(python + " cannot be started (" + std::strerror(errno) +
                        "). Install python3, or set KNEAD_PYTHON to where it is.",
                    exit_status::wrongUse);
}

} // namespace

void addPythonCommand(CLI::App& program, std::vector<std::string> scriptArguments, int& exitStatus)
{
    auto options = std::make_shared<PythonOptions>();
    CLI::App* command =
        program.add_subcommand("python", "Run a script with the Python of the system, where it may import knead");
    command->add_option("SCRIPT", options->script, "Script to run, such as knead trace writes")->required();
    command->add_option("ARGUMENT", options->arguments, "What the script is given; all that comes after it");
    command->footer("The exit status is that of the script. KNEAD_PYTHON is another Python than /usr/bin/python3.");
    command->callback([options, taken = std::move(scriptArguments), &exitStatus] {
        options->arguments.insert(options->arguments.end(), taken.begin(), taken.end());
        exitStatus = run(*options);
    });
}

std::vector<std::string> takeScriptArguments(std::vector<std::string>& arguments)
{
    const bool isScript = arguments.size() > 1 && arguments[0] == "python" && !arguments[1].starts_with('-');
    if (!isScript)
        return {};
    std::vector<std::string> taken(arguments.begin() + 2, arguments.end());
    arguments.resize(2);
    return taken;
}

} // namespace knead
