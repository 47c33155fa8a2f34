#include "io/project/project_tables.h"

#include "io/json/message_json.h"
#include "io/project/aggregate_bytes.h"
#include "io/project/command_json.h"
#include "io/project/deformation_fields.h"
#include "io/project/project_fields.h"
#include "io/project/scene_fields.h"
#include "io/project/schema.h"
#include "io/project/tool_part_bytes.h"
#include "io/worker/model_file.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>

namespace knead {

namespace {

std::span<const std::byte> bytesOf(const std::string& text)
{
    return std::as_bytes(std::span(text));
}

template <class Value>
std::string jsonOf(const Value& value, ToolPartTable& tools)
{
    FieldWriter fields(tools);
    describe(fields, value);
    return fields.take();
}

template <class Value>
std::string jsonOf(const Value& value)
{
    ToolPartTable none;
    return jsonOf(value, none);
}

std::string wordsJson(const Message& message)
{
    return toJson(message).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<RowValue> rowOf(std::int64_t id, const Part& part)
{
    return {id,
            part.name,
            part.path,
            part.layer,
            part.volume,
            part.area,
            static_cast<std::int64_t>(part.faces.size()),
            static_cast<std::int64_t>(part.mesh.triangles.size())};
}

/// Where the rows of a table are counted.
std::int64_t placeOfTable(const std::string& table)
{
    const auto tables = projectTables();
    const auto found = std::find_if(tables.begin(), tables.end(), [&](const TableForm& t) { return t.name == table; });
    return found - tables.begin();
}

} // namespace

ProjectTables::ProjectTables(SQLite::Database& database)
    : m_database(database)
    , m_blobs(database)
{
    for (const TableForm& table : projectTables())
        m_rows[table.name] = 0;
    for (const TableForm& table : {entryWords, startModels, startDeformations}) {
        m_database.exec(table.sql);
        m_database.exec(std::string("DELETE FROM ") + table.name); // a program that does not know it may have left some
    }
}

void ProjectTables::addProject(const Project& project, TaskControl& control)
{
    TaskPortion beginning(control, 0, 0.3);
    m_import = jsonOf(project.import);
    if (project.model != nullptr)
        addModel(*project.model, beginning);
    for (const ProjectStart& start : project.starts)
        addStart(start);
    setCurrent(project.current);
    setView(project.view);
    setMarks(project.marks);
    setPanels(project.panels);
    TaskPortion history(control, 0.3, 1);
    addEntries(project.entries, history);
    finish();
    control.throwIfCancelled();
}

void ProjectTables::addModel(const Model& model, TaskControl& control)
{
    control.report(0, "saving the parts");
    m_model = m_blobs.put(bytesOf(modelToBytes(model)), control);
    for (const Part& part : model.parts)
        putRow(m_database, "parts", rowOf(m_rows["parts"]++, part));
}

void ProjectTables::addStart(const ProjectStart& start)
{
    const std::int64_t id = m_rows["starts"]++;
    const std::int64_t firstBody = m_rows["bodies"];
    for (std::size_t i = 0; i < start.scene.bodies.size(); ++i) {
        const Body& body = start.scene.bodies[i];
        const std::string state = jsonOf(body, m_tools);
        putRow(m_database, "bodies",
               {m_rows["bodies"]++, id, static_cast<std::int64_t>(start.partOfBody.at(i)), body.name,
                jsonOf(body.material), state, numberOf(body.aggregate)});
    }
    const std::string settings = jsonOf(start.scene, m_tools);
    putRow(m_database, "starts", {id, static_cast<std::int64_t>(start.scene.bodies.size()), firstBody, settings});
    putRow(m_database, startModels.name, {id, start.model ? RowValue(numberOf(start.model)) : RowValue()});
    if (start.model && !start.deformations.empty())
        putRow(m_database, startDeformations.name, {id, jsonOf(StartDeformations{start.deformations})});
    addNewToolParts();
}

std::int64_t ProjectTables::numberOf(const std::shared_ptr<const Model>& model)
{
    const auto [place, isNew] = m_models.try_emplace(model, 0);
    if (isNew) {
        place->second = m_blobs.put(bytesOf(modelToBytes(*model)));
        m_database.exec("PRAGMA user_version = " + std::to_string(versionWithModels));
    }
    return place->second;
}

std::int64_t ProjectTables::numberOf(const std::shared_ptr<const Aggregate>& aggregate)
{
    const auto [place, isNew] = m_aggregates.try_emplace(aggregate, m_rows["aggregates"]);
    if (isNew) {
        const std::int64_t blob = m_blobs.put(bytesOf(aggregateToBytes(*aggregate)));
        putRow(m_database, "aggregates",
               {m_rows["aggregates"]++, static_cast<std::int64_t>(aggregate->size()),
                static_cast<std::int64_t>(aggregate->connectionCount()), aggregate->lattice.spacing, blob});
    }
    return place->second;
}

void ProjectTables::addNewToolParts()
{
    std::int64_t& count = m_rows["tool_parts"];
    for (; count < static_cast<std::int64_t>(m_tools.parts().size()); ++count) {
        const ToolPart& part = *m_tools.parts()[static_cast<std::size_t>(count)];
        const std::int64_t blob = m_blobs.put(bytesOf(toolPartMeshToBytes(part)));
        putRow(m_database, "tool_parts",
               {count, static_cast<std::int64_t>(part.mesh().triangles.size()), jsonOf(placeOf(part)), blob});
    }
}

std::string ProjectTables::commandText(std::span<const RecordedCommand> commands)
{
    std::string text = commandsToJson(commands, m_tools);
    addNewToolParts();
    return text;
}

void ProjectTables::addEntries(std::span<const HistoryRecord> entries, TaskControl& control)
{
    const std::uint32_t first = this->entries();
    for (const HistoryRecord& record : entries) {
        Moment& moment = m_moments.emplace_back();
        if (record.moment != nullptr)
            moment = {m_blobs.reserve(record.moment->size()), record.moment->size(), record.moment, true};
        putEntry(this->entries() - 1, record);
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
        control.report(static_cast<double>(i) / static_cast<double>(entries.size()), "saving the history");
        if (entries[i].moment != nullptr)
            m_blobs.put(m_moments[first + i].blob, *entries[i].moment, control);
    }
}

void ProjectTables::replaceEntry(std::uint32_t entry, const HistoryRecord& record)
{
    Moment& moment = m_moments.at(entry);
    const bool isSame = moment.isThere == (record.moment != nullptr) && moment.bytes.lock() == record.moment;
    if (!isSame) {
        if (moment.isThere)
            m_blobs.drop(moment.blob, moment.size);
        moment = {};
        if (record.moment != nullptr)
            moment = {m_blobs.put(*record.moment), record.moment->size(), record.moment, true};
    }
    putEntry(entry, record);
}

void ProjectTables::putEntry(std::uint32_t entry, const HistoryRecord& record)
{
    const Moment& moment = m_moments[entry];
    const auto orNull = [&](auto value) {
        return moment.isThere ? RowValue(static_cast<std::int64_t>(value)) : RowValue();
    };
    putRow(m_database, "entries",
           {std::int64_t{entry}, std::int64_t{record.parent}, std::int64_t{record.start}, record.name, record.wallTime,
            commandText(record.commands), static_cast<std::int64_t>(record.step), record.time,
            static_cast<std::int64_t>(record.hash), std::int64_t{record.isKey}, orNull(moment.size),
            orNull(moment.blob)});
    if (record.words.empty())
        dropRow(m_database, entryWords.name, entry);
    else
        putRow(m_database, entryWords.name, {std::int64_t{entry}, wordsJson(record.words)});
}

void ProjectTables::setCurrent(std::uint32_t entry)
{
    m_current = entry;
    putRow(m_database, "project",
           {std::int64_t{0}, m_import, m_model == 0 ? RowValue() : RowValue(m_model), std::int64_t{m_current}});
    m_rows["project"] = 1;
}

void ProjectTables::setView(const ProjectView& view)
{
    putRow(m_database, "view",
           {std::int64_t{0}, jsonOf(view.camera), listText(view.hiddenParts, wholeText), view.thumbnail});
    m_rows["view"] = 1;
}

void ProjectTables::setMarks(const std::vector<ProjectMark>& marks)
{
    m_database.exec("DELETE FROM marks");
    std::int64_t& id = m_rows["marks"] = 0;
    for (const ProjectMark& mark : marks)
        putRow(m_database, "marks", {id++, std::int64_t{mark.entry}, mark.text});
}

void ProjectTables::setPanels(const std::map<std::string, std::string>& panels)
{
    m_database.exec("DELETE FROM panels");
    std::int64_t& id = m_rows["panels"] = 0;
    for (const auto& [name, json] : panels)
        putRow(m_database, "panels", {id++, name, json});
}

void ProjectTables::finish()
{
    m_rows["entries"] = entries();
    for (const auto& [table, rows] : m_rows)
        if (table != "contents" && table != "blobs")
            putRow(m_database, "contents", {placeOfTable(table), table, rows});
}

} // namespace knead
