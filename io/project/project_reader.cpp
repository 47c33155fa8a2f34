#include "io/project/project_reader.h"

#include "core/message/message.h"
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
#include <cmath>
#include <limits>

namespace knead {

namespace {

/// More is no damage, but a file that claims what it never held; the list of it would fill the memory.
constexpr std::size_t mostMissing = 100'000;

std::string_view textOf(const Bytes& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Objects of a body: ascending, and there.
/// @param sentence says that they are not
void checkObjects(const std::vector<ObjectIndex>& objects, const Aggregate& aggregate, const Message& sentence)
{
    const auto isNotAfter = [](ObjectIndex a, ObjectIndex b) { return a >= b; };
    if (std::adjacent_find(objects.begin(), objects.end(), isNotAfter) != objects.end() ||
        (!objects.empty() && objects.back() >= aggregate.size()))
        throw DamagedData(sentence);
}

void checkFixture(const Fixture& fixture, const Scene& scene)
{
    if (fixture.body >= scene.bodies.size())
        throw DamagedData(Message("Project", "a fixture is of a body that is not there"));
    checkObjects(fixture.objects, *scene.bodies[fixture.body].aggregate,
                 Message("Project", "a fixture has objects that are not there"));
}

/// Of a table that files may be without.
bool hasRow(SQLite::Database& database, const TableForm& table, std::int64_t id)
{
    if (!database.tableExists(table.name))
        return false;
    SQLite::Statement statement(database, std::string("SELECT id FROM ") + table.name + " WHERE id = ?");
    statement.bind(1, id);
    return statement.executeStep();
}

std::uint64_t countIn(const Row& row, std::size_t column)
{
    const std::int64_t number = row.integer(column);
    if (number < 0)
        throw DamagedData(Message("Project", "a count is negative"));
    return static_cast<std::uint64_t>(number);
}

} // namespace

ProjectReader::ProjectReader(SQLite::Database& database, const ReadingChoices& choices, TaskControl& control)
    : m_database(database)
    , m_choices(choices)
    , m_control(control)
    , m_budget(std::max<std::uint64_t>(1ULL << 30U, 100 * choices.bytes))
{
}

Project ProjectReader::read()
{
    m_control.report(0, "opening the project");
    readModel();
    m_control.report(0.2, "opening the project");
    readToolParts();
    readStarts();
    m_control.report(0.5, "opening the history");
    readEntries();
    readWords();
    readView();
    readMarks();
    readPanels();
    if (m_choices.withMoments)
        readMoments();
    return std::move(m_project);
}

bool ProjectReader::attempt(const Message& what, const std::function<void()>& read)
{
    m_control.throwIfCancelled();
    try {
        read();
        return true;
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        m_control.throwIfCancelled(); // which SQLite tells as an error
        const Message sentence = Message::verbatim("%1 (%2)").with(what, messageOf(error));
        if (!m_choices.rescues || m_missing.size() >= mostMissing)
            throw DamagedData(sentence);
        m_missing.push_back(sentence);
        return false;
    }
}

/// As the file says; or, when that is lost, as many as there seem to be.
std::int64_t ProjectReader::countOf(const std::string& table)
{
    std::int64_t count = 0;
    const auto tables = projectTables();
    const auto form = std::find_if(tables.begin(), tables.end(), [&](const TableForm& t) { return t.name == table; });
    const auto read = [&] {
        const Row row = rowAt(m_database, "contents", form - tables.begin());
        if (row.text(1) != table)
            throw DamagedData(Message("Project", "rows of the table contents are mixed up"));
        count = row.integer(2);
    };
    if (!attempt(Message("Project", "the number of rows of the table %1").with(table), read))
        attempt(Message("Project", "the table %1").with(table), [&] {
            SQLite::Statement statement(m_database, "SELECT max(id) FROM " + table);
            if (statement.executeStep() && statement.getColumn(0).isInteger())
                count = statement.getColumn(0).getInt64() + 1;
        });
    constexpr std::int64_t smallestRow = 4; // no file has more of them than bytes for them
    return std::clamp<std::int64_t>(count, 0, static_cast<std::int64_t>(m_choices.bytes) / smallestRow);
}

template <class Value>
void ProjectReader::readFields(const std::string& json, const std::string& source, Value& value)
{
    const FieldReader fields(JsonNode::readText(json, source), m_tools, m_longList);
    describe(fields, value);
}

Bytes ProjectReader::blob(std::int64_t id)
{
    return Blobs::read(m_database, id, m_budget, m_control);
}

std::vector<RecordedCommand> ProjectReader::commands(const std::string& json, const std::string& source)
{
    return commandsFromJson(json, source, m_tools, m_longList);
}

void ProjectReader::readModel()
{
    attempt(Message("Project", "the model"), [&] {
        const Row row = rowAt(m_database, "project", 0);
        readFields(row.text(1), "import", m_project.import);
        if (!row.isNull(2))
            m_project.model = std::make_shared<const Model>(modelFromBytes(textOf(blob(row.integer(2)))));
        m_project.current = row.index(3);
    });
}

void ProjectReader::readToolParts()
{
    const std::int64_t count = countOf("tool_parts");
    for (std::int64_t id = 0; id < count; ++id) {
        std::shared_ptr<const ToolPart> part;
        attempt(Message("Project", "tool part %1").with(id), [&] {
            const Row row = rowAt(m_database, "tool_parts", id);
            ToolPartPlace place;
            readFields(row.text(2), "place", place);
            part = toolPartFromBytes(textOf(blob(row.integer(3))), place);
        });
        m_tools.add(std::move(part));
    }
}

void ProjectReader::readStarts()
{
    const std::int64_t count = countOf("starts");
    for (std::int64_t id = 0; id < count; ++id) {
        const auto number = static_cast<std::uint32_t>(m_project.starts.size());
        const bool isWhole =
            attempt(Message("Project", "start state %1").with(id), [&] { m_project.starts.push_back(startAt(id)); });
        m_starts.push_back(isWhole ? std::optional(number) : std::nullopt);
    }
}

ProjectStart ProjectReader::startAt(std::int64_t id)
{
    const Row row = rowAt(m_database, "starts", id);
    ProjectStart start;
    start.model = modelOfStart(id);
    start.deformations = deformationsOfStart(id);
    const std::shared_ptr<const Model>& model = modelOf(m_project, start);
    readFields(row.text(3), "settings", start.scene);
    const std::uint32_t bodies = row.index(1);
    for (std::uint32_t i = 0; i < bodies; ++i) {
        const Row body = rowAt(m_database, "bodies", std::int64_t{row.index(2)} + i);
        if (body.integer(1) != id)
            throw DamagedData(Message("Project", "rows of the table bodies are mixed up"));
        start.partOfBody.push_back(readBody(body, model, start.scene.bodies.emplace_back()));
    }
    for (const Fixture& fixture : start.scene.fixtures)
        checkFixture(fixture, start.scene);
    return start;
}

/// Null: that of the project, as in all files of versions before.
std::shared_ptr<const Model> ProjectReader::modelOfStart(std::int64_t id)
{
    if (m_database.execAndGet("PRAGMA user_version").getInt() < versionWithModels)
        return nullptr;
    const Row row = rowAt(m_database, startModels.name, id);
    if (row.isNull(1))
        return nullptr;
    std::shared_ptr<const Model>& model = m_models[row.integer(1)];
    if (model == nullptr)
        model = std::make_shared<const Model>(modelFromBytes(textOf(blob(row.integer(1)))));
    return model;
}

/// None where a recipe cannot say them, or an earlier version wrote the file.
std::vector<RecipeDeformation> ProjectReader::deformationsOfStart(std::int64_t id)
{
    StartDeformations deformations;
    attempt(Message("Project", "how the parts of start state %1 were deformed").with(id), [&] {
        if (hasRow(m_database, startDeformations, id))
            readFields(rowAt(m_database, startDeformations.name, id).text(1), "deformations", deformations);
    });
    return deformations.all;
}

/// @return the part that it is of
std::size_t ProjectReader::readBody(const Row& row, const std::shared_ptr<const Model>& model, Body& body)
{
    const std::size_t part = row.index(2);
    if (model != nullptr && part >= model->parts.size())
        throw DamagedData(Message("Project", "a body is of a part that is not there"));
    body.name = row.text(3);
    readFields(row.text(4), "material", body.material);
    readFields(row.text(5), "state", body);
    body.aggregate = aggregateAt(row.integer(6));
    if (model != nullptr)
        body.surface = surfaceOf(model, part);
    for (const MaterialRegion& region : body.regions)
        checkObjects(region.objects, *body.aggregate, Message("Project", "a region has objects that are not there"));
    return part;
}

std::shared_ptr<const Aggregate> ProjectReader::aggregateAt(std::int64_t id)
{
    std::shared_ptr<const Aggregate>& aggregate = m_aggregates[id];
    if (aggregate == nullptr) {
        const Row row = rowAt(m_database, "aggregates", id);
        aggregate = std::make_shared<const Aggregate>(aggregateFromBytes(textOf(blob(row.integer(4)))));
    }
    return aggregate;
}

void ProjectReader::readEntries()
{
    const std::int64_t count = countOf("entries");
    for (std::int64_t id = 0; id < count; ++id) {
        const auto number = static_cast<std::uint32_t>(m_project.entries.size());
        const bool isWhole = attempt(Message("Project", "entry %1").with(id), [&] {
            m_project.entries.push_back(entryAt(rowAt(m_database, "entries", id), static_cast<std::uint32_t>(id)));
        });
        m_entries.push_back(isWhole ? std::optional(number) : std::nullopt);
    }
    const std::uint32_t current = m_project.current;
    m_project.current = wholeEntryBefore(current);
    if (current == 0 && m_project.entries.empty())
        return;
    attempt(Message("Project", "which entry was shown"), [&] {
        if (current >= m_entries.size() || !m_entries[current])
            throw DamagedData(Message("Project", "that entry is missing"));
        m_project.current = *m_entries[current];
    });
}

/// What is shown when the entry is missing that was: the last one that was made before it. Parents come first.
std::uint32_t ProjectReader::wholeEntryBefore(std::uint32_t entry) const
{
    for (std::size_t i = std::min<std::size_t>(entry, m_entries.size()); i-- > 0;)
        if (m_entries[i])
            return *m_entries[i];
    return 0;
}

HistoryRecord ProjectReader::entryAt(const Row& row, std::uint32_t number)
{
    const std::uint32_t parent = row.index(1);
    const std::uint32_t start = row.index(2);
    if (number > 0 && parent >= number)
        throw DamagedData(Message("Project", "it follows a later one"));
    if (number == 0 ? parent != 0 : !m_entries[parent].has_value())
        throw DamagedData(Message("Project", "the entry that it follows is missing"));
    if (start >= m_starts.size() || !m_starts[start])
        throw DamagedData(Message("Project", "its start state is missing"));
    HistoryRecord record;
    record.parent = number == 0 ? 0 : *m_entries[parent];
    record.start = *m_starts[start];
    record.name = row.text(3);
    record.wallTime = row.number(4);
    record.commands = commands(row.text(5), "commands");
    record.step = countIn(row, 6);
    record.time = row.number(7);
    record.hash = static_cast<std::uint64_t>(row.integer(8));
    record.isKey = row.integer(9) != 0;
    checkFixtures(record);
    return record;
}

/// The one thing about commands that a simulation takes on trust.
void ProjectReader::checkFixtures(const HistoryRecord& record)
{
    const Scene& scene = m_project.starts[record.start].scene;
    for (const RecordedCommand& recorded : record.commands)
        if (const auto* add = std::get_if<AddFixture>(&recorded.command))
            checkFixture(add->fixture, scene); // loads are checked by the simulation
}

/// An entry without its moment is whole: it follows from an earlier one.
void ProjectReader::readMoments()
{
    for (std::size_t id = 0; id < m_entries.size(); ++id) {
        m_control.report(0.5 + 0.5 * static_cast<double>(id) / static_cast<double>(m_entries.size()),
                         "opening the history");
        if (!m_entries[id])
            continue;
        attempt(Message("Project", "the state of entry %1").with(id), [&] {
            const Row row = rowAt(m_database, "entries", static_cast<std::int64_t>(id));
            if (row.isNull(11))
                return;
            Bytes moment = blob(row.integer(11));
            if (moment.size() != countIn(row, 10))
                throw DamagedData(Message("Project", "it is of another length"));
            m_project.entries[*m_entries[id]].moment = std::make_shared<const Bytes>(std::move(moment));
        });
    }
}

void ProjectReader::readView()
{
    attempt(Message("Project", "the view"), [&] {
        const Row row = rowAt(m_database, "view", 0);
        ProjectView view;
        readFields(row.text(1), "camera", view.camera);
        std::size_t parts = m_project.model == nullptr ? 0 : m_project.model->parts.size();
        for (const auto& [blob, model] : m_models)
            parts = std::max(parts, model == nullptr ? 0 : model->parts.size());
        for (const JsonNode& part : JsonNode::readText(row.text(2), "hidden parts").items())
            if (view.hiddenParts.emplace_back(part.count(std::numeric_limits<std::uint32_t>::max())) >= parts)
                part.failExpecting(Message("Recipe", "must be the number of a part"));
        view.thumbnail = row.bytes(3);
        m_project.view = std::move(view);
    });
}

/// Earlier versions wrote none; and what such a version did to the entries since is what counts.
void ProjectReader::readWords()
{
    bool isThere = false;
    attempt(Message("Project", "what entries are called"), [&] { isThere = m_database.tableExists(entryWords.name); });
    for (std::size_t id = 0; isThere && id < m_entries.size(); ++id)
        attempt(Message("Project", "what entry %1 is called").with(id), [&] {
            if (!m_entries[id] || !hasRow(m_database, entryWords, static_cast<std::int64_t>(id)))
                return;
            const Row row = rowAt(m_database, entryWords.name, static_cast<std::int64_t>(id));
            HistoryRecord& record = m_project.entries[*m_entries[id]];
            try {
                if (Message words = messageFrom(nlohmann::json::parse(row.text(1))); words.english() == record.name)
                    record.words = std::move(words);
            } catch (const nlohmann::json::exception&) {
                throw DamagedData(Message("Project", "it is no sentence"));
            }
        });
}

void ProjectReader::readMarks()
{
    const std::int64_t count = countOf("marks");
    for (std::int64_t id = 0; id < count; ++id)
        attempt(Message("Project", "mark %1").with(id), [&] {
            const Row row = rowAt(m_database, "marks", id);
            const std::uint32_t entry = row.index(1);
            if (entry >= m_entries.size() || !m_entries[entry])
                throw DamagedData(Message("Project", "its entry is missing"));
            m_project.marks.push_back({*m_entries[entry], row.text(2)});
        });
}

void ProjectReader::readPanels()
{
    const std::int64_t count = countOf("panels");
    for (std::int64_t id = 0; id < count; ++id)
        attempt(Message("Project", "what panel %1 kept").with(id), [&] {
            const Row row = rowAt(m_database, "panels", id);
            m_project.panels[row.text(1)] = row.text(2);
        });
}

} // namespace knead
