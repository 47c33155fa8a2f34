#pragma once

#include "core/document/project.h"
#include "io/project/blobs.h"
#include "io/project/json_fields.h"

#include <map>
#include <memory>
#include <span>
#include <string>

namespace knead {

/// Writes a project, or what is added to one, into the tables of a database. Everything throws SQLite::Exception; what the
/// caller's transaction does not commit must not be counted on either: then a new object begins anew.
class ProjectTables {
public:
    /// @pre the tables are there and empty
    explicit ProjectTables(SQLite::Database& database);

    void addProject(const Project& project, TaskControl& control);

    void addStart(const ProjectStart& start);
    /// Their moments lie behind all of their rows, so that of a file that was cut off the histories remain.
    void addEntries(std::span<const HistoryRecord> entries, TaskControl& control);
    /// Another name, or its moment was thinned out or made again.
    void replaceEntry(std::uint32_t entry, const HistoryRecord& record);
    void setCurrent(std::uint32_t entry);
    void setView(const ProjectView& view);
    void setMarks(const std::vector<ProjectMark>& marks);
    void setPanels(const std::map<std::string, std::string>& panels);

    /// Commands as JSON; tool parts that they are the first to use come into their table.
    std::string commandText(std::span<const RecordedCommand> commands);

    /// To be called before each commit: says how many rows there are.
    void finish();

    std::uint32_t entries() const { return static_cast<std::uint32_t>(m_moments.size()); }

private:
    struct Moment {
        std::int64_t blob = 0;
        std::size_t size = 0;
        std::weak_ptr<const Bytes> bytes;
        bool isThere = false;
    };

    void addModel(const Model& model, TaskControl& control);
    std::int64_t numberOf(const std::shared_ptr<const Model>& model);
    std::int64_t numberOf(const std::shared_ptr<const Aggregate>& aggregate);
    void addNewToolParts();
    void putEntry(std::uint32_t entry, const HistoryRecord& record);

    SQLite::Database& m_database;
    Blobs m_blobs;
    std::map<std::string, std::int64_t> m_rows; ///< per table that was written to
    std::map<std::shared_ptr<const Aggregate>, std::int64_t> m_aggregates;
    std::map<std::shared_ptr<const Model>, std::int64_t> m_models; ///< of starts, per blob
    ToolPartTable m_tools;
    std::vector<Moment> m_moments; ///< per entry
    std::string m_import = "{}";
    std::int64_t m_model = 0; ///< blob; 0: none
    std::uint32_t m_current = 0;
};

} // namespace knead
