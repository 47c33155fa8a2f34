#include "app/trace_services.h"

#include "app/hexadecimal.h"
#include "app/resources.h"
#include "io/material_library.h"
#include "io/trace/python_trace.h"

#include <filesystem>

namespace knead {

namespace {

PythonTraceChoices choicesFor(const std::string& projectPath)
{
    const std::string whole =
        projectPath.empty() ? "" : std::filesystem::absolute(projectPath).lexically_normal().string();
    return {.projectPath = whole, .presets = readMaterials(materialsFile())};
}

std::unique_ptr<SessionTrace> begin(const Project& project, std::uint32_t start, const std::string& projectPath)
{
    return pythonTrace(project, start, choicesFor(projectPath));
}

std::string script(const Project& project, const std::string& projectPath)
{
    return traceScript(project, project.current, projectPath);
}

} // namespace

TraceServices traceServices()
{
    return {.ending = "py", .begin = begin, .script = script};
}

std::string traceScript(const Project& project, std::uint32_t entry, const std::string& projectPath)
{
    const std::string script = pythonTraceOf(project, entry, choicesFor(projectPath));
    return script + "print(sim.state_hash)  # in the session: " + hexadecimal(project.entries.at(entry).hash) + '\n';
}

} // namespace knead
