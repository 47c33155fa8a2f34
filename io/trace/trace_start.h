#pragma once

#include "io/trace/python_text.h"
#include "io/trace/python_trace.h"

#include <memory>
#include <vector>

namespace knead {

/// What a trace begins with.
struct TraceStart {
    std::shared_ptr<const Model> model;
    ProjectStart start;
    std::vector<std::shared_ptr<const ToolPart>> toolParts; ///< that the project keeps
    PythonTraceChoices choices;

    const Aggregate& aggregateOf(BodyId body) const { return *start.scene.bodies.at(body).aggregate; }
    const Part& partOf(BodyId body) const { return model->parts.at(start.partOfBody.at(body)); }
};

/// Lines up to the simulation itself, without its fixtures, tools and loads: they are added next.
/// @throws Problem as pythonTrace()
std::string traceBeginning(const Project& project, const TraceStart& start, python_text::Names& names);

} // namespace knead
